// MakeImplant <DICOM folder, .inv3, .mha or .vti> <recipe.json> <implant.stl>
// Makes an implant for a hole in the skull from its healthy side. The recipe's keys:
// Planning/ImplantRecipeFile.h.
#include "vtkHaspImplantFilter.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkNew.h"

int main(int argc, char* argv[])
{
  if (argc != 4)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader; // whatever the file: patient LPS, millimetres
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspImplantFilter> implant;
  implant->SetInputConnection(reader->GetOutputPort());
  if (!implant->ReadRecipe(argv[2])) // or SetRecipe, with an outline from your own program
    return 1;
  vtkNew<vtkHaspSurfaceWriter> writer; // refuses an empty one: what went wrong has been reported
  writer->SetInputConnection(implant->GetOutputPort());
  writer->SetFileName(argv[3]);
  return writer->Write() ? 0 : 1;
}
