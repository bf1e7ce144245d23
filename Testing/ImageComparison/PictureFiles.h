#pragma once
#include "RGBPicture.h"

#include <filesystem>

class vtkRenderWindow;

/// Pictures from files and windows, through VTK. RENDER thread.
namespace hasp
{

/// Throws std::runtime_error if there is no such file, if it is no PNG, or if it is neither 8-bit
/// RGB nor RGBA. Opacity is dropped.
RGBPicture ReadPNG(const std::filesystem::path& file);

/// Throws std::runtime_error if the file cannot be written.
void WritePNG(const RGBPicture& picture, const std::filesystem::path& file);

/// What the window shows; it is rendered first if it never was. Throws std::runtime_error if
/// nothing can be read, as where there is no OpenGL.
RGBPicture GrabWindow(vtkRenderWindow* window);

/// vtkImageDifference's thresholded error as vtkTesting takes it: blind to shade, it sees only that
/// something is drawn about the right place. VTK's tests pass up to 0.15.
double MeasureAsVTKDoes(const RGBPicture& got, const RGBPicture& expected);

} // namespace hasp
