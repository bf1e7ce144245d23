#include "View/SliceIsoline.h"

#include "View/SliceAxis.h"
#include "View/SliceGrid.h"
#include "View/SliceImage.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkFlyingEdges2D.h"
#include "vtkImageData.h"
#include "vtkImageReslice.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace hasp
{

namespace
{

constexpr double MostValues = 1024.0; // along an axis

/// Columns: what of the world is right, up and towards the viewer, and where the plane's 0 lies.
void FillPlaneToWorld(const SliceFrame& frame, const glm::dvec3& at, vtkMatrix4x4* matrix)
{
  for (int row = 0; row < 3; ++row)
  {
    matrix->SetElement(row, 0, frame.right[row]);
    matrix->SetElement(row, 1, frame.up[row]);
    matrix->SetElement(row, 2, frame.towardsViewer[row]);
    matrix->SetElement(row, 3, at[row]);
  }
}

} // namespace

SliceIsoline::SliceIsoline(vtkRenderer* renderer) : Scene(renderer)
{
  this->Reslice->SetOutputDimensionality(2);
  this->Reslice->SetOutputScalarType(VTK_FLOAT);
  this->Reslice->SetInterpolationModeToLinear();
  this->Reslice->MirrorOn(); // no edge where the image ends; what lies beyond is clipped
  this->Reslice->SetResliceAxes(this->PlaneToData);
  this->Edges->SetInputConnection(this->Reslice->GetOutputPort());
  this->Edges->ComputeScalarsOff();
  this->Mapper->SetInputConnection(this->Edges->GetOutputPort());
  this->Mapper->ScalarVisibilityOff();
  this->Line->SetMapper(this->Mapper);
  this->Line->SetUserMatrix(this->PlaneToWorld);
  this->Line->GetProperty()->LightingOff();
  this->Line->GetProperty()->SetColor(0.35, 0.85, 1.0);
  this->Line->PickableOff();
  renderer->AddActor(this->Line);
}

SliceIsoline::~SliceIsoline()
{
  this->Scene->RemoveActor(this->Line);
}

/// Its voxels bound the lines.
void SliceIsoline::Take(vtkImageData* image)
{
  if (image->GetMTime() == this->Taken)
    return;
  this->Taken = image->GetMTime();
  this->Reslice->SetInputData(StraightImage(image));
  this->Mapper->RemoveAllClippingPlanes();
  const GridGeometry grid = ImageGeometry(image);
  for (int axis = 0; axis < 3; ++axis)
    for (const bool last : { false, true })
    {
      glm::dvec3 index(0.0);
      index[axis] = last ? grid.dims[axis] - 0.5 : -0.5;
      const glm::dvec3 at = grid.IndexToWorld(index);
      const glm::dvec3 inwards = last ? -grid.direction[axis] : grid.direction[axis];
      vtkNew<vtkPlane> side;
      side->SetOrigin(at.x, at.y, at.z);
      side->SetNormal(inwards.x, inwards.y, inwards.z);
      this->Mapper->AddClippingPlane(side);
    }
}

void SliceIsoline::Cut(
  vtkImageData* image, double value, const SliceFrame& frame, const glm::dvec3& place, double lift)
{
  const WorldBox box = BoxOf(image);
  glm::dvec3 middle = 0.5 * (box.low + box.high);
  middle[frame.normalAxis] = place[frame.normalAxis];
  this->Edges->SetValue(0, value);
  if (image->GetMTime() == this->Taken && middle == this->Middle)
    return;
  this->Middle = middle;
  this->Take(image);
  const glm::dvec3 size = box.high - box.low;
  const double width = glm::dot(size, glm::abs(frame.right));
  const double height = glm::dot(size, glm::abs(frame.up));
  const double* own = image->GetSpacing();
  const double finest = std::min({ own[0], own[1], own[2] });
  const double spacing = std::max({ finest, width / MostValues, height / MostValues });

  vtkNew<vtkMatrix4x4> toWorld, worldToData;
  FillPlaneToWorld(frame, middle, toWorld);
  FillDataToWorld(image, worldToData);
  worldToData->Invert();
  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Multiply4x4(worldToData, toWorld, toData);
  this->PlaneToData->DeepCopy(toData);

  const int right = static_cast<int>(std::ceil(0.5 * width / spacing));
  const int up = static_cast<int>(std::ceil(0.5 * height / spacing));
  this->Reslice->SetOutputSpacing(spacing, spacing, 1.0);
  this->Reslice->SetOutputOrigin(0, 0, 0);
  this->Reslice->SetOutputExtent(-right, right, -up, up, 0, 0);
  FillPlaneToWorld(frame, middle + lift * frame.towardsViewer, this->PlaneToWorld);
}

} // namespace hasp
