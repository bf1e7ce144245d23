#include "SilhouetteScene.h"

#include "Failure.h"
#include "VolumeIsosurface.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspRayCachingMapper.h"
#include "vtkHaspStereoPicture.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace hasp
{
namespace
{

constexpr int Pixels = 400, Samples = 48;
constexpr double IsoValue = 100.0;

vtkSmartPointer<vtkImageData> LensImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  constexpr double half = 0.5 * (Samples - 1);
  image->SetDimensions(Samples, Samples, Samples);
  image->SetOrigin(-half, -half, -half);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* sample = static_cast<float*>(image->GetScalarPointer());
  for (int z = 0; z < Samples; ++z)
    for (int y = 0; y < Samples; ++y)
      for (int x = 0; x < Samples; ++x)
      {
        const double a = x - half, b = y - half, c = z - half;
        *sample++ =
          static_cast<float>(IsoValue - 10.0 * (std::sqrt(a * a + b * b + 3.0 * c * c) - 18.0));
      }
  return image;
}

vtkSmartPointer<vtkProp> ActorOf(vtkMapper* mapper)
{
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
  return actor.Get();
}

template <typename Mapper>
vtkSmartPointer<vtkProp> ByOurs()
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(LensImage());
  mapper->SetIsoValue(IsoValue);
  return ActorOf(mapper);
}

vtkSmartPointer<vtkProp> ByMesh()
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(LensImage());
  contour->SetValue(0, IsoValue);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contour->GetOutputPort());
  return ActorOf(mapper);
}

vtkSmartPointer<vtkProp> ByVtksRays()
{
  const auto volume = MakeVolumeIsosurface(LensImage(), IsoValue, 0.25);
  volume->GetProperty()->ShadeOff(); // the outline alone, as the actors
  return volume;
}

/// Of the eye whose picture begins at that column.
std::vector<bool> OutlineIn(vtkImageData* picture, int firstColumn)
{
  std::vector<bool> outline;
  for (int y = 0; y < Pixels; ++y)
    for (int x = 0; x < Pixels; ++x)
      outline.push_back(
        static_cast<unsigned char*>(picture->GetScalarPointer(firstColumn + x, y, 0))[0] > 20);
  return outline;
}

} // namespace

SilhouetteScene::Method SilhouetteScene::Mesh()
{
  return { "mesh", "vtkFlyingEdges3D, VTK " VTK_VERSION, ByMesh };
}

std::vector<SilhouetteScene::Method> SilhouetteScene::Methods()
{
  return { { "clustered", "clustered cells", ByOurs<vtkHaspClusteredCellMapper> },
    { "raycaching", "ray caching", ByOurs<vtkHaspRayCachingMapper>, 30 },
    { "vtk", "VTK " VTK_VERSION " ray caster", ByVtksRays } };
}

SilhouetteScene::SilhouetteScene(const Method& method) : Frames(method.frames)
{
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(Pixels, Pixels);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AddViewProp(method.make());
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(40, -80, 30);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
}

vtkSmartPointer<vtkImageData> SilhouetteScene::Draw(StereoLayout layout)
{
  vtkNew<vtkHaspStereoPicture> picture;
  picture->SetRenderer(this->Renderer);
  picture->SetEyeAngle(8.0);
  picture->SetLayout(layout);
  for (int frame = 1; frame < this->Frames; ++frame)
    picture->Render();
  vtkSmartPointer<vtkImageData> image;
  this->Spent = TimeOf([&] { image = picture->Render(); });
  if (!image)
    throw Failure(ExitCode::CannotDraw, "stereo report: no picture");
  return image;
}

SilhouetteScene::Outline SilhouetteScene::OfEye(StereoLayout eye)
{
  return OutlineIn(this->Draw(eye), 0);
}

std::array<SilhouetteScene::Outline, 2> SilhouetteScene::OfPair()
{
  const auto pair = this->Draw(StereoLayout::SideBySide);
  return { OutlineIn(pair, 0), OutlineIn(pair, Pixels) };
}

double SilhouetteScene::Share(const Outline& found, const Outline& truth)
{
  double differ = 0.0, inside = 0.0;
  for (std::size_t p = 0; p < truth.size(); ++p)
  {
    differ += found[p] != truth[p];
    inside += truth[p];
  }
  return differ / inside;
}

} // namespace hasp
