#include "vtkHaspStrokeActor.h"

#include "LabelPalette.h"
#include "StrokePoints.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

vtkStandardNewMacro(vtkHaspStrokeActor);

namespace
{

constexpr double StepRadii = 0.25;
constexpr double MostRadiusMm = 50.0; // of a BrushStroke

/// A stroke, and what draws it.
struct ShownStroke
{
  explicit ShownStroke(const hasp::BrushStroke& of)
  {
    this->stroke.label = of.label;
    this->stroke.radiusMm = of.radiusMm;
    this->points->SetDataTypeToDouble();
    this->data->SetPoints(this->points);
    this->data->SetVerts(this->verts);
    this->mapper->SetInputData(this->data);
    this->mapper->SetRadius(static_cast<float>(of.radiusMm));
    this->actor->SetMapper(this->mapper);
  }

  /// Is `other` this, or this and more at its end?
  bool Begins(const hasp::BrushStroke& other) const
  {
    const auto &own = this->stroke.points, &its = other.points;
    return this->stroke.label == other.label && this->stroke.radiusMm == other.radiusMm &&
           own.size() <= its.size() && std::equal(own.begin(), own.end(), its.begin());
  }

  /// How many balls are new.
  vtkIdType Grow(const hasp::BrushStroke& to)
  {
    const std::size_t had = this->stroke.points.size();
    if (to.points.size() == had)
      return 0;
    // From its last point on, which has its ball.
    const std::vector<glm::dvec3> along =
      hasp::PointsAlong(to, StepRadii * to.radiusMm, had > 0 ? had - 1 : 0);
    for (std::size_t n = had > 0 ? 1 : 0; n < along.size(); ++n)
    {
      const vtkIdType id = this->points->InsertNextPoint(&along[n].x);
      this->verts->InsertNextCell(1, &id);
    }
    this->points->Modified();
    this->verts->Modified();
    this->data->Modified();
    this->stroke.points = to.points;
    return static_cast<vtkIdType>(along.size()) - (had > 0 ? 1 : 0);
  }

  hasp::BrushStroke stroke;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkOpenGLSphereMapper> mapper;
  vtkNew<vtkActor> actor;
};

bool IsStroke(const hasp::BrushStroke& stroke)
{
  const auto finite = [](const glm::dvec3& p)
  { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  return stroke.radiusMm > 0.0 && stroke.radiusMm <= MostRadiusMm &&
         std::all_of(stroke.points.begin(), stroke.points.end(), finite);
}

} // namespace

struct vtkHaspStrokeActor::Internals
{
  std::vector<std::unique_ptr<ShownStroke>> shown;
  std::map<int, glm::dvec3> colours; ///< those that have been said
  vtkIdType made = 0;
  double bounds[6] = {};

  void Colour(const ShownStroke& one) const
  {
    const auto said = this->colours.find(one.stroke.label);
    const glm::dvec3 colour =
      said != this->colours.end() ? said->second : hasp::PaletteColour(one.stroke.label);
    one.actor->GetProperty()->SetColor(colour.x, colour.y, colour.z);
  }
};

vtkHaspStrokeActor::vtkHaspStrokeActor() : Self(std::make_unique<Internals>())
{
  this->PickableOff();
}

vtkHaspStrokeActor::~vtkHaspStrokeActor() = default;

bool vtkHaspStrokeActor::SetStrokes(const std::vector<hasp::BrushStroke>& strokes)
{
  if (!std::all_of(strokes.begin(), strokes.end(), IsStroke))
  {
    vtkErrorMacro(<< "A stroke to be shown has a radius that is not in (0, " << MostRadiusMm
                  << "] mm or a point that is not finite; ValidateSegmentationRecipe says which");
    return false;
  }
  Internals& self = *this->Self;
  self.shown.resize(strokes.size());
  for (std::size_t n = 0; n < strokes.size(); ++n)
  {
    std::unique_ptr<ShownStroke>& one = self.shown[n];
    if (!one || !one->Begins(strokes[n]))
    {
      one = std::make_unique<ShownStroke>(strokes[n]);
      self.Colour(*one);
    }
    self.made += one->Grow(strokes[n]);
  }
  this->Modified();
  return true;
}

void vtkHaspStrokeActor::ClearStrokes()
{
  this->SetStrokes({});
}

int vtkHaspStrokeActor::GetNumberOfStrokes() const
{
  return static_cast<int>(this->Self->shown.size());
}

vtkIdType vtkHaspStrokeActor::GetNumberOfBallsMade() const
{
  return this->Self->made;
}

void vtkHaspStrokeActor::SetLabelColor(int label, double r, double g, double b)
{
  const glm::dvec3 colour(r, g, b);
  if (!hasp::IsColour(label, colour))
  {
    vtkErrorMacro(<< "Label " << label << " cannot have the colour " << r << ", " << g << ", " << b
                  << "; labels are in [0, " << hasp::MaxLabel << "], components in [0, 1]");
    return;
  }
  this->Self->colours[label] = colour;
  for (const auto& one : this->Self->shown)
    this->Self->Colour(*one);
  this->Modified();
}

double* vtkHaspStrokeActor::GetBounds()
{
  vtkBoundingBox all;
  for (const auto& one : this->Self->shown)
  {
    vtkBoundingBox box;
    for (const glm::dvec3& point : one->stroke.points)
      box.AddPoint(point.x, point.y, point.z);
    if (!box.IsValid())
      continue;
    box.Inflate(one->stroke.radiusMm);
    all.AddBox(box);
  }
  if (!all.IsValid())
    return nullptr;
  all.GetBounds(this->Self->bounds);
  return this->Self->bounds;
}

int vtkHaspStrokeActor::RenderOverlay(vtkViewport* viewport)
{
  vtkRenderer* renderer = vtkRenderer::SafeDownCast(viewport);
  if (renderer == nullptr || renderer->GetSelector() != nullptr)
    return 0;
  int drawn = 0;
  for (const auto& one : this->Self->shown)
    if (!one->stroke.points.empty())
      drawn += one->actor->RenderOpaqueGeometry(viewport);
  return drawn > 0 ? 1 : 0;
}

void vtkHaspStrokeActor::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& one : this->Self->shown)
    one->actor->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkHaspStrokeActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfStrokes: " << this->GetNumberOfStrokes() << "\n";
  os << indent << "NumberOfBallsMade: " << this->GetNumberOfBallsMade() << "\n";
}
