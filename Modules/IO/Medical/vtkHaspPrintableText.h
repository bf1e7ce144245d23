#ifndef vtkHaspPrintableText_h
#define vtkHaspPrintableText_h

#include "vtkHaspIOMedicalModule.h" // for export macro

#include <string> // for texts

namespace hasp
{

/// Anybody's text, such as a name out of a file, for a terminal whose user asked for names: control
/// characters, marks that turn the direction of writing and bytes that are no UTF-8 become question
/// marks. Any thread.
VTKHASPIOMEDICAL_EXPORT std::string PrintableText(const std::string& text);

} // namespace hasp

#endif
