#include "Segmenter.h"

#include "vtkHaspLabelTable.h"
#include "vtkHaspVolumeView.h"

#include "Grid/ProgressPart.h"
#include "vtkImageData.h"

#include <algorithm>
#include <utility>

namespace hasp
{

void NameLabels(vtkImageData* labels, const std::vector<LabelName>& names)
{
  LabelTable table;
  for (const LabelName& name : names)
    table.push_back({ name.label, name.name, name.colour });
  SetLabelTable(labels, WithUnnamedLabels(std::move(table),
                          LabelsOf(std::get<GridView<const Label>>(ViewImage(labels)))));
}

SegmentedScan SegmentScan(vtkImageData* scan, const SegmentationRecipe& recipe,
  vtkImageData* labels, const RandomWalkerSettings& settings, const ProgressFunction& progress)
{
  ValidateSegmentationRecipe(recipe);
  Segmenter segmenter(scan, labels);
  segmenter.SetWalkerSettings(settings);
  SegmentedScan result;
  const double part = 1.0 / std::max<std::size_t>(recipe.steps.size(), 1);
  for (std::size_t n = 0; n < recipe.steps.size(); ++n)
  {
    segmenter.Apply(recipe.steps[n], PartOf(progress, part * n, part * (n + 1)));
    result.findings.push_back(segmenter.Finding());
    segmenter.ForgetUndo(); // nobody will take it back
  }
  result.labels = segmenter.Labels();
  NameLabels(result.labels, recipe.names);
  return result;
}

} // namespace hasp
