#include "VtkRivals.h"

namespace hasp
{
namespace
{

constexpr const char* Why =
  "this VTK lacks FiltersGeneral, FiltersModeling, FiltersPoints or ImagingGeneral";

} // namespace

RivalTransform VtkEuclideanRival()
{
  RivalTransform rival;
  rival.key = "vtk";
  rival.name = "vtkImageEuclideanDistance";
  rival.absent = Why;
  rival.exact = true;
  return rival;
}

RivalTransform VtkPointsRival()
{
  RivalTransform rival;
  rival.key = "vtk.points";
  rival.name = "vtkSignedDistance";
  rival.absent = Why;
  return rival;
}

PlainContour FlyingEdges()
{
  return { "vtkFlyingEdges3D", Why, {} };
}

BooleanRival VtkBooleans()
{
  return { "vtkBooleanOperationPolyDataFilter", Why, {} };
}

} // namespace hasp
