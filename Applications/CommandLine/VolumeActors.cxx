#include "VolumeActors.h"

#include "VolumeIsosurface.h"
#include "VolumeLook.h"

#if HASP_WITH_CELLS
#include "CellActors.h"
#endif
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <memory>

namespace hasp
{
namespace
{

constexpr double VolumeStep = 0.5; // of VTK's isosurface, in voxels, as `hasp report` has it

/// A volume, its resources with that reason, and the rows of what it does without.
SurfaceActor MakeActor(
  const vtkSmartPointer<vtkVolume>& volume, const std::string& mapper, const std::string& reason)
{
  SurfaceActor result;
  result.prop = volume;
  const std::size_t bytes = VolumeBytes(volume);
  result.listResources = [bytes, mapper, reason](ResourceList& list)
  {
    list.push_back({ "active cells", 0, 0.0, "--mapper " + mapper });
    list.push_back({ "mesh", 0, 0.0, "rays need none" });
    list.push_back({ "volume, GPU", bytes, 0.0, "--mapper " + mapper + "; " + reason });
  };
  return result;
}

/// VTK's mappers can be asked for no point; rays of ours are, for the surface of that value.
void AddPick([[maybe_unused]] SurfaceActor& actor, [[maybe_unused]] vtkImageData* image,
  [[maybe_unused]] std::function<double()> isoValue)
{
#if HASP_WITH_CELLS
  actor.pick = [isoValue, rays = IsosurfaceRays(image)](const auto& from, const auto& to)
  { return rays(isoValue(), from, to); };
#endif
}

} // namespace

SurfaceActor MakeVolumeActor(vtkImageData* image, double isoValue)
{
  const vtkSmartPointer<vtkVolume> volume = MakeVolumeIsosurface(image, isoValue, VolumeStep);
  SurfaceActor result = MakeActor(volume, "vtk", "VTK's own, its time is a frame's");
  result.setIsoValue = [volume](double value)
  { volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, value); };
  result.drewBy = [] { return "VTK's volume mapper"; };
  const auto value = [volume] { return volume->GetProperty()->GetIsoSurfaceValues()->GetValue(0); };
  AddPick(result, image, value);
#if HASP_WITH_CELLS
  result.bounds = [value, image = vtkSmartPointer<vtkImageData>(image)]
  { return IsosurfaceBounds(image, value()); };
#endif
  return result;
}

SurfaceActor MakeBrightestActor(vtkImageData* image, const SurfaceDrawing& drawing)
{
  SurfaceActor result = MakeActor(MakeBrightest(image, drawing.look.window), "mip",
    WindowText(drawing.look) + "; its time is a frame's");
  result.drewBy = [] { return "VTK's volume mapper, brightest values"; };
  return result;
}

SurfaceActor MakeTranslucentActor(
  vtkImageData* image, double isoValue, const SurfaceDrawing& drawing)
{
  struct Bone
  {
    double value;
    std::array<double, 3> color{ 1.0, 1.0, 1.0 };
  };
  const auto bone = std::make_shared<Bone>(Bone{ isoValue });
  const auto volume = MakeTranslucent(image, bone->value, drawing.look, bone->color);
  const auto change = [volume, bone, look = drawing.look]
  { SetTranslucentBone(volume, bone->value, look, bone->color); };
  SurfaceActor result = MakeActor(volume, "composite",
    drawing.look.skin ? "skin and bone; its time is a frame's"
                      : "bone, no skin: values are no HU; its time is a frame's");
  result.setIsoValue = [bone, change](double value)
  {
    bone->value = value;
    change();
  };
  result.setColor = [bone, change](const std::array<double, 3>& color)
  {
    bone->color = color;
    change();
  };
  result.drewBy = [] { return "VTK's volume mapper, composited"; };
  AddPick(result, image, [bone] { return bone->value; });
  return result;
}

} // namespace hasp
