#pragma once
#include "RunParts.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// The label maps that a run makes its parts of.
namespace hasp
{

struct RunImages;
class RunFaults;

struct LabelMapRun
{
  const PlanDocument& document;
  std::string plan;             ///< as the user names it: a folder keeps what is made
  std::filesystem::path folder; ///< where files lie while they are written or read
  bool rebuild = false;         ///< make label maps that are in date, too
  /// Takes what is made: the segmentation, what it is made of, the bytes of a .nrrd file and their
  /// report (LabelReport.h). Empty: it is kept in the plan (KeepInPlan), where that is a folder.
  std::function<void(
    PlanId, const std::vector<PartInput>&, const std::string& nrrd, const std::string& report)>
    keep{};
};

/// Puts the label maps of all segmentations that `parts` need, of those that are to be made, among
/// the images, which have the segmentations' volumes, unless they are there: those in date are
/// read, those of a recipe's steps made anew where none is, and kept at once, whatever becomes of
/// the parts. One that can be neither read nor made is a fault of all parts that need it ("fragment
/// 5: segmentation 4: …"). What a user must know of one is said as a warning, of one that is in
/// date, too. session.result["label_maps"]: of all with steps, whether they were made.
void AddLabelMaps(const LabelMapRun& run, const std::vector<PartFile>& parts, RunImages& images,
  RunFaults& faults, Session& session);

/// What was found when a label map was made that the plan in `folder` keeps ("steps[1]: …"); where
/// that was not kept, how to hear it. Throws std::runtime_error, with no text of the file, if it is
/// damaged.
std::vector<std::string> KeptWarnings(const PlanSegmentation& segmentation, const DerivedPart& kept,
  const std::filesystem::path& folder);

/// "segmentation 4  label map made", a line each, unless JSON is asked for.
void SayLabelMaps(const Session& session);

} // namespace hasp
