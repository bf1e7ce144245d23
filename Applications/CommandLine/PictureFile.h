#pragma once
#include <string>

class vtkImageData;

namespace hasp
{

/// A picture of bytes as a PNG file. Throws Failure: CannotDraw. Any thread.
std::string PngFile(vtkImageData* picture);

} // namespace hasp
