#include "View/MeasureActor.h"

#include "View/SceneView.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr float LineWidth = 2.5F, PointSize = 9.0F; ///< pixels
constexpr int LetterPixels = 15;
constexpr int ArcSteps = 24;
constexpr double ArcShare = 0.35; ///< of the shorter leg

/// From one leg to the other; nothing where they are one line.
std::vector<glm::dvec3> ArcOf(const std::vector<glm::dvec3>& places)
{
  const glm::dvec3 a = places[0] - places[1], b = places[2] - places[1];
  const double radius = ArcShare * std::min(glm::length(a), glm::length(b));
  if (!(radius > 0.0))
    return {};
  const glm::dvec3 first = glm::normalize(a);
  const glm::dvec3 across = b - glm::dot(b, first) * first;
  const double angle = std::atan2(glm::length(across), glm::dot(b, first));
  if (!(glm::length(across) > 1e-6 * glm::length(b)))
    return {};
  std::vector<glm::dvec3> arc;
  for (int step = 0; step <= ArcSteps; ++step)
  {
    const double turn = angle * step / ArcSteps;
    arc.push_back(
      places[1] + radius * (std::cos(turn) * first + std::sin(turn) * glm::normalize(across)));
  }
  return arc;
}

glm::dvec3 TextPlace(const std::vector<glm::dvec3>& places, const std::vector<glm::dvec3>& arc)
{
  if (places.size() == 2)
    return 0.5 * (places[0] + places[1]);
  return arc.empty() ? places[1] : arc[arc.size() / 2];
}

} // namespace

MeasureActor::MeasureActor(SceneView& view) : SceneActor(view)
{
  this->Drawn->SetInputData(this->Lines);
  this->SetMapper(this->Drawn);
  vtkProperty* property = this->Actor()->GetProperty();
  property->LightingOff();
  property->SetLineWidth(LineWidth);
  property->SetPointSize(PointSize);
  property->RenderPointsAsSpheresOn();
  this->Text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  vtkTextProperty* letters = this->Text->GetTextProperty();
  letters->SetFontSize(int(LetterPixels * view.devicePixelRatioF()));
  letters->BoldOn();
  letters->SetBackgroundColor(0.0, 0.0, 0.0);
  letters->SetBackgroundOpacity(0.55);
  letters->SetJustificationToCentered();
  letters->SetVerticalJustificationToCentered();
  view.Renderer()->AddViewProp(this->Text);
}

MeasureActor::~MeasureActor()
{
  this->MakeCurrent();
  this->In.Renderer()->RemoveViewProp(this->Text); // and off the graphics card
}

void MeasureActor::SetPlaces(const std::vector<glm::dvec3>& places)
{
  if (places == this->Places)
    return;
  this->Places = places;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines, marks;
  const auto add = [&](const std::vector<glm::dvec3>& path, bool marked)
  {
    lines->InsertNextCell(int(path.size()));
    for (const glm::dvec3& p : path)
    {
      const vtkIdType id = points->InsertNextPoint(p.x, p.y, p.z);
      lines->InsertCellPoint(id);
      if (marked)
        marks->InsertNextCell(1, &id);
    }
  };
  add(places, true);
  const std::vector<glm::dvec3> arc =
    places.size() == 3 ? ArcOf(places) : std::vector<glm::dvec3>();
  if (!arc.empty())
    add(arc, false);
  this->Lines->SetPoints(points);
  this->Lines->SetLines(lines);
  this->Lines->SetVerts(marks);
  const glm::dvec3 at = TextPlace(places, arc);
  this->Text->SetPosition(at.x, at.y);
  this->Text->GetPositionCoordinate()->SetValue(at.x, at.y, at.z);
}

void MeasureActor::SetText(const std::string& text)
{
  this->Text->SetInput(text.c_str());
}

void MeasureActor::SetTextLook(const glm::dvec3& colour, bool visible)
{
  this->Text->GetTextProperty()->SetColor(colour.x, colour.y, colour.z);
  this->Text->SetVisibility(visible);
}

void MeasureActor::FollowCover()
{
  this->Text->SetVisibility(this->IsVisible() && this->In.Renderer()->HasViewProp(this->Actor()));
}

bool MeasureActor::DataBounds(double bounds[6]) const
{
  if (this->Places.empty())
    return false;
  this->Lines->GetBounds(bounds);
  return true;
}

void MeasureActor::ListResources(ResourceList& list) const
{
  list.push_back({ "line and text", this->Lines->GetActualMemorySize() * 1024, 0.0, "shown" });
}

} // namespace hasp
