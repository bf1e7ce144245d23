// MeasureDistance <surface> <closed reference> <steps>
// How deep a surface lies in another, and how far outside, as it is pushed along x mm by mm.
#include "vtkFloatArray.h"
#include "vtkHaspSurfaceDistance.h"
#include "vtkHaspSurfaceReader.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cstdio>

int main(int argc, char* argv[])
{
  int steps = 0;
  char rest = 0; // of what is no number
  if (argc != 4 || std::sscanf(argv[3], "%d%c", &steps, &rest) != 1)
    return std::fputs("MeasureDistance <surface> <closed reference> <steps>\n", stderr), 1;
  vtkNew<vtkHaspSurfaceReader> surface, reference;
  surface->SetFileName(argv[1]);
  reference->SetFileName(argv[2]);
  vtkNew<vtkMatrix4x4> pose; // an actor would have it as its user matrix
  vtkNew<vtkHaspSurfaceDistance> distance;
  distance->SetInputConnection(surface->GetOutputPort());
  distance->SetReferenceConnection(reference->GetOutputPort());
  distance->SetSurfaceToReference(pose);
  for (int n = 0; n < steps; ++n)
  {
    pose->SetElement(0, 3, n);
    distance->Update(); // the reference is sampled the first time alone
    if (distance->GetErrorCode() || distance->GetOutput()->GetNumberOfPoints() == 0)
      return 1;      // what went wrong has been reported
    double range[2]; // for colours: hasp::MakeDistanceColours, of a fixed range
    distance->GetOutput()->GetPointData()->GetScalars()->GetRange(range);
    std::printf("%d mm: %.2f to %.2f mm\n", n, range[0], range[1]);
  }
}
