#pragma once
// `hasp segment` on a phantom whose jaw is broken.
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <map>

using nlohmann::json;

class HaspSegment : public HaspTest
{
protected:
  void Phantom(const std::vector<std::string>& more = {})
  {
    std::vector<std::string> words{ "phantom", "--broken", "mandible", "--spacing", "2,2,2",
      "--output", this->Path("jaw.mha") };
    words.insert(words.end(), more.begin(), more.end());
    ASSERT_EQ(RunHasp(words).exitCode, 0);
  }
  HaspRun Segment(const std::vector<std::string>& more, const std::string& output = "case.seg.nrrd")
  {
    std::vector<std::string> words{ "segment", this->Path("jaw.mha"), "--output",
      this->Path(output), "--json" };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  /// Voxels of each label.
  static std::map<int, std::size_t> LabelsOf(const HaspRun& run)
  {
    std::map<int, std::size_t> labels;
    EXPECT_EQ(run.exitCode, 0) << run.err;
    if (run.exitCode != 0)
      return labels;
    const json document = json::parse(run.out);
    for (const json& label : document.at("labels"))
      labels[label.at("label")] = label.at("voxels");
    return labels;
  }
  static std::string Seeds() { return HASP_BROKEN_MANDIBLE_SEEDS; }
};
