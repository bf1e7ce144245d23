#include "IsosurfaceMethods.h"

#include "Isosurface/ClusteredCells.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace hasp
{
namespace
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

class CellMethod : public WindowMethod
{
public:
  CellMethod(const IsosurfaceView& view, CellDrawing drawing) : WindowMethod(view)
  {
    this->Mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
    if (drawing == CellDrawing::Trace)
      this->Mapper->SetRendererToTrace();
    else if (drawing != CellDrawing::Automatic)
      this->Mapper->SetRendererToRasterize();
    this->Mapper->SetOcclusionCulling(drawing != CellDrawing::RasterizeAll);
    this->Mapper->SetInputData(view.image);
    this->Mapper->SetIsoValue(view.isovalue);
    vtkNew<vtkActor> actor;
    actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(actor);
  }
  /// Says what was drawn last.
  std::string Name() const override
  {
    return "clustered cells, " + this->Mapper->GetRendererChoice() +
           (this->Mapper->GetOcclusionCulling() ? "" : ", hidden clusters too");
  }
  std::size_t Bytes() const override { return this->Mapper->GetCells().Bytes(); }
  ResourceList Resources() const override
  {
    ResourceList list;
    this->Mapper->ListResources(list);
    return list;
  }

private:
  vtkSmartPointer<vtkHaspClusteredCellMapper> Mapper;
};

class MeshMethod : public WindowMethod
{
public:
  explicit MeshMethod(const IsosurfaceView& view) : WindowMethod(view)
  {
    this->Contour->SetInputData(view.image);
    this->Contour->SetValue(0, view.isovalue);
    this->Contour->ComputeNormalsOn();
    this->Contour->ComputeScalarsOff();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Contour->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
  }
  std::string Name() const override
  {
    return "VTK " VTK_VERSION " vtkFlyingEdges3D with normals + vtkPolyDataMapper";
  }
  std::size_t Bytes() const override
  {
    return std::size_t(1024) * this->Contour->GetOutput()->GetActualMemorySize();
  }

private:
  vtkNew<vtkFlyingEdges3D> Contour;
};

class VolumeMethod : public WindowMethod
{
public:
  VolumeMethod(const IsosurfaceView& view, double sampleDistance)
    : WindowMethod(view),
      Step(sampleDistance)
  {
    const double* spacing = view.image->GetSpacing();
    this->Mapper->SetInputData(view.image);
    this->Mapper->SetBlendModeToIsoSurface();
    this->Mapper->SetAutoAdjustSampleDistances(false);
    this->Mapper->SetUseJittering(false);
    this->Mapper->SetSampleDistance(
      static_cast<float>(sampleDistance * *std::min_element(spacing, spacing + 3)));
    vtkNew<vtkVolumeProperty> property;
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    const double* range = view.image->GetScalarRange();
    color->AddRGBPoint(range[0], 1, 1, 1);
    color->AddRGBPoint(range[1], 1, 1, 1);
    opacity->AddPoint(range[0], 1);
    opacity->AddPoint(range[1], 1);
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
    property->ShadeOn();
    property->SetInterpolationTypeToLinear();
    property->GetIsoSurfaceValues()->SetValue(0, view.isovalue);
    this->Volume->SetMapper(this->Mapper);
    this->Volume->SetProperty(property);
    this->Renderer->AddVolume(this->Volume);
  }
  std::string Name() const override
  {
    return "VTK " VTK_VERSION " vtkOpenGLGPUVolumeRayCastMapper, isosurface blend, step " +
           std::to_string(this->Step).substr(0, 4) + " voxel";
  }
  /// It writes no depth buffer; its own depth image is drawn on request, outside the timed frames.
  SurfacePoints Points() override
  {
    this->Mapper->RenderToImageOn();
    this->Draw();
    vtkNew<vtkImageData> depth;
    this->Mapper->GetDepthImage(depth);
    this->Mapper->RenderToImageOff();
    const auto* values = static_cast<const float*>(depth->GetScalarPointer());
    return this->FromDepth([&](int n) { return values[n]; });
  }

private:
  double Step;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Volume;
};

} // namespace

std::unique_ptr<IsosurfaceMethod> MakeCellMethod(const IsosurfaceView& view, CellDrawing drawing)
{
  return std::make_unique<CellMethod>(view, drawing);
}

std::unique_ptr<IsosurfaceMethod> MakeMeshMethod(const IsosurfaceView& view)
{
  return std::make_unique<MeshMethod>(view);
}

std::unique_ptr<IsosurfaceMethod> MakeVolumeMethod(
  const IsosurfaceView& view, double sampleDistance)
{
  return std::make_unique<VolumeMethod>(view, sampleDistance);
}

} // namespace hasp
