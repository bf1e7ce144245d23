#pragma once
#include "Output/ReportContents.h"
#include "Planning/Plan.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <map>
#include <optional>
#include <vector>

class vtkImageData;

namespace hasp
{

/// What pictures show of a plan. Immutable while they are drawn.
struct ReportBodies
{
  std::map<PlanId, vtkSmartPointer<vtkPolyData>> fragments; ///< in the scan
  std::map<PlanId, vtkSmartPointer<vtkPolyData>> parts;     ///< where they were made
  std::map<PlanId, vtkSmartPointer<vtkPolyData>> scans;     ///< all bone, where none is a fragment
};

/// The isosurface of a fragment's voxels, or of a scan: bone is value >= isovalue. RENDER or
/// WORKER.
vtkSmartPointer<vtkPolyData> BoneSurface(vtkImageData* image, double isovalue);

/// The middle of the box around a fragment's surface.
std::optional<glm::dvec3> MiddleOf(vtkPolyData* surface);

struct ReportDrawing
{
  std::vector<ReportPicture> pictures;
  QString renderer; ///< "vendor, renderer, OpenGL version" of what drew; empty: nothing did
};

/// From the front, the left, the right and above, 800 x 600 pixels each on white: where the plan
/// has cuts or guides, the bone as it was scanned with the blades and the guides; and the bone as
/// planned, with plates, implants and transplants. One scan's world a picture: a donor's has its
/// own, as scanned alone if guides or cuts are on it. Drawn off-screen, apart from the window, so
/// that it is the same whatever that shows. The same bytes for the same bodies with the same
/// OpenGL. Without OpenGL: no pictures. RENDER; some 0.1 s a picture.
ReportDrawing DrawReport(const Plan& plan, const ReportBodies& bodies);

} // namespace hasp
