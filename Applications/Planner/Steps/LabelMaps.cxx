#include "Steps/LabelMaps.h"

#include "LabelReport.h"
#include "Model/ScanShelf.h"
#include "Planning/DurableFile.h"
#include "Planning/PlanLists.h"
#include "Segmenter.h"
#include "View/BlobFile.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspVolumeView.h"

#include <cstdlib>
#include <limits>
#include <set>
#include <stdexcept>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

/// A file within a folder of its own in the plan's, gone with this.
class PassingFile
{
public:
  explicit PassingFile(const fs::path& folder)
  {
    std::string pattern = (folder / "labels-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      throw std::runtime_error("a label map cannot be stored: no file can be made in the planner's "
                               "own folder; make room on the disk");
    this->Folder = pattern;
  }
  ~PassingFile()
  {
    std::error_code ignored; // it is the planner's own folder, which goes as a whole
    fs::remove_all(this->Folder, ignored);
  }
  PassingFile(const PassingFile&) = delete;
  PassingFile& operator=(const PassingFile&) = delete;
  fs::path Path() const { return this->Folder / "labels.nrrd"; }

private:
  fs::path Folder;
};

const PlanSegmentation& SegmentationOf(const Plan& plan, PlanId id)
{
  const auto* found = FindPlanObject<PlanSegmentation>(plan, id);
  if (!found)
    throw std::runtime_error("segmentation " + std::to_string(id) + " is no longer in the plan");
  return *found;
}

vtkImageData* ScanOf(const PlanSnapshot& snapshot, PlanId volume)
{
  const auto found = snapshot.scans.find(volume);
  if (found == snapshot.scans.end())
    throw std::runtime_error(CalledObject(snapshot.plan, volume) +
                             " is not in memory: locate its file in the step Import");
  return found->second;
}

} // namespace

std::string StoreLabelMap(const fs::path& folder, vtkImageData* labels)
{
  const PassingFile file(folder);
  WriteLabels(labels, {}, file.Path().string());
  return WriteBlob(
    folder, ReadWhole(file.Path(), std::numeric_limits<std::size_t>::max() / 2, "a label map"));
}

MadeLabelMap MakeLabelMap(const Plan& plan, PlanId id, vtkImageData* scan, const fs::path& folder,
  const ProgressFunction& progress)
{
  const PlanSegmentation& segmentation = SegmentationOf(plan, id);
  vtkSmartPointer<vtkImageData> begin;
  if (!segmentation.labels.empty())
    begin = ReadLabelBlob(folder, segmentation.labels, {});
  SegmentedScan made = SegmentScan(scan, segmentation.recipe, begin, {}, progress);
  const double* spacing = scan->GetSpacing();
  MadeLabelMap map;
  map.labels = made.labels;
  map.voxelMm3 = spacing[0] * spacing[1] * spacing[2];
  map.part = { id, PartFormat::Nrrd, LabelInputs(plan, id), StoreLabelMap(folder, made.labels),
    WriteBlob(folder, FormatLabelReport(made.findings, map.voxelMm3)) };
  map.findings = std::move(made.findings);
  return map;
}

PlanSnapshot::PlanSnapshot(
  const PlanDocument& document, const ScanShelf& shelf, std::filesystem::path inFolder)
  : plan(document.history.Current()),
    parts(document.parts),
    folder(std::move(inFolder))
{
  for (const PlanVolume& volume : this->plan.volumes)
    if (const ShelfScan* scan = shelf.Find(volume.hash))
      this->scans[volume.id] = scan->image;
}

SnapshotImages ImagesOfFragments(const PlanSnapshot& snapshot, const std::vector<PlanId>& fragments,
  const ProgressFunction& progress)
{
  SnapshotImages found;
  const auto add = [&](PlanId id, vtkImageData* image)
  {
    found.owned[id] = image;
    found.images.insert_or_assign(id, ViewImage(image));
  };
  std::set<PlanId> wanted;
  for (const PlanId fragment : fragments)
    for (const PlanId image : ImagesOf(snapshot.plan, fragment))
      wanted.insert(image);
  for (const PlanId id : wanted)
  {
    const auto* map = FindPlanObject<PlanSegmentation>(snapshot.plan, id);
    if (!map)
      add(id, ScanOf(snapshot, id));
    else if (map->recipe.steps.empty() ||
             PartInDate(snapshot.plan, snapshot.parts, id, PartFormat::Nrrd))
      add(id, ReadLabelBlob(snapshot.folder, LabelMapOf(snapshot.plan, snapshot.parts, id), {}));
    else
    {
      MadeLabelMap made =
        MakeLabelMap(snapshot.plan, id, ScanOf(snapshot, map->volume), snapshot.folder, progress);
      add(id, made.labels);
      found.made.push_back(std::move(made.part));
    }
  }
  return found;
}

} // namespace hasp
