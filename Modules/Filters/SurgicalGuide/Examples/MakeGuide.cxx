// MakeGuide <DICOM folder, .inv3, .mha or .vti> <recipe.json> <guide.stl>
// Makes a surgical guide that fits the bone of a scan. The recipe's keys:
// Planning/GuideRecipeFile.h.
#include "vtkHaspGuideFilter.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"

#include "vtkNew.h"

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4)
    return 1;
  vtkNew<vtkHaspVolumeReader> reader; // whatever the file: patient LPS, millimetres
  reader->SetFileName(argv[1]);
  vtkNew<vtkHaspGuideFilter> guide;
  guide->SetInputConnection(reader->GetOutputPort());
  if (!guide->ReadRecipe(argv[2])) // or SetRecipe, with landmarks from your own program
    return 1;
  vtkNew<vtkHaspSurfaceWriter> writer; // refuses an empty guide: what went wrong has been reported
  writer->SetInputConnection(guide->GetOutputPort());
  writer->SetFileName(argv[3]);
  if (!writer->Write())
    return 1;
  std::cout << "Check it before it is printed: hasp guide --check, or Evaluation/GuideGap.h\n";
}
