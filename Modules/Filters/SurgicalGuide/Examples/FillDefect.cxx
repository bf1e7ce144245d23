// FillDefect <head> <leg> <transplant.json> <segments.ply>; a DICOM folder, .inv3, .mha or .vti
// each Fills a defect of the jaw with segments of the fibula. Keys:
// Planning/TransplantRecipeFile.h.
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspTransplantFilter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 5)
    return 1;
  vtkNew<vtkHaspVolumeReader> head, leg; // whatever the files: patient LPS, millimetres
  head->SetFileName(argv[1]);
  leg->SetFileName(argv[2]);
  vtkNew<vtkHaspTransplantFilter> transplant;
  transplant->SetInputConnection(0, head->GetOutputPort());
  transplant->SetInputConnection(1, leg->GetOutputPort());
  if (!transplant->ReadRecipe(argv[3])) // or SetRecipe, with a path from your own program
    return 1;
  transplant->Update(); // output 1: on the donor, 2: the jaw, 3: vessel and skin
  vtkFieldData* measures = transplant->GetOutput()->GetFieldData();
  if (vtkDataArray* lengths = measures->GetArray("SegmentLengthMm"))
    for (vtkIdType n = 0; n < lengths->GetNumberOfTuples(); ++n)
      std::cout << "segment " << n + 1 << ": " << lengths->GetComponent(n, 0) << " mm\n";
  vtkNew<vtkHaspSurfaceWriter> writer; // refuses an empty result: what went wrong is reported
  writer->SetInputConnection(transplant->GetOutputPort());
  writer->SetFileName(argv[4]);
  return writer->Write() ? 0 : 1;
}
