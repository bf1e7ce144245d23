#include "RunParts.h"

#include "Failure.h"
#include "PartCertificate.h"
#include "PartFormats.h"
#include "PartReport.h"
#include "PlanInput.h"
#include "RunCertificate.h"
#include "RunSegments.h"
#include "Session.h"
#include "TransplantText.h"
#include "Version.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Planning/PlanLists.h"
#include "Planning/Sha256.h"
#include "vtkPolyData.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <optional>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

Json CutsJson(const RebuiltPart& part)
{
  Json cuts = Json::array();
  for (const PlanCutMeasure& cut : part.cuts)
    cuts.push_back({ { "cut", cut.cut }, { "area_mm2", cut.measure.areaMm2 },
      { "kerf_mm3", cut.measure.kerfMm3 }, { "left_mm2", cut.measure.leftMm2 },
      { "parted", cut.measure.parted } });
  return cuts;
}

/// null: the plan names no jaw there.
Json JointsJson(const PlanTransplant& transplant, const std::vector<MadeJoint>& joints)
{
  Json json = Json::array();
  for (const MadeJoint& joint : joints)
    json.push_back(DescribeJoint(joint));
  const auto blank = [](Json& joint)
  {
    for (const char* key :
      { "gap_mm", "overlap_mm", "contact_mm2", "gap_mm2", "overlap_mm2", "step_mm2" })
      joint[key] = nullptr;
  };
  if (transplant.first.fragment == 0)
    blank(json.front());
  if (transplant.last.fragment == 0)
    blank(json.back());
  return json;
}

/// SHA-256 of all that a part is made from: it does not change with what else is in the plan.
std::string HashOfInputs(const std::vector<PartInput>& inputs)
{
  std::string text;
  for (const PartInput& input : inputs)
    text += std::to_string(input.id) + " " + NameOf(input.facet) + " " + input.hash + "\n";
  return Sha256(text);
}

PartLabel LabelOf(const Plan& plan, PlanId object, const std::vector<PartInput>& inputs)
{
  const std::string noun = PlanNoun(plan, object), name = noun + " " + std::to_string(object);
  return { .name = IsPartName(name) ? name : noun, .hash = HashOfInputs(inputs) };
}
} // namespace

std::string NameOfPart(const Plan& plan, PlanId object, const std::string& more)
{
  return StemOfPart(plan, object) + more + ".stl";
}

PartFile MakePart(PlanRebuild& rebuild, const Plan& plan, PlanId object,
  const std::filesystem::path& folder, const PartPages& pages, Session& session)
{
  const std::string called = CalledObject(plan, object);
  session.progress.Step("making " + called);
  const auto start = std::chrono::steady_clock::now();
  RebuiltPart part = Try(ExitCode::BadInput, "",
    [&]
    { return rebuild.Make(object, [&](double share) { return session.progress.Share(share); }); });
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back({ called,
    part.mesh.points.size() * sizeof(glm::dvec3) + part.mesh.triangles.size() * sizeof(glm::uvec3),
    spent.count(), "made from the plan; released again" });
  const std::string stl = (folder / NameOfPart(plan, object)).string();
  Json report = { { "triangles", part.mesh.triangles.size() }, { "volume_mm3", part.volumeMm3 } };
  if (!part.cuts.empty())
    report["cuts"] = CutsJson(part);
  if (const auto* transplant = FindPlanObject<PlanTransplant>(plan, object))
  {
    for (const PlanSegment& segment : part.segments)
      report["segments"].push_back(
        DescribeSegment(segment.cut, segment.volumeMm3, segment.triangles));
    report["joints"] = JointsJson(*transplant, part.joints);
    report["most_gap_mm"] = transplant->mostGapMm;
    report["most_overlap_mm"] = transplant->mostOverlapMm;
  }
  report["warnings"] = part.warnings.size();
  for (const std::string& warning : part.warnings)
    SayWarning(session, called + ": " + warning);
  report["verdict"] = "not certified";
  report["faults"] = Json::array();
  std::optional<CertifiedPart> certified;
  WriteSurface(MakePolyData(part.mesh), stl, LabelOf(plan, object, part.inputs),
    [&](const std::string& file)
    {
      if (!part.check)
        return PartVerdict::Holds;
      certified = CertifyFile(*part.check, file, report, session);
      return certified->certificate.Holds() ? PartVerdict::Holds : PartVerdict::DoesNotHold;
    });
  if (certified)
    WritePartPage(*part.check, *certified, stl, StemOfPart(plan, object), pages, session);
  report["program"] = std::string("hasp ") + Version() + ", commit " + Commit();
  report["intended_use"] = "research use only, not a medical device";
  return { object, std::move(part.inputs), ReadWholeFile(stl), report.dump(2) + "\n", true };
}

std::vector<std::string> FaultsOf(const Plan& plan, const PartFile& part)
{
  std::vector<std::string> faults = ReadPartReport(part.report).faults;
  if (part.made) // these words are ours, too, and say more
    faults = Json::parse(part.report).at("faults").get<std::vector<std::string>>();
  for (std::string& fault : faults)
    fault = CalledObject(plan, part.object) + ": " + fault;
  return faults;
}

std::string WriteParts(const Plan& plan, const std::vector<PartFile>& parts,
  const std::filesystem::path& folder, Session& session)
{
  Json list = Json::array();
  for (const PartFile& part : parts)
  {
    const std::string name = NameOfPart(plan, part.object), file = (folder / name).string();
    WriteBytes(part.stl, file);
    Json json = { { "object", part.object }, { "kind", PlanNoun(plan, part.object) },
      { "file", name }, { "sha256", Sha256(part.stl) } };
    const PlanFragment* fragment = FindPlanObject<PlanFragment>(plan, part.object);
    if (fragment && fragment->scanToPlanned != PlanPose{})
    {
      // Of what the file holds, not of the mesh: so it is the same for a part that was kept.
      TriangleMesh mesh = ReadBack(file, session);
      for (glm::dvec3& point : mesh.points)
        point = fragment->scanToPlanned.Place(point);
      const std::string planned = NameOfPart(plan, part.object, "-planned");
      WriteSurface(
        MakePolyData(mesh), (folder / planned).string(), LabelOf(plan, part.object, part.inputs));
      json["planned"] = { { "file", planned },
        { "sha256", Sha256(ReadWholeFile((folder / planned).string())) } };
    }
    json["inputs"] = Json::array();
    for (const PartInput& input : part.inputs)
      json["inputs"].push_back(
        { { "id", input.id }, { "facet", NameOf(input.facet) }, { "hash", input.hash } });
    AddReport(part.report, json);
    if (const std::string recipe = RecipeOfReport(part.report); !recipe.empty())
    {
      json["recipe"] = StemOfPart(plan, part.object) + ".json";
      WriteBytes(recipe, (folder / json["recipe"].get<std::string>()).string());
    }
    if (FindPlanObject<PlanTransplant>(plan, part.object))
      WriteSegments(plan, part.object, ReadBack(file, session), json,
        LabelOf(plan, part.object, part.inputs), folder);
    list.push_back(std::move(json));
  }
  const Json run = { { "format", "hasp-run-1" }, { "plan_hash", PlanHash(plan) },
    { "parts", std::move(list) } };
  return run.dump(2) + "\n";
}

void WriteRun(const Plan& plan, const std::vector<PartFile>& parts, const std::string& format,
  const std::filesystem::path& folder, Session& session)
{
  const std::string run =
    RunInFormat(WriteParts(plan, parts, folder, session), format, folder, session);
  WriteBytes(run, (folder / "run.json").string());
}

} // namespace hasp
