#include "View/FragmentWork.h"

#include "FragmentImage.h"
#include "Grid/ProgressPart.h"
#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "PlanFragmentLabels.h"
#include "Planning/DerivedPart.h"
#include "Planning/PlanLists.h"
#include "View/BlobFile.h"
#include "View/SceneLayer.h"
#include "vtkHaspVolumeView.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <new>
#include <stdexcept>

namespace hasp
{
namespace
{

vtkSmartPointer<vtkImageData> ToVtk(const FragmentImage& image)
{
  return std::visit(
    [&](const auto& samples) { return MakeImage(image.geometry, samples); }, image.samples);
}

/// The boxes of the blades that have made a piece.
std::vector<SawnBox> SawnBoxes(const Plan& plan, PlanId fragment)
{
  std::vector<SawnBox> boxes;
  for (const PlanId id : CutsOfPiece(plan, fragment))
  {
    const Osteotomy& blade = FindPlanObject<PlanCut>(plan, id)->blade;
    boxes.push_back(
      { blade.point, glm::dmat3(blade.along, glm::cross(blade.normal, blade.along), blade.normal),
        0.5 * glm::dvec3(blade.widthMm, blade.depthMm, blade.kerfMm) });
  }
  return boxes;
}

/// Fragments by their scans.
std::map<PlanId, std::vector<PlanId>> ByVolume(
  const Plan& plan, const std::vector<PlanId>& fragments)
{
  std::map<PlanId, std::vector<PlanId>> found;
  for (const PlanId fragment : fragments)
    found[VolumeOfFragment(plan, fragment)].push_back(fragment);
  return found;
}

void MakeOfVolume(const VoxelWork& work, PlanId volume, const std::vector<PlanId>& fragments,
  MadeFragments& made, const ProgressFunction& progress)
{
  const PlanFragmentVoxels voxels =
    PlanFragmentLabels(work.plan, work.images, fragments, PartOf(progress, 0.0, 0.8));
  std::vector<FragmentLevel> levels;
  for (std::size_t n = 0; n < fragments.size(); ++n)
    levels.push_back({ std::uint16_t(n + 1), IsovalueOfFragment(work.plan, fragments[n]),
      SawnBoxes(work.plan, fragments[n]) });
  const AnyGridView& grey = work.images.at(volume);
  const std::vector<FragmentImage> images = FragmentImages(
    grey, { voxels.numbers.data(), GeometryOf(grey) }, levels, PartOf(progress, 0.8, 1.0));
  for (std::size_t n = 0; n < fragments.size(); ++n)
    if (!voxels.faults[n].empty())
      made.faults[fragments[n]] = voxels.faults[n];
    else if (images[n].geometry.Size() == 0)
      made.faults[fragments[n]] = CalledObject(work.plan, fragments[n]) +
                                  ": no bone is left of it: its label is empty, lies below the "
                                  "isovalue, or is all another fragment's";
    else
      made.images[fragments[n]] = ToVtk(images[n]);
}

} // namespace

std::map<PlanId, std::string> LabelMapBlobs(const Plan& plan, std::span<const DerivedPart> parts)
{
  std::map<PlanId, std::string> blobs;
  for (const PlanSegmentation& segmentation : plan.segmentations)
    try
    {
      if (const std::string blob = LabelMapOf(plan, parts, segmentation.id); !blob.empty())
        blobs[segmentation.id] = blob;
    }
    catch (const std::invalid_argument&) // it has to be made anew
    {
    }
  return blobs;
}

FragmentShape ShapeOfFragment(
  const Plan& plan, PlanId fragment, const std::map<PlanId, std::string>& labelMaps)
{
  FragmentShape shape;
  const auto* volume = FindPlanObject<PlanVolume>(plan, VolumeOfFragment(plan, fragment));
  const PlanFragment* now = FindPlanObject<PlanFragment>(plan, fragment);
  if (!volume || !now)
    return shape;
  shape.scan = volume->hash;
  shape.sources.push_back(now->source);
  for (const PlanId id : CutsOfPiece(plan, fragment))
  {
    const PlanCut& cut = *FindPlanObject<PlanCut>(plan, id);
    shape.cuts.emplace_back(cut.blade, cut.reachMm);
  }
  while (const auto* piece = std::get_if<PieceSource>(&now->source))
  {
    for (const PlanFragment& other : plan.fragments)
      if (const auto* sibling = std::get_if<PieceSource>(&other.source);
          sibling && sibling->fragment == piece->fragment && other.id < now->id)
        shape.siblings.push_back(sibling->seed);
    now = FindPlanObject<PlanFragment>(plan, piece->fragment);
    shape.sources.push_back(now->source);
  }
  if (const auto* label = std::get_if<LabelSource>(&now->source))
  {
    const auto map = labelMaps.find(label->segmentation);
    if (map == labelMaps.end())
      return {};
    shape.map = map->second;
  }
  return shape;
}

VoxelWork::VoxelWork(const SceneContext& scene)
  : plan(scene.plan.Now()),
    folder(scene.plan.Folder()),
    blobs(LabelMapBlobs(scene.plan.Now(), scene.plan.Document().parts)),
    labelMaps(scene.labelMaps)
{
  for (const PlanVolume& volume : this->plan.volumes)
    if (const ShelfScan* scan = scene.scans.OfVolume(this->plan, volume.id))
    {
      this->scans[volume.id] = scan->image;
      this->images.insert_or_assign(volume.id, ViewImage(scan->image));
    }
}

void VoxelWork::ReadLabelMaps(std::span<const PlanId> fragments, const ProgressFunction& progress)
{
  for (const PlanId fragment : fragments)
  {
    const PlanFragment* whole = WholeOf(this->plan, fragment);
    const auto* label = whole ? std::get_if<LabelSource>(&whole->source) : nullptr;
    const auto blob = label ? this->blobs.find(label->segmentation) : this->blobs.end();
    if (blob == this->blobs.end() || this->images.contains(label->segmentation))
      continue;
    vtkSmartPointer<vtkImageData>& map = this->labelMaps[blob->second];
    if (!map)
      map = ReadLabelBlob(this->folder, blob->second, progress);
    this->images.insert_or_assign(label->segmentation, ViewImage(map));
  }
}

MadeFragments MakeFragments(
  VoxelWork work, const std::vector<PlanId>& fragments, const ProgressFunction& progress)
{
  MadeFragments made;
  const auto groups = ByVolume(work.plan, fragments);
  const double steps = std::max<double>(1.0, double(groups.size()));
  double done = 0.0;
  for (const auto& [volume, of] : groups)
  {
    try
    {
      work.ReadLabelMaps(of, PartOf(progress, done / steps, done / steps)); // asked, not counted
      MakeOfVolume(work, volume, of, made, PartOf(progress, done / steps, (done + 1.0) / steps));
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      const bool memory = dynamic_cast<const std::bad_alloc*>(&error);
      const std::string why =
        memory ? "there is not enough memory to show it; close other programs" : error.what();
      for (const PlanId fragment : of)
        if (!made.images.contains(fragment) && !made.faults.contains(fragment))
          made.faults[fragment] = CalledObject(work.plan, fragment) + ": " + why;
    }
    ++done;
  }
  made.labelMaps = std::move(work.labelMaps);
  return made;
}

} // namespace hasp
