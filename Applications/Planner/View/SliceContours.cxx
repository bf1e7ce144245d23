#include "View/SliceContours.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCutter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace hasp
{

namespace
{

glm::dvec3 Times(vtkMatrix4x4* matrix, const glm::dvec3& place)
{
  const double from[4] = { place.x, place.y, place.z, 1.0 };
  glm::dvec4 to;
  matrix->MultiplyPoint(from, &to.x);
  return glm::dvec3(to) / to.w;
}

bool Reaches(const double bounds[6], const glm::dvec3& point, const glm::dvec3& normal)
{
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const double middle = glm::dot(0.5 * (low + high) - point, normal);
  return glm::abs(middle) <= glm::dot(0.5 * (high - low), glm::abs(normal));
}

/// The cutter has a piece for each of its threads.
vtkSmartPointer<vtkPolyData> Pieces(vtkDataObject* cut)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(vtkNew<vtkPolyData>());
  if (auto* single = vtkPolyData::SafeDownCast(cut))
    append->AddInputData(single);
  if (auto* several = vtkCompositeDataSet::SafeDownCast(cut))
  {
    const auto next = vtkSmartPointer<vtkCompositeDataIterator>::Take(several->NewIterator());
    for (next->InitTraversal(); !next->IsDoneWithTraversal(); next->GoToNextItem())
      if (auto* piece = vtkPolyData::SafeDownCast(next->GetCurrentDataObject()))
        append->AddInputData(piece);
  }
  append->Update();
  return append->GetOutput();
}

} // namespace

struct SliceContours::Line
{
  vtkSmartPointer<vtkPolyData> surface;
  vtkSmartPointer<vtkMatrix4x4> matrix;
  vtkNew<vtkPlane> plane; ///< where the surface is defined
  vtkNew<vtkPlaneCutter> cutter;
  vtkMTimeType taken = 0; ///< of what it has cut
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  vtkNew<vtkMatrix4x4> lifted;

  Line()
  {
    this->cutter->SetPlane(this->plane);
    this->cutter->InterpolateAttributesOff();
    this->mapper->ScalarVisibilityOff();
    this->actor->SetMapper(this->mapper);
    this->actor->SetUserMatrix(this->lifted);
    this->actor->GetProperty()->LightingOff();
    this->actor->PickableOff();
  }

  void Become(const SliceContour& contour)
  {
    this->surface = contour.surface;
    this->matrix = contour.matrix;
    this->cutter->SetInputData(contour.surface);
    this->actor->GetProperty()->SetColor(contour.colour.x, contour.colour.y, contour.colour.z);
    this->actor->GetProperty()->SetLineWidth(static_cast<float>(contour.width));
  }

  /// The plane in the surface's own space: its normal by the transposed matrix.
  void Cut(const glm::dvec3& point, const glm::dvec3& normal, double lift)
  {
    vtkNew<vtkMatrix4x4> back;
    if (this->matrix)
      this->lifted->DeepCopy(this->matrix);
    else
      this->lifted->Identity();
    vtkMatrix4x4::Invert(this->lifted, back);
    const glm::dvec3 own = Times(back, point);
    glm::dvec3 ownNormal(0.0);
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row)
        ownNormal[column] += this->lifted->GetElement(row, column) * normal[row];
    const bool reached = this->surface && this->surface->GetNumberOfPolys() > 0 &&
                         Reaches(this->surface->GetBounds(), own, ownNormal);
    this->actor->SetVisibility(reached);
    if (!reached)
      return;
    this->plane->SetOrigin(own.x, own.y, own.z);
    this->plane->SetNormal(ownNormal.x, ownNormal.y, ownNormal.z);
    this->cutter->Update();
    if (this->cutter->GetOutputDataObject(0)->GetUpdateTime() != this->taken)
    {
      this->taken = this->cutter->GetOutputDataObject(0)->GetUpdateTime();
      this->mapper->SetInputData(Pieces(this->cutter->GetOutputDataObject(0)));
    }
    for (int row = 0; row < 3; ++row)
      this->lifted->SetElement(row, 3, this->lifted->GetElement(row, 3) + lift * normal[row]);
  }
};

SliceContours::SliceContours(vtkRenderer* renderer) : Scene(renderer) {}

SliceContours::~SliceContours() = default;

void SliceContours::Set(const std::vector<SliceContour>& contours)
{
  while (this->Lines.size() > contours.size())
  {
    this->Scene->RemoveActor(this->Lines.back()->actor);
    this->Lines.pop_back();
  }
  while (this->Lines.size() < contours.size())
  {
    this->Lines.push_back(std::make_unique<Line>());
    this->Scene->AddActor(this->Lines.back()->actor);
  }
  for (std::size_t i = 0; i < contours.size(); ++i)
    this->Lines[i]->Become(contours[i]);
}

void SliceContours::Cut(const glm::dvec3& point, const glm::dvec3& normal, double lift)
{
  for (const auto& line : this->Lines)
    line->Cut(point, normal, lift);
}

int SliceContours::Reached() const
{
  return static_cast<int>(std::count_if(this->Lines.begin(), this->Lines.end(),
    [](const auto& line) { return line->actor->GetVisibility() != 0; }));
}

} // namespace hasp
