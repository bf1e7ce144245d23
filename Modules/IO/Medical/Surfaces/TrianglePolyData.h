#pragma once
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>

class vtkPolyData;

namespace hasp
{

/// A surface of these triangles. Its points are float32 if that loses nothing, else float64; its
/// cells take 4 bytes a corner and a triangle, half of VTK's usual.
vtkSmartPointer<vtkPolyData> TrianglePolyData(
  std::span<const glm::dvec3> points, std::span<const glm::uvec3> triangles);

/// "float32" or "float64": of the points.
std::string CoordinateType(vtkPolyData* surface);

} // namespace hasp
