// MeasureBone <volume file> <isovalue>
// How much bone a scan holds, voxels at its surface by the share of them that lies inside.
#include "vtkHaspCoverage.h"
#include "vtkHaspVolumeReader.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <cstdio>
#include <iostream>

int main(int argc, char* argv[])
{
  double isovalue = 0.0;
  char rest = 0; // of what is no number
  if (argc != 3 || std::sscanf(argv[2], "%lf%c", &isovalue, &rest) != 1)
    return std::fputs("MeasureBone <volume file> <isovalue>\n", stderr), 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspCoverage> coverage; // SetLabelArrayName, SetLabel: of one fragment
  coverage->SetInputConnection(reader->GetOutputPort());
  coverage->SetIsoValue(isovalue);
  coverage->Update();
  vtkImageData* image = coverage->GetOutput();
  const vtkIdType voxels = image->GetNumberOfPoints();
  if (voxels == 0)
    return 1; // what went wrong has been reported
  const auto* share = static_cast<const float*>(image->GetScalarPointer());
  double sum = 0.0;
  for (vtkIdType v = 0; v < voxels; ++v)
    sum += share[v];
  const double* spacing = image->GetSpacing();
  std::cout << sum * spacing[0] * spacing[1] * spacing[2] / 1000.0 << " ml\n";
}
