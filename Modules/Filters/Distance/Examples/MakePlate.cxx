// MakePlate <label> <out.stl>
// A plate of 30 x 8 x 1.5 mm with two holes of 2 mm and a label engraved: edges stay edges.
#include "vtkHaspCsg.h"
#include "vtkHaspSharpContour.h"
#include "vtkHaspSolidSource.h"
#include "vtkHaspSurfaceWriter.h"

#include "vtkNew.h"

#include <cstdio>

int main(int argc, char* argv[])
{
  if (argc != 3)
    return std::fputs("MakePlate <label> <out.stl>\n", stderr), 1;
  vtkNew<vtkHaspSolidSource> body, left, right, label;
  const double a[3] = { -11, 0, 0 }, b[3] = { 11, 0, 0 }, up[3] = { 0, 0, 1 };
  body->SetToStadium(a, b, up, 4.0, 1.5);
  const double a0[3] = { -11, 0, -2 }, a1[3] = { -11, 0, 2 }, b0[3] = { 11, 0, -2 },
               b1[3] = { 11, 0, 2 };
  left->SetToCylinder(a0, a1, 1.0);
  right->SetToCylinder(b0, b1, 1.0);
  const double origin[3] = { -8, -1.5, 0.75 }, along[3] = { 1, 0, 0 }, upward[3] = { 0, 1, 0 };
  if (!label->SetToText(argv[1], origin, along, upward, 3.0, 0.5))
    return 1; // what is wrong has been reported
  if (vtkHaspSolidSource::GetTextWidth(argv[1], 3.0) > 17.5)
    return std::fputs("MakePlate: the label does not fit between the holes, 17.5 mm\n", stderr), 1;
  vtkNew<vtkHaspCsg> plate; // the first less all others
  plate->SetOperationToDifference();
  for (vtkHaspSolidSource* part : { body.Get(), left.Get(), right.Get(), label.Get() })
    plate->AddInputConnection(part->GetOutputPort());
  vtkNew<vtkHaspSharpContour> surface;
  surface->SetInputConnection(plate->GetOutputPort());
  surface->SetSpacing(0.2);
  vtkNew<vtkHaspSurfaceWriter> writer;
  writer->SetInputConnection(surface->GetOutputPort());
  writer->SetFileName(argv[2]);
  return writer->Write() ? 0 : 1;
}
