#include "RunImages.h"

#include "PlanInput.h"
#include "Session.h"
#include "VolumeInput.h"
#include "vtkHaspVolumeView.h"

namespace hasp
{
namespace
{

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
      images.Add(volume.id, read.image);
      missing.erase(volume.id);
      used = true;
    }
  if (used)
    SayWarnings(read.passport, session);
  else
    SayWarning(session, "--volume number " + std::to_string(number) +
                          " is none that the plan still needs; it is not used");
}
} // namespace

void RunImages::Add(PlanId id, vtkImageData* image)
{
  this->loaded[id] = image;
  this->images.insert_or_assign(id, ViewImage(image));
}

RunImages ReadScans(const Plan& plan, const std::set<PlanId>& needed,
  const std::vector<std::string>& files, Session& session)
{
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
  return images;
}

} // namespace hasp
