#include "BallScene.h"

#include "Failure.h"
#include "StereoRig.h"
#include "VolumeIsosurface.h"
#include "vtkHaspStereoCamera.h"
#include "vtkHaspStereoPicture.h"
#include "vtkHaspStereoWindows.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>

namespace hasp
{
namespace
{

constexpr double Radius = 5.0; // mm: 17 to 28 pixels, so that the middle is known to 0.05 pixel

vtkSmartPointer<vtkProp> MeshBall(const glm::dvec3& center)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(center.x, center.y, center.z);
  ball->SetRadius(Radius);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(48);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor.Get();
}

vtkSmartPointer<vtkImageData> BallImage(const glm::dvec3& center)
{
  constexpr int size = 25;
  constexpr double spacing = 0.5, half = 0.5 * spacing * (size - 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, size);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(center.x - half, center.y - half, center.z - half);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* sample = static_cast<float*>(image->GetScalarPointer());
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        *sample++ = static_cast<float>(Radius - glm::length(spacing * glm::dvec3(x, y, z) - half));
  return image;
}

vtkSmartPointer<vtkProp> VolumeBall(const glm::dvec3& center)
{
  const auto volume = MakeVolumeIsosurface(BallImage(center), 0.0, 0.2);
  volume->GetProperty()->ShadeOff(); // a white disc, as the mesh
  return volume;
}

/// Middle of the bright pixels between two columns; pixel centres lie at half numbers.
glm::dvec2 Middle(const unsigned char* rgb, int rowWidth, int firstColumn)
{
  glm::dvec2 sum(0.0);
  double count = 0.0;
  for (int y = 0; y < BallScene::Height; ++y)
    for (int x = 0; x < BallScene::Width; ++x)
      if (rgb[3 * (static_cast<std::size_t>(y) * rowWidth + firstColumn + x)] > 127)
      {
        sum += glm::dvec2(x + 0.5, y + 0.5);
        ++count;
      }
  if (count == 0.0)
    throw Failure(ExitCode::CannotDraw, "stereo report: the ball is not in the picture");
  return sum / count;
}

} // namespace

BallScene::BallScene()
{
  this->Window->SetOffScreenRendering(true);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(Width, Height);
  this->Window->AddRenderer(this->Renderer);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(40, -500, 60);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->SetEyeAngle(EyeAngle);
}

void BallScene::PlaceBall(const glm::dvec3& center, Ball kind)
{
  this->Renderer->RemoveAllViewProps();
  this->Renderer->AddViewProp(kind == Ball::Mesh ? MeshBall(center) : VolumeBall(center));
  this->Renderer->ResetCameraClippingRange();
}

std::array<glm::dvec2, 2> BallScene::ByRig()
{
  vtkNew<vtkHaspStereoPicture> picture;
  picture->SetRenderer(this->Renderer);
  picture->SetEyeAngle(EyeAngle);
  const auto image = picture->Render();
  if (!image)
    throw Failure(ExitCode::CannotDraw, "stereo report: no picture");
  const auto* rgb = static_cast<unsigned char*>(image->GetScalarPointer());
  return { Middle(rgb, 2 * Width, 0), Middle(rgb, 2 * Width, Width) };
}

std::array<glm::dvec2, 2> BallScene::ByVtk()
{
  std::array<glm::dvec2, 2> middles;
  this->Window->SetStereoRender(true);
  for (int eye = 0; eye < 2; ++eye)
  {
    this->Window->SetStereoType(eye == 0 ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, Width - 1, Height - 1, 0, pixels);
    middles[eye] = Middle(pixels->GetPointer(0), Width, 0);
  }
  this->Window->SetStereoRender(false);
  return middles;
}

std::array<glm::dvec2, 2> BallScene::Truth(const glm::dvec3& center) const
{
  const StereoRig rig =
    RigFromCamera(this->Renderer->GetActiveCamera(), static_cast<double>(Width) / Height, EyeAngle);
  const auto pixel = [&](StereoEye eye)
  { return (ProjectToScreen(rig, eye, center) + 1.0) * 0.5 * glm::dvec2(Width, Height); };
  return { pixel(StereoEye::Left), pixel(StereoEye::Right) };
}

ResourceList BallScene::SkippedInMono()
{
  vtkNew<vtkHaspStereoWindows> windows;
  windows->SetRenderer(this->Renderer);
  if (!windows->AddWindow(this->Window, "mono") || !windows->Render())
    throw Failure(ExitCode::CannotDraw, "stereo report: no picture");
  ResourceList skipped;
  windows->ListResources(skipped);
  return skipped;
}

} // namespace hasp
