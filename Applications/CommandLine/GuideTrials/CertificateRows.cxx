#include "CertificateTrial.h"
#include "GuideTrials.h"
#include "ReportRegistry.h"

namespace hasp
{

void TryCertificates(ReportContext& context, std::size_t ofEach)
{
  const auto seed = static_cast<std::uint32_t>(context.settings.seed * 1000);
  CertificateTrial defects, clean;
  std::string missed, flagged;
  for (int n = 0; n <= SeededDefects; ++n)
  {
    const auto defect = static_cast<SeededDefect>(n);
    context.progress(double(n) / (SeededDefects + 1),
      n == 0 ? "guides: certificates of parts with a defect, and of clean ones" : "");
    const CertificateTrial trial = TryCertificate(defect,
      seed + std::uint32_t(n == 0 ? 100000 : 1000 * n), n == 0 ? SeededDefects * ofEach : ofEach);
    CertificateTrial& sum = n == 0 ? clean : defects;
    sum.parts += trial.parts;
    sum.found += trial.found;
    sum.red += trial.red;
    sum.triangles += trial.triangles;
    sum.milliseconds += trial.milliseconds;
    for (const std::string& wrong : trial.wrong)
      (n == 0 ? flagged : missed) += "; " + wrong;
  }
  const auto row = [](const CertificateTrial& trial, const char* id, double value, double error)
  {
    ReportRow made;
    made.id = id;
    made.value = value;
    made.unit = "of " + std::to_string(trial.parts);
    made.error = error;
    made.timeS = 1e-3 * trial.milliseconds / double(trial.parts);
    made.n = int(trial.parts);
    made.data = "parts of " + std::to_string(trial.triangles / trial.parts) +
                " triangles, each on a bone of its own";
    return made;
  };
  ReportRow found = row(defects, "guides.certificate.found", double(defects.found),
    double(defects.parts - defects.found));
  found.rival =
    "what was done to each part: a hole in the mesh, a flipped triangle, a "
    "self-intersection, a thin wall, a wrong gap, a narrow slot, a small hole, mirrored, "
    "inch for mm, a loose piece";
  found.errorUnit = "missed, or red for another reason";
  found.data += missed;
  found.bars = { { double(defects.parts), {} } };
  ReportRow falsely = row(clean, "guides.certificate.false", double(clean.red), double(clean.red));
  falsely.rival = "parts as their claims have them";
  falsely.errorUnit = "flagged";
  falsely.data += flagged;
  falsely.bars = { { {}, 0.0 } };
  context.report.rows.push_back(found);
  context.report.rows.push_back(falsely);
#if !HASP_WITH_CGAL
  for (std::size_t n = context.report.rows.size() - 2; n < context.report.rows.size(); ++n)
    context.report.rows[n].data += "; without CGAL all parts are red: nothing is green unchecked";
#endif
}

} // namespace hasp
