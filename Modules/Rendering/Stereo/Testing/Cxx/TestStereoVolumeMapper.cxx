#include "StereoLayout.h"
#include "StereoWindow.h"
#include "vtkHaspStereoPicture.h"
#include "vtkHaspStereoWindows.h"

#include "vtkHaspHeadlessWindows.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

constexpr int Size = 300;

/// A ball as a volume; drawn by VTK's ray caster or as its mesh.
class Scene
{
public:
  explicit Scene(bool asVolume)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(48, 48, 48);
    image->SetOrigin(-23.5, -23.5, -23.5);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (int z = 0; z < 48; ++z)
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
        {
          const double r2 =
            (x - 23.5) * (x - 23.5) + (y - 23.5) * (y - 23.5) + 3.0 * (z - 23.5) * (z - 23.5);
          *static_cast<float*>(image->GetScalarPointer(x, y, z)) =
            static_cast<float>(100.0 - 10.0 * (std::sqrt(r2) - 18.0));
        }
    asVolume ? this->AddVolume(image) : this->AddMesh(image);
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    this->window->SetSize(Size, Size);
    this->window->AddRenderer(this->renderer);
    this->renderer->GetActiveCamera()->SetPosition(40, -80, 30);
    this->renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
    this->renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
    this->renderer->GetActiveCamera()->SetEyeAngle(8);
    this->renderer->ResetCameraClippingRange();
  }

  std::vector<bool> OurLeftEye()
  {
    vtkNew<vtkHaspStereoPicture> picture;
    picture->SetRenderer(this->renderer);
    picture->SetEyeAngle(8.0);
    picture->SetLayout(hasp::StereoLayout::Left);
    const auto image = picture->Render();
    return Silhouette(static_cast<unsigned char*>(image->GetScalarPointer()));
  }

  /// Both eyes in one window, squeezed, or rows by turns.
  std::vector<bool> HalfEyes(hasp::StereoLayout layout)
  {
    vtkNew<vtkHaspStereoWindows> windows;
    windows->SetRenderer(this->renderer);
    windows->SetEyeAngle(8.0);
    EXPECT_TRUE(windows->AddWindow(this->window, { { layout, hasp::StereoResolution::Half } }));
    EXPECT_TRUE(windows->Render());
    vtkNew<vtkUnsignedCharArray> pixels;
    this->window->GetPixelData(0, 0, Size - 1, Size - 1, 1, pixels);
    return Silhouette(pixels->GetPointer(0));
  }

  std::vector<bool> VtksLeftEye()
  {
    this->window->SetStereoTypeToLeft();
    this->window->SetStereoRender(true);
    this->window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->window->GetPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
    return Silhouette(pixels->GetPointer(0));
  }

private:
  static std::vector<bool> Silhouette(const unsigned char* rgb)
  {
    std::vector<bool> inside(Size * Size);
    for (std::size_t p = 0; p < inside.size(); ++p)
      inside[p] = rgb[3 * p] > 20;
    return inside;
  }

  void AddVolume(vtkImageData* image)
  {
    vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(image);
    mapper->AutoAdjustSampleDistancesOff();
    mapper->SetSampleDistance(0.25);
    mapper->SetBlendModeToIsoSurface();
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0, 1, 1, 1);
    vtkNew<vtkPiecewiseFunction> opaque;
    opaque->AddPoint(0, 1);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->GetProperty()->SetInterpolationTypeToLinear();
    volume->GetProperty()->SetColor(white);
    volume->GetProperty()->SetScalarOpacity(opaque);
    volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 100.0);
    this->renderer->AddVolume(volume);
  }

  void AddMesh(vtkImageData* image)
  {
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image);
    contour->SetValue(0, 100.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(contour->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    this->renderer->AddActor(actor);
  }

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
};

double ShareThatDiffers(const std::vector<bool>& a, const std::vector<bool>& b)
{
  double differ = 0.0, inside = 0.0;
  for (std::size_t p = 0; p < a.size(); ++p)
  {
    differ += a[p] != b[p];
    inside += b[p];
  }
  return differ / inside;
}

TEST(StereoVolumeMapper, VtksRayCasterSeesWhatMeshesShow)
{
  hasp::UseHeadlessWindows();
  Scene volume(true), mesh(false);
  const double ours = ShareThatDiffers(volume.OurLeftEye(), mesh.OurLeftEye());
  const double vtks = ShareThatDiffers(volume.VtksLeftEye(), mesh.VtksLeftEye());
  RecordProperty("ours", std::to_string(ours));
  RecordProperty("vtk", std::to_string(vtks));
  // Rays of 0.25 voxel steps may miss a rim of a quarter pixel: an outline of 560 pixels around
  // 23,500 makes 0.6 %. VTK's own stereo casts its rays from between the eyes (16 % differ): were
  // it right, this test would prove nothing.
  EXPECT_LT(ours, 0.006);
  EXPECT_GT(vtks, 0.05);
}

TEST(StereoVolumeMapper, StretchedAndShiftedEyesAreThoseOfMeshes)
{
  hasp::UseHeadlessWindows();
  Scene volume(true), mesh(false);
  // As above, with pixels twice as wide or rows twice as high along the outline.
  for (const auto layout : { hasp::StereoLayout::SideBySide, hasp::StereoLayout::TopBottom,
         hasp::StereoLayout::Interlaced, hasp::StereoLayout::Checkerboard })
    EXPECT_LT(ShareThatDiffers(volume.HalfEyes(layout), mesh.HalfEyes(layout)), 0.012)
      << hasp::StereoLayoutName(layout);
}

} // namespace
