#include "SegmentText.h"

#include "VerbWork.h"
#include "Version.h"
#include "vtkHaspVolumeView.h"

#include "Segmentation/LabelMap.h"
#include "vtkImageData.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace hasp
{

double VoxelMm3(vtkImageData* image)
{
  const glm::dvec3 spacing = ImageGeometry(image).spacing;
  return spacing.x * spacing.y * spacing.z;
}

nlohmann::ordered_json DescribeSegmentation(
  const SegmentationRecipe& recipe, const SegmentedScan& made)
{
  using Json = nlohmann::ordered_json;
  const std::vector<std::size_t> voxels =
    CountLabels(std::get<GridView<const Label>>(ViewImage(made.labels)));
  Json json{ { "labels", Json::array() }, { "steps", Json::array() } };
  for (std::size_t label = 1; label < voxels.size(); ++label)
    if (voxels[label] > 0)
      json["labels"].push_back({ { "label", label }, { "voxels", voxels[label] },
        { "volume_mm3", double(voxels[label]) * VoxelMm3(made.labels) } });
  for (std::size_t n = 0; n < recipe.steps.size(); ++n)
  {
    Json step{ { "step", StepLabel(recipe.steps[n]) } };
    if (const auto* threshold = std::get_if<ThresholdStep>(&recipe.steps[n]))
      step.update({ { "lowest", threshold->lowest }, { "highest", threshold->highest },
        { "smoothMm", threshold->smoothMm } });
    const SegmentationFinding& found = made.findings[n];
    step["changed_voxels"] = found.changed;
    if (found.walk)
      step.update({ { "cycles", found.walk->iterations }, { "error", found.walk->error },
        { "unreached_voxels", found.unreached } });
    json["steps"].push_back(std::move(step));
  }
  json["program"] = std::string("hasp ") + Version() + ", commit " + Commit();
  json["intended_use"] = "research use only, not a medical device";
  return json;
}

void PrintSegmentation(const nlohmann::ordered_json& json)
{
  for (const auto& step : json["steps"])
  {
    std::cout << step["step"].get<std::string>();
    if (step.contains("lowest"))
      std::cout << Line(
        ": %.6g to %.6g", step["lowest"].get<double>(), step["highest"].get<double>());
    if (step.contains("cycles"))
      std::cout << Line(": %d cycles, probabilities within %.1e", step["cycles"].get<int>(),
        step["error"].get<double>());
    std::cout << "\n";
  }
  for (const auto& label : json["labels"])
  {
    const auto voxels = label["voxels"].get<long long>();
    std::cout << Line("label %5d  %12.1f mm3  %10lld voxel%s\n", label["label"].get<int>(),
      label["volume_mm3"].get<double>(), voxels, voxels == 1 ? "" : "s");
  }
}

} // namespace hasp
