#ifndef vtkHaspPartLabel_h
#define vtkHaspPartLabel_h

#include "vtkHaspIOMedicalModule.h" // for export macro

#include <string>      // for name and hash
#include <string_view> // for checks

namespace hasp
{

/// What the file of a part says of it, in every format that is written (see
/// Utilities/Docs/Formats.md). Plain values that may be shown: none of them can name a patient.
struct PartLabel
{
  std::string name;         ///< one that IsPartName takes; may be empty
  std::string hash;         ///< of the plan or recipe it was made from: 16 to 64 small hexadecimal
                            ///< digits; may be empty. STL keeps the first 16
  bool doesNotHold = false; ///< its certificate is red, and it was kept all the same

  bool operator==(const PartLabel&) const = default;
};

/// A word of the fixed list guide, plate, implant, transplant, mitre-guide, bone, fragment, group,
/// crumb, segment, reduction, part; with or without a blank and a number of 1 to 6 digits:
/// "fragment 3".
VTKHASPIOMEDICAL_EXPORT bool IsPartName(std::string_view name);

/// Throws std::invalid_argument if name or hash is none that may be written; says which, and not
/// what it holds.
VTKHASPIOMEDICAL_EXPORT void ValidatePartLabel(const PartLabel& label);

} // namespace hasp

#endif
