#pragma once
#include "Pairing.h"
#include "StereoLayout.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkImageData;
class vtkProp;

namespace hasp
{

/// A lens of 23 x 13 mm as a volume, drawn by one mapper: whose outline the stereo report holds
/// against that of a mesh, eye by eye. RENDER thread.
class SilhouetteScene
{
public:
  struct Method
  {
    std::string id, name;
    std::function<vtkSmartPointer<vtkProp>()> make;
    int frames = 1; ///< until a still picture is whole
  };
  /// vtkFlyingEdges3D, what the others are held against.
  static Method Mesh();
  /// Our mappers and VTK's ray caster.
  static std::vector<Method> Methods();

  explicit SilhouetteScene(const Method& method);

  using Outline = std::vector<bool>; ///< pixels that are not background
  /// Of one eye drawn alone (Left, Right), by the eye rig.
  Outline OfEye(StereoLayout eye);
  /// Of both, drawn as a pair: left, right.
  std::array<Outline, 2> OfPair();
  Timing Time() const { return this->Spent; } ///< of the last picture

  /// Of the pixels of `truth`, how many differ.
  static double Share(const Outline& found, const Outline& truth);

private:
  vtkSmartPointer<vtkImageData> Draw(StereoLayout layout);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  int Frames;
  Timing Spent;
};

} // namespace hasp
