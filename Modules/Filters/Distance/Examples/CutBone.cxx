// CutBone <volume> <isovalue> <x> <y> <z> <kerf mm> <out.stl>
// The bone of a scan, cut in two by a saw whose kerf runs through a place, upright on the x axis.
#include "vtkHaspCsg.h"
#include "vtkHaspSharpContour.h"
#include "vtkHaspSignedDistance.h"
#include "vtkHaspSolidSource.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"
#include "vtkNew.h"
#include <cstdio>

int main(int argc, char* argv[])
{
  double v[5]; // isovalue, place, kerf
  auto number = [&, rest = char(0)](int n) mutable
  { return std::sscanf(argv[n + 2], "%lf%c", &v[n], &rest) == 1; };
  if (argc != 8 || !(number(0) && number(1) && number(2) && number(3) && number(4)))
    return std::fputs("CutBone <volume> <isovalue> <x> <y> <z> <kerf mm> <out.stl>\n", stderr), 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspSignedDistance> bone; // of the grey values as they are
  bone->SetInputConnection(reader->GetOutputPort());
  bone->SetInputKindToGrey();
  bone->SetIsoValue(v[0]);
  const double normal[3] = { 1, 0, 0 };
  vtkNew<vtkHaspSolidSource> saw;
  saw->SetToSlab(v + 1, normal, v[4]); // refused: no shape, so nothing is written
  vtkNew<vtkHaspCsg> cut;
  cut->SetOperationToDifference();
  cut->AddInputConnection(bone->GetOutputPort());
  cut->AddInputConnection(saw->GetOutputPort());
  vtkNew<vtkHaspSharpContour> surface;
  surface->SetInputConnection(cut->GetOutputPort());
  surface->SetSpacing(0.8);
  vtkNew<vtkHaspSurfaceWriter> writer;
  writer->SetInputConnection(surface->GetOutputPort());
  writer->SetFileName(argv[7]);
  return writer->Write() ? 0 : 1;
}
