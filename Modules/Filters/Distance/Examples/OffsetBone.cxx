// OffsetBone <volume file> <isovalue> <mm> <out.stl>
// The surface at this distance off the bone of a scan (negative: within it), by VTK's own contour.
// vtkHaspCsg's Offset and vtkHaspSharpContour do the same with edges kept (CutBone).
#include "vtkHaspSignedDistance.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkFlyingEdges3D.h"
#include "vtkNew.h"
#include "vtkReverseSense.h"

#include <algorithm>
#include <cstdio>

int main(int argc, char* argv[])
{
  double isovalue = 0.0, mm = 0.0;
  char rest = 0; // of what is no number
  if (argc != 5 || std::sscanf(argv[2], "%lf%c", &isovalue, &rest) != 1 ||
      std::sscanf(argv[3], "%lf%c", &mm, &rest) != 1)
    return std::fputs("OffsetBone <volume file> <isovalue> <mm> <out.stl>\n", stderr), 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspSignedDistance> distance; // mm, negative inside: any VTK filter takes it
  distance->SetInputConnection(reader->GetOutputPort());
  distance->SetInputKindToGrey();
  distance->SetIsoValue(isovalue);
  distance->SetMargin(std::max(mm, 0.0)); // room beyond the scan; bone that goes on is closed there
  vtkNew<vtkFlyingEdges3D> contour;       // takes high values as inside: its triangles look inwards
  contour->SetInputConnection(distance->GetOutputPort());
  contour->SetValue(0, mm);
  contour->ComputeNormalsOff();
  vtkNew<vtkReverseSense> surface;
  surface->SetInputConnection(contour->GetOutputPort());
  vtkNew<vtkHaspSurfaceWriter> writer;
  writer->SetInputConnection(surface->GetOutputPort());
  writer->SetFileName(argv[4]);
  return writer->Write() ? 0 : 1;
}
