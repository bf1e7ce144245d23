#pragma once
#include "Grid/ResourceUse.h"
#include "IsosurfaceView.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// Frames until shaders are compiled, culling knows what is hidden and Automatic has decided.
constexpr int SettlingFrames = 6;

/// What a method shows in each pixel, row by row from below: a world point, or nothing.
using SurfacePoints = std::vector<std::optional<glm::dvec3>>;

/// One way to an isosurface picture. The first Draw pays for set-up too. RENDER thread.
class IsosurfaceMethod
{
public:
  virtual ~IsosurfaceMethod() = default;
  virtual std::string Name() const = 0; ///< "VTK 9.1.0 FlyingEdges3D + vtkPolyDataMapper"
  virtual void Draw() = 0;              ///< one finished frame
  virtual SurfacePoints Points() = 0;   ///< of the last frame
  /// Of the next frames; the view's until then. Throws std::logic_error if it cannot.
  virtual void SetIsovalue(double isovalue);
  /// Red, green, blue in [0,1] of the last frame, row by row from below; std::logic_error if none.
  virtual std::vector<glm::vec3> Picture();
  virtual std::size_t Bytes() const { return 0; } ///< of the structure it draws from
  virtual ResourceList Resources() const { return {}; }
};

/// How clustered cells are drawn.
enum class CellDrawing
{
  Automatic, ///< as in a scene that asks for nothing
  Rasterize,
  RasterizeAll, ///< also the clusters that others hide
  Trace         ///< a build with Embree has it
};
/// The view must outlive the method.
std::unique_ptr<IsosurfaceMethod> MakeCellMethod(
  const IsosurfaceView& view, CellDrawing drawing = CellDrawing::Automatic);
std::unique_ptr<IsosurfaceMethod> MakeMeshMethod(const IsosurfaceView& view);
/// sampleDistance in voxels (of the smallest spacing).
std::unique_ptr<IsosurfaceMethod> MakeVolumeMethod(
  const IsosurfaceView& view, double sampleDistance);
/// One exact ray a pixel on all cores, shaded on the CPU.
std::unique_ptr<IsosurfaceMethod> MakeDirectMethod(const IsosurfaceView& view);

} // namespace hasp
