#pragma once
#include "IsosurfaceMethods.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

namespace hasp
{

/// A window of the view's size and camera.
class WindowMethod : public IsosurfaceMethod
{
public:
  explicit WindowMethod(const IsosurfaceView& view) : View(view)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(view.width, view.height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetActiveCamera(view.camera);
  }
  void Draw() override
  {
    this->Window->Render();
    this->Window->WaitForCompletion();
  }
  /// The eye that the next frames are of; 0: one between both, which is where it starts.
  void ChooseEye(int leftOrRight)
  {
    this->Window->SetStereoRender(leftOrRight != 0);
    if (leftOrRight < 0)
      this->Window->SetStereoTypeToLeft();
    else if (leftOrRight > 0)
      this->Window->SetStereoTypeToRight();
  }
  void SetSize(int width, int height) { this->Window->SetSize(width, height); }
  std::vector<glm::vec3> Picture() override
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* size = this->Window->GetSize();
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    std::vector<glm::vec3> picture(pixels->GetNumberOfTuples());
    for (std::size_t n = 0; n < picture.size(); ++n)
      for (int c = 0; c < 3; ++c)
        picture[n][c] = float(pixels->GetValue(vtkIdType(3 * n) + c)) / 255.0F;
    return picture;
  }
  SurfacePoints Points() override
  {
    vtkNew<vtkFloatArray> depth;
    this->Window->GetZbufferData(0, 0, this->View.width - 1, this->View.height - 1, depth);
    return this->FromDepth([&](int n) { return depth->GetValue(n); });
  }

protected:
  template <typename DepthOf>
  SurfacePoints FromDepth(const DepthOf& depthOf) const
  {
    SurfacePoints points(std::size_t(this->View.width) * this->View.height);
    for (int y = 0, n = 0; y < this->View.height; ++y)
      for (int x = 0; x < this->View.width; ++x, ++n)
        if (const float depth = depthOf(n); depth < 1.0F)
          points[n] = this->View.Unproject(x, y, 2.0 * depth - 1.0);
    return points;
  }

  const IsosurfaceView& View;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

} // namespace hasp
