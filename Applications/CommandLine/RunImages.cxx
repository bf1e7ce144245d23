#include "RunImages.h"

#include "PlanInput.h"
#include "Session.h"
#include "VolumeInput.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

namespace hasp
{
namespace
{

void Use(RunImages& images, PlanId id, const LoadedVolume& read)
{
  images.loaded.push_back(read);
  images.images.emplace(id, ViewImage(read.image));
}

/// Takes what it finds out of `missing`.
void ReadScan(const Plan& plan, const std::string& file, std::size_t number,
  std::set<PlanId>& missing, RunImages& images, Session& session)
{
  VolumeChoices choices;
  choices.input = file;
  choices.hash = true;
  const LoadedVolume read = ReadVolume(choices, session);
  bool used = false;
  for (const PlanVolume& volume : plan.volumes)
    if (missing.contains(volume.id) && volume.hash == read.passport.hash)
    {
      Use(images, volume.id, read);
      missing.erase(volume.id);
      used = true;
    }
  if (used)
    SayWarnings(read.passport, session);
  else
    SayWarning(session, "--volume number " + std::to_string(number) +
                          " is none that the plan still needs; it is not used");
}

void ReadLabels(const PlanDocument& document, PlanId segmentation, const std::string& planFolder,
  const std::filesystem::path& folder, RunImages& images, Session& session)
{
  const std::string place = (folder / "labels.nrrd").string();
  const auto blob = [&]
  {
    return ReadBlob(
      planFolder, LabelMapOf(document.history.Current(), document.parts, segmentation));
  };
  WriteBytes(Try(ExitCode::BadInput, "", blob), place);
  VolumeChoices choices;
  choices.input = place;
  Use(images, segmentation, ReadVolume(choices, session));
  std::filesystem::remove(place);
}
} // namespace

RunImages ReadRunImages(const PlanDocument& document, const std::set<PlanId>& needed,
  const std::vector<std::string>& files, const std::string& planFolder,
  const std::filesystem::path& folder, Session& session)
{
  const Plan& plan = document.history.Current();
  RunImages images;
  std::set<PlanId> missing;
  for (const PlanVolume& volume : plan.volumes)
    if (needed.contains(volume.id))
      missing.insert(volume.id);
    else
      session.resources.push_back(
        { CalledObject(plan, volume.id), 0, 0.0, "no part that is made needs it" });
  for (std::size_t n = 0; n < files.size() && !missing.empty(); ++n)
    ReadScan(plan, files[n], n + 1, missing, images, session);
  std::string list;
  for (const PlanId id : missing)
    list += (list.empty() ? "" : ", ") + CalledObject(plan, id);
  if (!list.empty())
    throw Failure(ExitCode::BadInput,
      list + ": not among the files given: no --volume has the hash that the plan names; give the "
             "scan that the plan was made on");
  for (const PlanSegmentation& segmentation : plan.segmentations)
    if (needed.contains(segmentation.id))
      ReadLabels(document, segmentation.id, planFolder, folder, images, session);
  return images;
}

} // namespace hasp
