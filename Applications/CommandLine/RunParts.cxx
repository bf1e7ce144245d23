#include "RunParts.h"

#include "CertificateText.h"
#include "Failure.h"
#include "PartCertificate.h"
#include "PlanInput.h"
#include "Session.h"
#include "Version.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Planning/PlanLists.h"
#include "Planning/Sha256.h"
#include "vtkPolyData.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <fstream>
#include <sstream>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

std::string ReadWholeFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file)
    throw Failure(ExitCode::WrongUse, "a part cannot be read back as it was written");
  return bytes.str();
}

Json CutsJson(const RebuiltPart& part)
{
  Json cuts = Json::array();
  for (const PlanCutMeasure& cut : part.cuts)
    cuts.push_back({ { "cut", cut.cut }, { "area_mm2", cut.measure.areaMm2 },
      { "kerf_mm3", cut.measure.kerfMm3 }, { "left_mm2", cut.measure.leftMm2 },
      { "parted", cut.measure.parted } });
  return cuts;
}

Json SegmentsJson(const RebuiltPart& part)
{
  Json segments = Json::array();
  for (const PlanSegment& segment : part.segments)
    segments.push_back({ { "volume_mm3", segment.volumeMm3 }, { "length_mm", segment.cut.lengthMm },
      { "shortest_mm", segment.cut.shortestMm }, { "longest_mm", segment.cut.longestMm },
      { "wedge_radians", segment.cut.wedgeRadians }, { "from_mm", segment.cut.fromMm },
      { "to_mm", segment.cut.toMm } });
  return segments;
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

/// Certifies a file as it was written; its words are in the report.
PartVerdict Certify(const RebuiltPart& part, const std::string& stl, Json& report, Session& session)
{
  const FitCertificate certificate =
    MeasurePart(ReadBack(stl, session), part.check->bone, part.check->claims, session);
  report["verdict"] = certificate.Holds() ? "green" : "red";
  for (const FitFault& fault : certificate.faults)
    report["faults"].push_back(fault.text);
  report["certificate"] = CertificateJson(certificate);
  return certificate.Holds() ? PartVerdict::Holds : PartVerdict::DoesNotHold;
}
} // namespace

std::string NameOfPart(const Plan& plan, PlanId object, const std::string& more)
{
  return std::string(PlanNoun(plan, object)) + "-" + std::to_string(object) + more + ".stl";
}

PartFile MakePart(PlanRebuild& rebuild, const Plan& plan, PlanId object,
  const std::filesystem::path& folder, Session& session)
{
  const std::string called = CalledObject(plan, object);
  session.progress.Step("making " + called);
  const auto start = std::chrono::steady_clock::now();
  RebuiltPart part = TryPlan(ExitCode::BadInput,
    [&]
    {
      return rebuild.Make(object,
        [&](double share)
        {
          session.progress.Share(share);
          return true;
        });
    });
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back({ called,
    part.mesh.points.size() * sizeof(glm::dvec3) + part.mesh.triangles.size() * sizeof(glm::uvec3),
    spent.count(), "made from the plan; released again" });
  const std::string stl = (folder / NameOfPart(plan, object)).string();
  Json report = { { "triangles", part.mesh.triangles.size() }, { "volume_mm3", part.volumeMm3 } };
  if (!part.cuts.empty())
    report["cuts"] = CutsJson(part);
  if (!part.segments.empty())
    report["segments"] = SegmentsJson(part);
  report["verdict"] = "not certified";
  report["faults"] = Json::array();
  WriteSurface(MakePolyData(part.mesh), stl, LabelOf(plan, object, part.inputs),
    [&](const std::string& file)
    { return part.check ? Certify(part, file, report, session) : PartVerdict::Holds; });
  report["program"] = std::string("hasp ") + Version() + ", commit " + Commit();
  report["intended_use"] = "research use only, not a medical device";
  return { object, std::move(part.inputs), ReadWholeFile(stl), report.dump(2) + "\n", true };
}

std::vector<std::string> FaultsOf(const Plan& plan, const PartFile& part)
{
  std::vector<std::string> faults;
  const Json report = Json::parse(part.report);
  for (const Json& fault : report.at("faults"))
    faults.push_back(CalledObject(plan, part.object) + ": " + fault.get<std::string>());
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
    json.update(Json::parse(part.report));
    list.push_back(std::move(json));
  }
  const Json run = { { "format", "hasp-run-1" }, { "plan_hash", PlanHash(plan) },
    { "parts", std::move(list) } };
  return run.dump(2) + "\n";
}

} // namespace hasp
