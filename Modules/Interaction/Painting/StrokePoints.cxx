#include "StrokePoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedShortArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

std::vector<glm::dvec3> PointsAlong(const BrushStroke& stroke, double stepMm, std::size_t first)
{
  std::vector<glm::dvec3> along;
  for (std::size_t n = first; n < stroke.points.size(); ++n)
  {
    const glm::dvec3& to = stroke.points[n];
    if (n > first)
    {
      const glm::dvec3& from = stroke.points[n - 1];
      const int parts = std::max(1, int(std::ceil(glm::length(to - from) / stepMm)));
      for (int part = 1; part < parts; ++part)
        along.push_back(from + (to - from) * (double(part) / parts));
    }
    along.push_back(to);
  }
  return along;
}

vtkSmartPointer<vtkPolyData> StrokePolyData(const std::vector<BrushStroke>& strokes)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> verts, lines;
  vtkNew<vtkUnsignedShortArray> labels;
  labels->SetName("Label");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("RadiusMm");
  for (const bool single : { true, false }) // cell data has vertices before lines
    for (const BrushStroke& stroke : strokes)
    {
      if (stroke.points.empty() || (stroke.points.size() == 1) != single)
        continue;
      vtkCellArray* cells = single ? verts : lines;
      cells->InsertNextCell(static_cast<int>(stroke.points.size()));
      for (const glm::dvec3& point : stroke.points)
        cells->InsertCellPoint(points->InsertNextPoint(&point.x));
      labels->InsertNextValue(stroke.label);
      radii->InsertNextValue(stroke.radiusMm);
    }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(verts);
  data->SetLines(lines);
  data->GetCellData()->AddArray(labels);
  data->GetCellData()->AddArray(radii);
  return data;
}

} // namespace hasp
