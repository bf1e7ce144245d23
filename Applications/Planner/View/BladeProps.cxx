#include "View/BladeProps.h"

#include "Model/PlanSession.h"
#include "Planning/PlanLists.h"
#include "View/SceneView.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

namespace hasp
{
namespace
{

const glm::dvec3 BladeColour{ 0.95, 0.50, 0.10 }, SelectedBladeColour{ 1.0, 0.80, 0.25 };
constexpr double BladeOpacity = 0.2, SelectedBladeOpacity = 0.4;
constexpr float EdgeWidth = 1.5F; ///< pixels

/// The sides of a box, turned outwards, and its edges; corner bits: 1 along, 2 depth, 4 normal.
constexpr vtkIdType Sides[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
  { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

constexpr vtkIdType Edges[12][2] = { { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 }, { 0, 2 }, { 1, 3 },
  { 4, 6 }, { 5, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };

vtkSmartPointer<vtkPoints> CornersOf(const Osteotomy& blade)
{
  const glm::dvec3 along = 0.5 * blade.widthMm * blade.along;
  const glm::dvec3 depth = 0.5 * blade.depthMm * glm::cross(blade.normal, blade.along);
  const glm::dvec3 normal = 0.5 * blade.kerfMm * blade.normal;
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at = blade.point + (corner & 1 ? along : -along) +
                          (corner & 2 ? depth : -depth) + (corner & 4 ? normal : -normal);
    points->InsertNextPoint(at.x, at.y, at.z);
  }
  return points;
}

template <std::size_t Cells, std::size_t Corners>
vtkSmartPointer<vtkCellArray> CellsOf(const vtkIdType (&corners)[Cells][Corners])
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& cell : corners)
    cells->InsertNextCell(Corners, cell);
  return cells;
}

vtkSmartPointer<vtkPolyData> BoxOf(const Osteotomy& blade)
{
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(CornersOf(blade));
  box->SetPolys(CellsOf(Sides));
  return box;
}

vtkSmartPointer<vtkPolyData> EdgesOf(const Osteotomy& blade)
{
  auto edges = vtkSmartPointer<vtkPolyData>::New();
  edges->SetPoints(CornersOf(blade));
  edges->SetLines(CellsOf(Edges));
  return edges;
}

} // namespace

bool BladeProps::Sync()
{
  const Plan& plan = this->Of.plan.Now();
  bool changed = std::erase_if(this->Entries, [&](const auto& entry)
                   { return !FindPlanObject<PlanCut>(plan, entry.first); }) > 0;
  for (const PlanCut& cut : plan.cuts)
  {
    const bool visible = this->Of.isVisible(cut.id), selected = this->Of.selected == cut.id;
    BladeEntry& entry = this->Entries[cut.id];
    if (visible && (!entry.shown || entry.blade != cut.blade))
    {
      entry.blade = cut.blade;
      entry.shown = std::make_unique<MeshProp>(this->Of.view, BoxOf(cut.blade));
      entry.edges = std::make_unique<MeshProp>(this->Of.view, EdgesOf(cut.blade));
      entry.edges->Actor()->GetProperty()->LightingOff();
      entry.edges->Actor()->GetProperty()->SetLineWidth(EdgeWidth);
      changed = true;
    }
    if (!entry.shown)
      continue;
    const glm::dvec3& colour = selected ? SelectedBladeColour : BladeColour;
    entry.shown->SetLook({ colour, selected ? SelectedBladeOpacity : BladeOpacity, selected });
    entry.edges->SetLook({ colour, 1.0, selected });
    entry.edges->SetVisible(visible);
    entry.shown->SetVisible(visible);
  }
  return changed;
}

void BladeProps::Prepare()
{
  for (const auto& [id, entry] : this->Entries)
    if (entry.shown)
    {
      vtkActor* box = entry.shown->Actor();
      entry.edges->Actor()->SetUserMatrix(box->GetUserMatrix());
      entry.edges->SetVisible(
        entry.shown->IsVisible() && this->Of.view.Renderer()->HasViewProp(box));
    }
}

void BladeProps::ListResources(ResourceList& list) const
{
  for (const auto& [id, entry] : this->Entries)
    if (entry.shown)
      entry.shown->ListResourcesAs(CalledObject(this->Of.plan.Now(), id), list);
    else
      list.push_back({ CalledObject(this->Of.plan.Now(), id), 0, 0.0, "hidden" });
}

} // namespace hasp
