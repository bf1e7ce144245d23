#include "RunLabels.h"

#include "KeptParts.h"
#include "LabelReport.h"
#include "PlanInput.h"
#include "RunFaults.h"
#include "RunImages.h"
#include "RunSegments.h"
#include "RunSteps.h"
#include "Session.h"
#include "VerbWork.h"
#include "VolumeInput.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspOutputFile.h"

#include <iostream>
#include <map>
#include <new>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

/// What lies in the folder that is being written, and must not stay there.
struct PassingFile
{
  fs::path place;
  ~PassingFile()
  {
    std::error_code ignored; // the folder is left out, or its name says what is left over
    fs::remove(this->place, ignored);
  }
};

class LabelMaps
{
public:
  LabelMaps(const LabelMapRun& run, RunImages& images, RunFaults& faults, Session& session)
    : Run(run),
      Now(run.document.history.Current()),
      Images(images),
      Faults(faults),
      Shared(session)
  {
  }

  /// Throws what reading and making throw.
  void Add(const PlanSegmentation& segmentation)
  {
    if (segmentation.recipe.steps.empty())
    {
      const std::string hash = Try(ExitCode::BadInput, "",
        [&] { return LabelMapOf(this->Now, this->Run.document.parts, segmentation.id); });
      this->Images.Add(segmentation.id, this->Read(hash));
      return;
    }
    vtkSmartPointer<vtkImageData> labels = this->Take(segmentation);
    this->Shared.result["label_maps"].push_back(
      { { "segmentation", segmentation.id }, { "made", !labels } });
    if (!labels)
      labels = this->Make(segmentation);
    this->Images.Add(segmentation.id, labels);
  }

private:
  vtkSmartPointer<vtkImageData> Read(const std::string& hash)
  {
    const PassingFile file{ this->Run.folder / "labels.nrrd" };
    const auto blob = [&] { return ReadBlob(PlanFolder(this->Run.plan), hash); };
    WriteBytes(Try(ExitCode::BadInput, "", blob), file.place.string());
    VolumeChoices choices;
    choices.input = file.place.string();
    return ReadVolume(choices, this->Shared).image;
  }

  /// nullptr: it must be made.
  vtkSmartPointer<vtkImageData> Take(const PlanSegmentation& segmentation)
  {
    const DerivedPart* kept =
      PartInDate(this->Now, this->Run.document.parts, segmentation.id, PartFormat::Nrrd);
    if (!kept || this->Run.rebuild)
      return nullptr;
    const std::string called = CalledObject(this->Now, segmentation.id);
    try
    {
      const std::vector<std::string> warnings =
        KeptWarnings(segmentation, *kept, PlanFolder(this->Run.plan));
      vtkSmartPointer<vtkImageData> labels = this->Read(kept->bytes);
      this->Shared.resources.push_back(
        { called, 0, 0.0, "in date: its label map was not made again" });
      this->Say(called, warnings);
      return labels;
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      SayWarning(this->Shared, called + ": its label map is made anew: " + SafeText(error));
      return nullptr;
    }
  }

  vtkSmartPointer<vtkImageData> Make(const PlanSegmentation& segmentation)
  {
    const std::string called = CalledObject(this->Now, segmentation.id);
    vtkSmartPointer<vtkImageData> begin;
    if (!segmentation.labels.empty())
      begin = this->Read(segmentation.labels);
    this->Shared.progress.Step("making the label map of " + called);
    vtkImageData* scan = this->Images.loaded.at(segmentation.volume);
    const StepLabels made = MakeStepLabels(scan, segmentation.recipe, begin, this->Shared);
    const bool keeps = this->Run.keep || IsPlanFolder(this->Run.plan);
    this->Shared.resources.push_back({ called,
      std::size_t(made.labels->GetNumberOfPoints()) * sizeof(std::uint16_t), made.milliseconds,
      std::string("label map, made of its steps; the plan ") +
        (keeps ? "keeps it" : "is only read") });
    this->Say(called, made.warnings);
    if (keeps)
      this->Keep(segmentation.id, made);
    return made.labels;
  }

  void Say(const std::string& called, const std::vector<std::string>& warnings)
  {
    for (const std::string& warning : warnings)
      SayWarning(this->Shared, called + ": " + warning);
  }

  /// Without the names of labels, which are the user's words and do not put it out of date.
  void Keep(PlanId id, const StepLabels& made)
  {
    const PassingFile file{ this->Run.folder / "labels.nrrd" };
    try // the parts can be made all the same
    {
      Try(ExitCode::WrongUse, "", [&] { WriteLabels(made.labels, {}, file.place.string()); });
      const std::vector<PartInput> inputs = LabelInputs(this->Now, id);
      const std::string nrrd = ReadWholeFile(file.place.string());
      if (this->Run.keep)
        this->Run.keep(id, inputs, nrrd, made.report);
      else
        KeepInPlan(this->Run.plan, id, inputs, nrrd, made.report);
    }
    catch (const Failure& failure)
    {
      this->Faults.Add(failure);
    }
    catch (const std::bad_alloc&)
    {
      this->Faults.Add(Failure(ExitCode::BadInput,
        CalledObject(this->Now, id) + ": there is not enough memory to keep its label map"));
    }
  }

  const LabelMapRun& Run;
  const Plan& Now;
  RunImages& Images;
  RunFaults& Faults;
  Session& Shared;
};
} // namespace

void AddLabelMaps(const LabelMapRun& run, const std::vector<PartFile>& parts, RunImages& images,
  RunFaults& faults, Session& session)
{
  const Plan& plan = run.document.history.Current();
  std::map<PlanId, std::vector<PlanId>> users; // of images
  for (const PartFile& part : parts)
    if (part.made)
      for (const PlanId image : ImagesOf(plan, part.object))
        users[image].push_back(part.object);
  LabelMaps maps(run, images, faults, session);
  session.result["label_maps"] = nlohmann::ordered_json::array();
  for (const PlanSegmentation& segmentation : plan.segmentations)
  {
    if (images.images.contains(segmentation.id))
      continue;
    const std::string called = CalledObject(plan, segmentation.id);
    if (!users.contains(segmentation.id))
    {
      session.resources.push_back({ called, 0, 0.0, "no part that is made needs it" });
      continue;
    }
    const auto fail = [&](ExitCode code, const std::string& why)
    {
      const std::string text = why.starts_with(called + ": ") ? why : called + ": " + why;
      for (const PlanId part : users.at(segmentation.id))
        faults.Add(plan, part, code, text);
    };
    try
    {
      maps.Add(segmentation);
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const Failure& failure)
    {
      fail(failure.code, failure.what());
    }
    catch (const std::exception& error) // such as memory, or the disk
    {
      fail(ExitCode::BadInput, SafeText(error));
    }
  }
}

std::vector<std::string> KeptWarnings(
  const PlanSegmentation& segmentation, const DerivedPart& kept, const fs::path& folder)
{
  if (kept.report.empty())
    return { "its label map was kept without what was found on it: hasp run --rebuild says it" };
  return WarningsOfReport(segmentation.recipe, ReadBlob(folder, kept.report));
}

void SayLabelMaps(const Session& session)
{
  if (!session.json)
    for (const nlohmann::ordered_json& map : session.result.at("label_maps"))
      std::cout << "segmentation " << map.at("segmentation") << "  label map "
                << (map.at("made").get<bool>() ? "made" : "in date") << "\n";
}

} // namespace hasp
