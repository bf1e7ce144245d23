#include "EvaluateText.h"

#include "VerbWork.h"

#include "vtkHaspPrintableText.h"

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

Json JsonOf(const DirectedDifference& d)
{
  return { { "mean_mm", d.meanMm }, { "rms_mm", d.rmsMm }, { "p50_mm", d.p50Mm },
    { "p95_mm", d.p95Mm }, { "p99_mm", d.p99Mm }, { "max_mm", d.maxMm },
    { "max_at", { d.maxAt.x, d.maxAt.y, d.maxAt.z } }, { "samples", d.samples },
    { "sample_spacing_mm", d.spacingMm } };
}

Json JsonOf(const PoseDifference& p)
{
  return { { "rotation_deg", p.rotationDegrees }, { "translation_mm", p.translationMm },
    { "tre_mean_mm", p.tre.meanMm }, { "tre_rms_mm", p.tre.rmsMm }, { "tre_p95_mm", p.tre.p95Mm },
    { "tre_max_mm", p.tre.maxMm } };
}

/// "abs": of the size alone.
Json JsonOf(const FractureFigures& f)
{
  if (f.samples == 0)
    return {};
  return { { "p50_mm", f.p50Mm }, { "p95_mm", f.p95Mm }, { "p5_mm", f.p5Mm },
    { "mean_mm", f.meanMm }, { "p50_abs_mm", f.p50AbsMm }, { "p95_abs_mm", f.p95AbsMm },
    { "mean_abs_mm", f.meanAbsMm }, { "max_abs_mm", f.maxAbsMm },
    { "max_at", { f.maxAt.x, f.maxAt.y, f.maxAt.z } }, { "area_mm2", f.areaMm2 },
    { "samples", f.samples } };
}

std::string Listed(const char* before, const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
    text += (text.empty() ? before : ", ") + name;
  return text.empty() ? text : text + "\n";
}

/// Nothing of what has no two fragments.
std::string Along(const char* where, const FracturesResult& result)
{
  return result.fractures.empty() && result.unmeasured.empty() ? "" : where + TextOf(result);
}

} // namespace

std::string PrintableName(const std::string& key)
{
  return PrintableText(key);
}

Json JsonOf(const PairResult& result)
{
  Json json{ { "reference", result.reference.empty() ? Json() : Json(result.reference) },
    { "reference_moved", result.referenceMoved }, { "fragments", Json::array() } };
  for (const FragmentResult& f : result.fragments)
  {
    Json one{ { "fragment", f.called }, { "s2s", JsonOf(f.surface.both) },
      { "first_to_second", JsonOf(f.surface.aToB) },
      { "second_to_first", JsonOf(f.surface.bToA) } };
    if (f.pose)
      one["pose"] = JsonOf(*f.pose);
    if (f.aligned)
      one["aligned"] = JsonOf(*f.aligned);
    json["fragments"].push_back(one);
  }
  json["only_in_first"] = result.onlyFirst;
  json["only_in_second"] = result.onlySecond;
  json["first_along_fractures"] = JsonOf(result.firstFractures);
  json["second_along_fractures"] = JsonOf(result.secondFractures);
  return json;
}

std::string TextOf(const PairResult& result)
{
  std::string text = result.reference.empty() ? "no reference: places as they are\n"
                                              : "beside " + result.reference + "\n";
  if (result.referenceMoved)
    text += "the two have moved it differently: all else is said relative to it\n";
  text +=
    "                  surfaces apart, mm                    rotation  translation      TRE, mm\n"
    "                    mean     p95     max                     deg           mm   mean    max\n";
  for (const FragmentResult& f : result.fragments)
  {
    const DirectedDifference& d = f.surface.both;
    text += Line("%-16.40s %7.3f %7.3f %7.3f", f.called.c_str(), d.meanMm, d.p95Mm, d.maxMm);
    const auto pose = [&](const PoseDifference& p)
    {
      text += Line("                 %7.3f      %7.3f %6.3f %6.3f\n", p.rotationDegrees,
        p.translationMm, p.tre.meanMm, p.tre.maxMm);
    };
    if (f.pose)
      pose(*f.pose);
    else
      text += "  not one mesh in two poses: no TRE\n";
    if (f.aligned)
    {
      text += "  aligned as one body                   ";
      pose(*f.aligned);
    }
  }
  return text + Listed("only in the first: ", result.onlyFirst) +
         Listed("only in the second: ", result.onlySecond) +
         Along("in the first, ", result.firstFractures) +
         Along("in the second, ", result.secondFractures);
}

Json JsonOf(const FracturesResult& result)
{
  Json json{ { "fractures", Json::array() }, { "unmeasured", result.unmeasured } };
  for (const FractureResult& f : result.fractures)
    json["fractures"].push_back({ { "first", f.first }, { "second", f.second },
      { "step", JsonOf(f.measured.step) }, { "gap", JsonOf(f.measured.gap) } });
  return json;
}

