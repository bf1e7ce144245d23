#pragma once
#include "ComparePictures.h"

class vtkRenderWindow;

/// The end of every render test. A test is one function, named as its file:
///
///   int TestPlainScene(int argc, char* argv[])
///   {
///     vtkNew<vtkRenderWindow> window; // needs no display
///     …
///     return hasp::CheckPicture(window, argc, argv);
///   }
///
/// hasp_add_render_test gives it a main() and hands it --baseline FILE --output FOLDER.
namespace hasp
{

/// Compares what the window shows with the baseline picture (or its alternates, TestX_1.png …) by
/// our limits and by VTK's. Prints the figures; a failure also writes FOLDER/TestX.png and
/// FOLDER/TestX.difference.png and names the command that accepts the new picture.
/// Returns EXIT_SUCCESS or EXIT_FAILURE. With --record it compares nothing and writes
/// FOLDER/TestX.png, unless all of the picture has one colour. RENDER thread.
int CheckPicture(vtkRenderWindow* window, int argc, char* argv[], const PictureLimits& limits = {});

/// The same for a picture from elsewhere.
int CheckPicture(
  const RGBPicture& picture, int argc, char* argv[], const PictureLimits& limits = {});

} // namespace hasp
