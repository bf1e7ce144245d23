// OffsetBone <volume file> <isovalue> <mm> <out.stl>
// The surface at this distance off the bone of a scan (negative: within it). Open where bone goes
// on at the scan's end; vtkHaspCsg's Offset and vtkHaspSharpContour close it (CutBone).
#include "vtkHaspCoverage.h"
#include "vtkHaspSignedDistance.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkFlyingEdges3D.h"
#include "vtkNew.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc != 5)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspCoverage> coverage;
  coverage->SetInputConnection(reader->GetOutputPort());
  coverage->SetIsoValue(std::atof(argv[2]));
  vtkNew<vtkHaspSignedDistance> distance; // mm, negative inside: any VTK filter takes it
  distance->SetInputConnection(coverage->GetOutputPort());
  distance->SetInputKindToCoverage();
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputConnection(distance->GetOutputPort());
  surface->SetValue(0, std::atof(argv[3]));
  vtkNew<vtkHaspSurfaceWriter> writer;
  writer->SetInputConnection(surface->GetOutputPort());
  writer->SetFileName(argv[4]);
  return writer->Write() ? 0 : 1;
}
