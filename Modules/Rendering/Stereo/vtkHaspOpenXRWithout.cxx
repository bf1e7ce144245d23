// In place of vtkHaspOpenXR.cxx where HASP_ENABLE_OPENXR is OFF.
#include "vtkHaspOpenXR.h"

#include "vtkVersionMacros.h"

#include <stdexcept>

namespace hasp
{

std::string WhyNoOpenXR()
{
  return "this build of Hasp has no OpenXR output; it takes a VTK >= 9.2 that was built with its "
         "module RenderingOpenXR (this one is " VTK_VERSION "), and HASP_ENABLE_OPENXR=ON";
}

OpenXRView MakeOpenXRView()
{
  throw std::runtime_error(WhyNoOpenXR());
}

} // namespace hasp
