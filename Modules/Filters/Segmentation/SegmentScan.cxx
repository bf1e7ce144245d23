#include "Segmenter.h"

#include "vtkHaspLabelTable.h"
#include "vtkHaspVolumeView.h"

#include "Grid/ProgressPart.h"
#include "vtkImageData.h"

#include <algorithm>
#include <set>
#include <utility>

namespace hasp
{

void NameLabels(vtkImageData* labels, const std::vector<LabelName>& names, const LabelTable& given)
{
  const std::vector<std::uint16_t> occurring =
    LabelsOf(std::get<GridView<const Label>>(ViewImage(labels)));
  LabelTable table;
  std::set<std::uint16_t> named;
  for (const LabelName& name : names)
  {
    table.push_back({ name.label, name.name, name.colour });
    named.insert(name.label);
  }
  for (const LabelEntry& entry : given)
    if (std::binary_search(occurring.begin(), occurring.end(), entry.value) &&
        named.insert(entry.value).second)
      table.push_back(entry);
  SetLabelTable(labels, WithUnnamedLabels(std::move(table), occurring));
}

SegmentedScan SegmentScan(vtkImageData* scan, const SegmentationRecipe& recipe,
  vtkImageData* labels, const RandomWalkerSettings& settings, const ProgressFunction& progress)
{
  ValidateSegmentationRecipe(recipe);
  const LabelTable given = labels ? GetLabelTable(labels) : LabelTable();
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
  NameLabels(result.labels, recipe.names, given);
  return result;
}

} // namespace hasp
