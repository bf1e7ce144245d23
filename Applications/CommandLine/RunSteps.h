#pragma once
#include "Planning/SegmentationRecipe.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

/// Label maps of a recipe's steps.
namespace hasp
{

struct Session;

struct StepLabels
{
  vtkSmartPointer<vtkImageData> labels; ///< unsigned short, on the scan's grid
  std::vector<std::string> warnings;    ///< as WarningsOf says them (SegmentationWarnings.h)
  std::string report;                   ///< that says them again (LabelReport.h)
  double milliseconds = 0.0;
};

/// SegmentScan with the verb's progress. `begin`: the labels that the steps begin with; nullptr:
/// none. Throws Failure: BadInput.
StepLabels MakeStepLabels(
  vtkImageData* scan, const SegmentationRecipe& recipe, vtkImageData* begin, Session& session);

} // namespace hasp
