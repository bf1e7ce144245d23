// CutFragments <DICOM folder, .inv3, .mha or .vti> <cuts.json> <fragments.ply>
// Cuts the bone of a scan and says what came of it. The recipe's keys: Planning/CutRecipeFile.h.
#include "vtkHaspOsteotomyFilter.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader; // whatever the file: patient LPS, millimetres
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspOsteotomyFilter> saw;
  saw->SetInputConnection(reader->GetOutputPort());
  if (!saw->ReadRecipe(argv[2])) // or SetRecipe, with blades from your own program
    return 1;
  saw->Update(); // cell array "Fragment" says whose each triangle is
  vtkFieldData* measures = saw->GetOutput()->GetFieldData();
  if (vtkDataArray* volumes = measures->GetArray("FragmentVolumeMm3"))
    for (vtkIdType n = 0; n < volumes->GetNumberOfTuples(); ++n)
      std::cout << "fragment " << n + 1 << ": " << volumes->GetComponent(n, 0) << " mm3\n";
  vtkNew<vtkHaspSurfaceWriter> writer; // refuses an empty result: what went wrong is reported
  writer->SetInputConnection(saw->GetOutputPort());
  writer->SetFileName(argv[3]);
  return writer->Write() ? 0 : 1;
}
