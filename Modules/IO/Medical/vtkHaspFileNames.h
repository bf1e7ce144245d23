#ifndef vtkHaspFileNames_h
#define vtkHaspFileNames_h

#include "vtkHaspIOMedicalModule.h" // for export macro

#include <filesystem> // for paths
#include <string>     // for labels

/// How texts speak of files. Names of files and folders often hold a patient's name, so errors,
/// warnings and logs do not say them: a file is "the .mha file", a slice "file 7", counted from 1
/// in the order of the paths. Whoever sits at the screen may ask for the names. Any thread.
namespace hasp
{

/// For the whole process; false at its start. True: errors say the last part of a path, never
/// its folders.
VTKHASPIOMEDICAL_EXPORT void ShowFileNames(bool shown);
VTKHASPIOMEDICAL_EXPORT bool FileNamesShown();

/// "the .mha file", "the folder", "the file" (unknown ending); with names shown the path's last
/// part, where control characters, marks that turn the direction of writing and bytes that are no
/// UTF-8 are question marks, so that it is safe to print.
VTKHASPIOMEDICAL_EXPORT std::string FileLabel(const std::filesystem::path& path);

} // namespace hasp

#endif
