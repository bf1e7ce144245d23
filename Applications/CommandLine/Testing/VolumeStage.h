#pragma once
#include "PictureFile.h"
#include "VolumeLook.h"
#include "vtkHaspHeadlessWindows.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

/// Volumes made by a function, and a stage on which they are drawn and looked at.
namespace hasp::testing
{

using Point = std::array<double, 3>;
using Size3 = std::array<int, 3>;

constexpr int PixelsASample = 3; // odd, so that a pixel's middle is a sample's
/// Bytes of a picture: the colour's own rounding, and that of VTK's table of opacities.
constexpr double Rounding = 1.5;

inline vtkSmartPointer<vtkImageData> Volume(const Size3& size, const Point& spacing, int type,
  const std::function<double(int, int, int)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->SetSpacing(spacing.data());
  image->AllocateScalars(type, 1);
  vtkIdType n = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i, ++n)
        image->GetPointData()->GetScalars()->SetTuple1(n, value(i, j, k));
  return image;
}

inline double Grey(double value, const std::array<double, 2>& window)
{
  return 255.0 * std::clamp((value - window[0]) / (window[1] - window[0]), 0.0, 1.0);
}

/// A renderer on black without a display.
struct Stage
{
  bool headless = UseHeadlessWindows(); // before the window
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkSmartPointer<vtkImageData> picture;

  explicit Stage(int width = 100, int height = 100)
  {
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    this->window->SetSize(width, height);
    this->window->AddRenderer(this->renderer);
  }
  void Draw()
  {
    this->renderer->ResetCameraClippingRange();
    this->window->Render();
    this->picture = WindowPicture(this->window);
  }
  const unsigned char* At(int x, int y) const
  {
    return static_cast<const unsigned char*>(this->picture->GetScalarPointer(x, y, 0));
  }
  Point World(double x, double y, double depth)
  {
    this->renderer->SetDisplayPoint(x, y, depth);
    this->renderer->DisplayToWorld();
    const double* p = this->renderer->GetWorldPoint();
    return { p[0] / p[3], p[1] / p[3], p[2] / p[3] };
  }
};

/// Looks along an axis, parallel, so that each sample across it is PixelsASample pixels wide and
/// high; the spacing must be one across. Right in the picture is `right`, up is the third axis.
struct Column
{
  int along, right, up;
};

inline void LookAlong(Stage& stage, vtkImageData* image, const Column& way)
{
  int size[3];
  image->GetDimensions(size);
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  Point middle, from, up{};
  image->GetCenter(middle.data());
  double axis[3] = { 0, 0, 0 }, right[3] = { 0, 0, 0 }, look[3];
  right[way.right] = 1.0;
  up[way.up] = axis[way.along] = 1.0;
  vtkMath::Cross(up.data(), right, look); // into the picture
  for (int a = 0; a < 3; ++a)
    from[a] = middle[a] - 2000.0 * look[a];
  camera->ParallelProjectionOn();
  camera->SetPosition(from.data());
  camera->SetFocalPoint(middle.data());
  camera->SetViewUp(up.data());
  camera->SetParallelScale(0.5 * image->GetSpacing()[way.up] * size[way.up]);
}

} // namespace hasp::testing
