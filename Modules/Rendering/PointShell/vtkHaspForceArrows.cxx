#include "vtkHaspForceArrows.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkHaspForceArrows);

namespace
{

constexpr int Sides = 16;
constexpr double ShaftRadius = 0.03, HeadRadius = 0.1, HeadLength = 0.25; // of the length

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// One mesh of all arrows, with normals.
class ArrowMesh
{
public:
  vtkNew<vtkPolyData> Data;

  ArrowMesh()
  {
    this->Normals->SetNumberOfComponents(3);
    this->Normals->SetName("Normals");
  }

  void Add(const glm::dvec3& at, const glm::dvec3& along)
  {
    const double length = glm::length(along);
    const glm::dvec3 axis = along / length;
    const glm::dvec3 helper = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(axis, helper)), v = glm::cross(axis, u);
    const double neck = (1.0 - HeadLength) * length;
    const auto round =
      [&](double height, double radius, double slope,
        bool flat) { // slope: of the normal along the axis; flat: the normal is the axis, backwards
        std::array<vtkIdType, Sides> ring;
        for (int n = 0; n < Sides; ++n)
        {
          const double angle = 2.0 * vtkMath::Pi() * n / Sides;
          const glm::dvec3 out = std::cos(angle) * u + std::sin(angle) * v;
          ring[n] = this->AddPoint(
            at + height * axis + radius * out, flat ? -axis : glm::normalize(out + slope * axis));
        }
        return ring;
      };
    const double slope = HeadRadius / HeadLength;
    this->AddDisc(round(0.0, ShaftRadius * length, 0.0, true));
    this->AddBand(
      round(0.0, ShaftRadius * length, 0.0, false), round(neck, ShaftRadius * length, 0.0, false));
    this->AddDisc(round(neck, HeadRadius * length, 0.0, true));
    this->AddBand(round(neck, HeadRadius * length, slope, false), round(length, 0.0, slope, false));
  }

  void Finish()
  {
    this->Data->SetPoints(this->Points);
    this->Data->SetPolys(this->Polygons);
    this->Data->GetPointData()->SetNormals(this->Normals);
  }

private:
  vtkIdType AddPoint(const glm::dvec3& point, const glm::dvec3& normal)
  {
    this->Normals->InsertNextTuple3(normal.x, normal.y, normal.z);
    return this->Points->InsertNextPoint(point.x, point.y, point.z);
  }
  void AddDisc(const std::array<vtkIdType, Sides>& ring)
  {
    std::array<vtkIdType, Sides> backwards;
    std::reverse_copy(ring.begin(), ring.end(), backwards.begin());
    this->Polygons->InsertNextCell(Sides, backwards.data());
  }
  void AddBand(const std::array<vtkIdType, Sides>& low, const std::array<vtkIdType, Sides>& high)
  {
    for (int n = 0; n < Sides; ++n)
    {
      const int next = (n + 1) % Sides;
      const vtkIdType corners[4] = { low[n], low[next], high[next], high[n] };
      this->Polygons->InsertNextCell(4, corners);
    }
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkCellArray> Polygons;
};

} // namespace

vtkHaspForceArrows::vtkHaspForceArrows() = default;
vtkHaspForceArrows::~vtkHaspForceArrows() = default;

void vtkHaspForceArrows::SetArrows(std::vector<hasp::ForceArrow> arrows)
{
  this->Arrows = std::move(arrows);
  this->UpdateMesh();
}

void vtkHaspForceArrows::SetArrows(vtkPoints* at, vtkDataArray* forces)
{
  std::vector<hasp::ForceArrow> arrows;
  if (at && forces &&
      (forces->GetNumberOfComponents() != 3 ||
        forces->GetNumberOfTuples() != at->GetNumberOfPoints()))
    vtkErrorMacro("Forces are " << forces->GetNumberOfTuples() << " tuples of "
                                << forces->GetNumberOfComponents() << " components for "
                                << at->GetNumberOfPoints()
                                << " points; give one of 3 components for each point.");
  else if (at && forces)
    for (vtkIdType n = 0; n < at->GetNumberOfPoints(); ++n)
    {
      hasp::ForceArrow& arrow = arrows.emplace_back();
      at->GetPoint(n, &arrow.atMm.x);
      forces->GetTuple(n, &arrow.forceN.x);
    }
  this->SetArrows(std::move(arrows));
}

void vtkHaspForceArrows::SetMmPerNewton(double length)
{
  if (!(length > 0.0) || !std::isfinite(length))
  {
    vtkErrorMacro("MmPerNewton cannot be " << length << "; it is a length above 0.");
    return;
  }
  if (length == this->MmPerNewton)
    return;
  this->MmPerNewton = length;
  this->UpdateMesh();
}

void vtkHaspForceArrows::SetMaximumMm(double length)
{
  if (!(length >= 0.0) || !std::isfinite(length))
  {
    vtkErrorMacro("MaximumMm cannot be " << length << "; it is a length, or 0 for no limit.");
    return;
  }
  if (length == this->MaximumMm)
    return;
  this->MaximumMm = length;
  this->UpdateMesh();
}

void vtkHaspForceArrows::UpdateMesh()
{
  this->Drawn = 0;
  for (std::size_t n = 0; n < this->Arrows.size(); ++n)
  {
    const hasp::ForceArrow& arrow = this->Arrows[n];
    if (!IsFinite(arrow.atMm) || !IsFinite(arrow.forceN))
    {
      vtkErrorMacro("Force " << n << " of " << this->Arrows.size()
                             << " is not finite, or acts at no finite point; no arrow is drawn.");
      this->SetMapper(nullptr);
      return;
    }
  }
  ArrowMesh mesh;
  for (const hasp::ForceArrow& arrow : this->Arrows)
  {
    const double newtons = glm::length(arrow.forceN);
    const double length = this->MmPerNewton * newtons;
    if (!(length > 1e-12)) // mm; nothing to be seen, and no direction
      continue;
    const double shown = this->MaximumMm > 0.0 ? std::min(length, this->MaximumMm) : length;
    mesh.Add(arrow.atMm, arrow.forceN * (shown / newtons));
    ++this->Drawn;
  }
  if (this->Drawn == 0)
  {
    this->SetMapper(nullptr);
    return;
  }
  mesh.Finish();
  auto* mapper = vtkPolyDataMapper::SafeDownCast(this->GetMapper());
  if (!mapper)
  {
    vtkNew<vtkPolyDataMapper> made;
    this->SetMapper(made);
    mapper = made;
  }
  mapper->SetInputData(mesh.Data);
  this->Modified();
}
