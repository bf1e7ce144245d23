#pragma once
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkRenderWindow;

namespace hasp
{

/// A picture of bytes as a PNG file. Throws Failure: CannotDraw. Any thread.
std::string PngFile(vtkImageData* picture);

/// What the window's last frame shows, RGB. RENDER thread.
vtkSmartPointer<vtkImageData> WindowPicture(vtkRenderWindow* window);

} // namespace hasp
