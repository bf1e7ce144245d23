#pragma once
// What comes of a random plate, through the filter and a file.
#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"
#include "RandomPlates.h"
#include "vtkHaspPlateFilter.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace platetest
{

inline vtkSmartPointer<vtkImageData> Head()
{
  const hasp::GridGeometry grid = hasp::RandomPlateScan();
  return hasp::MakeImage(grid, hasp::SamplePhantom(grid));
}

/// As read back from a binary STL file, welded.
inline hasp::TriangleMesh ThroughFile(vtkPolyData* plate)
{
  // CTest runs cases at the same time, each in a process of its own.
  const std::string path = std::filesystem::temp_directory_path().string() + "/RandomPlate" +
                           std::to_string(getpid()) + ".stl";
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(plate);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  writer->Write();
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->MergingOff();
  reader->Update();
  std::remove(path.c_str());
  return hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput()));
}

/// What the filter says and gives.
struct Made
{
  std::string error;
  hasp::TriangleMesh mesh; ///< empty if there is none

  Made(vtkImageData* head, const hasp::PlateRecipe& recipe)
  {
    vtkNew<vtkCallbackCommand> keep;
    keep->SetClientData(&this->error);
    keep->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
      { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
    vtkNew<vtkHaspPlateFilter> filter;
    filter->AddObserver(vtkCommand::ErrorEvent, keep);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
    filter->SetInputData(head);
    filter->SetRecipe(recipe);
    filter->Update();
    if (filter->GetOutput()->GetNumberOfPolys() > 0)
      this->mesh = ThroughFile(filter->GetOutput());
  }
};

} // namespace platetest
