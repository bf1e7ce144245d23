// KeepIsosurface <volume file> <isovalue> <out.hcells>
// Makes the isosurface's active cells, writes them, and follows an edit in a box of the volume.
#include "vtkHaspClusteredCellFilter.h"
#include "vtkHaspClusteredCellWriter.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspVolumeReader.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspClusteredCellFilter> cells; // CompactOn: 8 bits a corner
  cells->SetInputConnection(reader->GetOutputPort());
  cells->SetIsoValue(std::atof(argv[2]));
  vtkNew<vtkHaspClusteredCellWriter> writer; // hasp render, or vtkHaspClusteredCellReader, takes it
  writer->SetInputConnection(cells->GetOutputPort());
  writer->SetFileName(argv[3]);
  if (!writer->Write())
    return 1;
  const vtkIdType before = cells->GetOutput()->GetNumberOfCells();
  reader->GetOutput()->SetScalarComponentFromDouble(1, 1, 1, 0, 10000.0); // a grain of metal
  const int box[6] = { 1, 1, 1, 1, 1, 1 };
  cells->MarkModified(box); // only the blocks at the box are read
  cells->Update();
  std::cout << before << " active cells, " << cells->GetOutput()->GetNumberOfCells()
            << " after the edit\n";
  return 0;
}