std::string TextOf(const FracturesResult& result)
{
  std::string text = "along fractures, mm:\n";
  if (result.fractures.empty())
    text += "  no two fragments face each other within reach\n";
  else
    text += "                                    step-off            gap, negative: overlap\n"
            "                              median     p95     max      p5  median     p95   |max|"
            "  face, mm2\n";
  for (const FractureResult& f : result.fractures)
  {
    const FractureFigures &step = f.measured.step, &gap = f.measured.gap;
    text +=
      Line("%-27.60s", (f.first + " to " + f.second).c_str()) +
      (step.samples > 0 ? Line(" %7.3f %7.3f %7.3f", step.p50AbsMm, step.p95AbsMm, step.maxAbsMm)
                        : "    none can be measured") +
      Line(" %7.3f %7.3f %7.3f %7.3f %10.1f\n", gap.p5Mm, gap.p50Mm, gap.p95Mm, gap.maxAbsMm,
        gap.areaMm2);
  }
  for (const std::string& one : result.unmeasured)
    text += "  not measured: " + one + "\n";
  return text;
}

std::string CsvOf(const FracturesResult& result)
{
  std::string text = "first_id,second_id,step_p50_mm,step_p95_mm,step_max_mm,gap_p5_mm,gap_p50_mm,"
                     "gap_p95_mm,gap_max_abs_mm,face_mm2\n";
  for (const FractureResult& f : result.fractures) // names may hold commas
  {
    const FractureFigures &step = f.measured.step, &gap = f.measured.gap;
    text += std::to_string(f.firstId) + "," + std::to_string(f.secondId) +
            (step.samples > 0 ? Line(",%.6g,%.6g,%.6g", step.p50AbsMm, step.p95AbsMm, step.maxAbsMm)
                              : ",,,");
    text += Line(
      ",%.6g,%.6g,%.6g,%.6g,%.6g\n", gap.p5Mm, gap.p50Mm, gap.p95Mm, gap.maxAbsMm, gap.areaMm2);
  }
  return text;
}

std::string CsvOf(const PairResult& result)
{
  std::string text = "fragment,s2s_mean_mm,s2s_rms_mm,s2s_p95_mm,s2s_p99_mm,s2s_max_mm,"
                     "rotation_deg,translation_mm,tre_mean_mm,tre_p95_mm,tre_max_mm\n";
  std::size_t n = 0;
  for (const FragmentResult& f : result.fragments) // a name may hold a comma
  {
    const DirectedDifference& d = f.surface.both;
    text += std::to_string(f.id != 0 ? f.id : ++n) +
            Line(",%.6g,%.6g,%.6g,%.6g,%.6g", d.meanMm, d.rmsMm, d.p95Mm, d.p99Mm, d.maxMm);
    text += f.pose
              ? Line(",%.6g,%.6g,%.6g,%.6g,%.6g\n", f.pose->rotationDegrees, f.pose->translationMm,
                  f.pose->tre.meanMm, f.pose->tre.p95Mm, f.pose->tre.maxMm)
              : ",,,,,\n";
  }
  return text;
}

Json JsonOf(const ScanResult& result)
{
  const SurfaceRegistration& r = result.registration;
  const RigidPose& pose = r.otherToScan;
  Json json{ { "reference", result.reference },
    { "registration",
      { { "median_mm", r.medianMm }, { "rms_mm", r.rmsMm }, { "matched_share", r.share },
        { "fits", r.fits }, { "ambiguous", r.ambiguous },
        { "other_to_scan", { { "position", { pose.position.x, pose.position.y, pose.position.z } },
                             { "orientation", { pose.orientation.w, pose.orientation.x,
                                                pose.orientation.y, pose.orientation.z } } } } } },
    { "fragments", Json::array() } };
  for (const ScanResult::Fragment& f : result.fragments)
    json["fragments"].push_back(
      { { "fragment", f.called }, { "to_other_scan", JsonOf(f.toOther) } });
  return json;
}

std::string TextOf(const ScanResult& result)
{
  const SurfaceRegistration& r = result.registration;
  std::string text = "registered by " + result.reference +
                     Line(": median %.3f mm, rms %.3f mm of the %.1f %% that match\n", r.medianMm,
                       r.rmsMm, 100.0 * r.share);
  text += "planned surface to the other scan's bone, mm\n"
          "                    mean     p50     p95     max\n";
  for (const ScanResult::Fragment& f : result.fragments)
    text += Line("%-16.40s %7.3f %7.3f %7.3f %7.3f\n", f.called.c_str(), f.toOther.meanMm,
      f.toOther.p50Mm, f.toOther.p95Mm, f.toOther.maxMm);
  return text;
}

} // namespace hasp
