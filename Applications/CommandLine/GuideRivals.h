#pragma once
#include "Grid/TriangleMesh.h"
#include "Planning/GuideRecipe.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

namespace hasp
{

/// A scan and the guide that is made on it.
struct GuideSubject
{
  vtkSmartPointer<vtkImageData> image;
  GuideRecipe recipe;
  std::string data; ///< as reports say it
};

struct GapShare
{
  double p95Mm = 0.0;  ///< 95 % of the inner wall are within that of the gap
  double within = 0.0; ///< share of it within 0.1 mm
  double innerWallMm2 = 0.0;
};
GapShare GapOf(const TriangleMesh& mesh, const GuideSubject& subject);

/// What a guide by meshes came to.
struct RivalGuide
{
  std::string ending{}; ///< empty: it came to its end; else "60 s", "exit code 139"
  TriangleMesh mesh{};  ///< welded
  double seconds = 0.0; ///< of surface, shell and Booleans, without reading
};

/// The same guide as one makes it by hand: the bone's mesh (vtkFlyingEdges3D), its patch around the
/// landmarks, two copies of it moved along smoothed normals by gap and thickness and joined along
/// their rims, slots and holes taken off by vtkBooleanOperationPolyDataFilter. In a child process,
/// hasp-guide-rival, since that filter may crash or never end.
RivalGuide MeshBooleanGuide(const GuideSubject& subject);

/// Its time and its errors, in words.
std::string RivalText(const RivalGuide& guide, const GuideSubject& subject);

} // namespace hasp
