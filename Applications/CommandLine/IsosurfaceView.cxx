#include "IsosurfaceView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace hasp
{

IsosurfaceView::IsosurfaceView(vtkSmartPointer<vtkImageData> image_, double isovalue_, int width_,
  int height_, const glm::dvec3& direction)
  : image(std::move(image_)),
    isovalue(isovalue_),
    width(width_),
    height(height_),
    camera(vtkSmartPointer<vtkCamera>::New())
{
  vtkNew<vtkRenderer> fit; // only to place the camera
  fit->SetActiveCamera(camera);
  camera->SetPosition(-direction.x, -direction.y, -direction.z);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  fit->ResetCamera(image->GetBounds());
  camera->Zoom(1.4);
  fit->ResetCameraClippingRange(image->GetBounds());
  CameraMoved();
}

void IsosurfaceView::CameraMoved()
{
  vtkMatrix4x4* clip = camera->GetCompositeProjectionTransformMatrix(double(width) / height, -1, 1);
  clipToWorld = glm::inverse(glm::transpose(glm::dmat4(glm::make_mat4(clip->GetData()))));
}

glm::dvec3 IsosurfaceView::Unproject(int x, int y, double z) const
{
  const glm::dvec4 p =
    clipToWorld * glm::dvec4(2.0 * (x + 0.5) / width - 1.0, 2.0 * (y + 0.5) / height - 1.0, z, 1.0);
  return glm::dvec3(p) / p.w;
}

std::pair<glm::dvec3, glm::dvec3> IsosurfaceView::Ray(int x, int y) const
{
  const glm::dvec3 from = Unproject(x, y, -1.0);
  return { from, glm::normalize(Unproject(x, y, 1.0) - from) };
}

} // namespace hasp
