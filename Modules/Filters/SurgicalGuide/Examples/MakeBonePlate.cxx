// MakeBonePlate <DICOM folder, .inv3, .mha or .vti> <recipe.json> <plate.stl>
// Makes a bone plate with countersunk screw holes along landmarks. The recipe's keys:
// Planning/PlateRecipeFile.h.
#include "vtkHaspPlateFilter.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkNew.h"

int main(int argc, char* argv[])
{
  if (argc != 4)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader; // whatever the file: patient LPS, millimetres
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspPlateFilter> plate;
  plate->SetInputConnection(reader->GetOutputPort());
  if (!plate->ReadRecipe(argv[2])) // or SetRecipe, with landmarks from your own program
    return 1;
  vtkNew<vtkHaspSurfaceWriter> writer; // refuses an empty plate: what went wrong has been reported
  writer->SetInputConnection(plate->GetOutputPort());
  writer->SetFileName(argv[3]);
  return writer->Write() ? 0 : 1;
}
