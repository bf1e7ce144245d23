#include "ViewStyle.h"

#include "vtkObjectFactory.h"

namespace hasp
{

vtkStandardNewMacro(ViewStyle);

} // namespace hasp
