#pragma once
#include "Evaluation/SortedLayers.h"
#include "Pairing.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <functional>
#include <utility>
#include <vector>

class vtkMapper;
class vtkRenderPass;

namespace hasp
{

/// How translucent surfaces get into a picture.
enum class LayerOrder
{
  Peeled,   ///< VTK's dual depth peeling, until nothing is left
  Weighted, ///< VTK's default: order-independent, by weights of depth (McGuire and Bavoil 2013)
  Unsorted  ///< plain blending, actor after actor, cell after cell
};

/// Balls of clustered cells in each other, each two layers, and two planes of polydata through
/// them; all of opacity 0.5 and without light, so that each layer's colour is known. 200 x 150
/// pixels. RENDER thread.
class LayerPicture
{
public:
  /// layers: 4, 6, 8 ..., in the middle of the picture. Throws std::invalid_argument for others.
  explicit LayerPicture(int layers);

  /// Draws it; what the GPU has to do is done by then.
  Timing Draw(LayerOrder order);

  /// In 1/255 of a channel, over all pixels of the last picture. One whose ray meets other surfaces
  /// a fiftieth of a pixel aside is left out: rounding decides what it shows.
  struct Error
  {
    double largest = 0.0, rms = 0.0;
  };
  Error FindError();

  static constexpr int Width = 200, Height = 150;

private:
  using Ray = std::pair<glm::dvec3, glm::dvec3>; ///< origin, unit direction
  void AddBall(double radius, const glm::dvec3& color);
  void AddPlane(const glm::dvec3& corner, const glm::dvec3& edge1, const glm::dvec3& edge2,
    const glm::dvec3& color);
  void Add(vtkMapper* mapper, const glm::dvec3& color,
    const std::function<std::vector<double>(const Ray&)>& meet);
  std::vector<Layer> LayersAt(const glm::dvec2& pixels) const;
  void FindTruth();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderPass> Plain;
  std::vector<std::function<void(const Ray&, std::vector<Layer>&)>> Surfaces;
  glm::dmat4 ClipToWorld{ 1.0 };
  struct Pixel
  {
    glm::dvec3 color;
    bool counts;
  };
  std::vector<Pixel> Truth; ///< found once: the camera stands still
};

} // namespace hasp
