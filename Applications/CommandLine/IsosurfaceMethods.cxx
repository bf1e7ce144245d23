#include "IsosurfaceMethods.h"

#include "Isosurface/ClusteredCells.h"
#include "VolumeIsosurface.h"
#include "WindowMethod.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkActor.h"
#include "vtkContourValues.h"
#include "vtkFlyingEdges3D.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <stdexcept>

namespace hasp
{
namespace
{

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
  void SetIsovalue(double isovalue) override { this->Mapper->SetIsoValue(isovalue); }
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
  void SetIsovalue(double isovalue) override { this->Contour->SetValue(0, isovalue); }
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
      Step(sampleDistance),
      Volume(MakeVolumeIsosurface(view.image, view.isovalue, sampleDistance))
  {
    this->Renderer->AddVolume(this->Volume);
  }
  void SetIsovalue(double isovalue) override
  {
    this->Volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
  }
  std::string Name() const override
  {
    return "VTK " VTK_VERSION " vtkOpenGLGPUVolumeRayCastMapper, isosurface blend, step " +
           std::to_string(this->Step).substr(0, 4) + " voxel";
  }
  /// It writes no depth buffer; its own depth image is drawn on request, outside the timed frames.
  SurfacePoints Points() override
  {
    auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(this->Volume->GetMapper());
    mapper->RenderToImageOn();
    this->Draw();
    vtkNew<vtkImageData> depth;
    mapper->GetDepthImage(depth);
    mapper->RenderToImageOff();
    const auto* values = static_cast<const float*>(depth->GetScalarPointer());
    return this->FromDepth([&](int n) { return values[n]; });
  }

private:
  double Step;
  vtkSmartPointer<vtkVolume> Volume;
};

} // namespace

void IsosurfaceMethod::SetIsovalue(double)
{
  throw std::logic_error(this->Name() + ": has one isovalue");
}

std::vector<glm::vec3> IsosurfaceMethod::Picture()
{
  throw std::logic_error(this->Name() + ": makes no picture");
}

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
