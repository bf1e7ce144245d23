// CutBone <volume file> <isovalue> <x> <y> <z> <kerf mm> <out.stl>
// The bone of a scan, cut in two by a saw whose kerf runs through a place, upright on the x axis.
#include "vtkHaspCsg.h"
#include "vtkHaspSharpContour.h"
#include "vtkHaspSignedDistance.h"
#include "vtkHaspSolidSource.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkNew.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc != 8)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspSignedDistance> bone; // of the grey values as they are
  bone->SetInputConnection(reader->GetOutputPort());
  bone->SetInputKindToGrey();
  bone->SetIsoValue(std::atof(argv[2]));
  vtkNew<vtkHaspSolidSource> saw;
  const double normal[3] = { 1, 0, 0 },
               place[3] = { std::atof(argv[3]), std::atof(argv[4]), std::atof(argv[5]) };
  saw->SetToSlab(place, normal, std::atof(argv[6])); // refused: no shape, so nothing is written
  vtkNew<vtkHaspCsg> cut;
  cut->SetOperationToDifference();
  cut->AddInputConnection(bone->GetOutputPort());
  cut->AddInputConnection(saw->GetOutputPort());
  vtkNew<vtkHaspSharpContour> surface;
  surface->SetInputConnection(cut->GetOutputPort());
  surface->SetSpacing(0.8); // a CT's own
  vtkNew<vtkHaspSurfaceWriter> writer;
  writer->SetInputConnection(surface->GetOutputPort());
  writer->SetFileName(argv[7]);
  return writer->Write() ? 0 : 1;
}
