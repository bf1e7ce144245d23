#include "CertificateTrial.h"

#include "Evaluation/FitCertificate.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <algorithm>
#include <chrono>

namespace hasp
{
namespace
{

/// What a certificate must say of a defect.
FitFaultKind ReasonFor(SeededDefect defect)
{
  switch (defect)
  {
    case SeededDefect::MeshHole:
      return FitFaultKind::NotClosed;
    case SeededDefect::FlippedTriangle:
      return FitFaultKind::Turned;
    case SeededDefect::SelfIntersection:
      return FitFaultKind::MeetsItself;
    case SeededDefect::ThinWall:
      return FitFaultKind::ThinWall;
    case SeededDefect::WrongGap:
      return FitFaultKind::Gap;
    case SeededDefect::NarrowSlot:
      return FitFaultKind::Slot;
    case SeededDefect::SmallHole:
      return FitFaultKind::Hole;
    case SeededDefect::Mirrored:
      return FitFaultKind::Mirrored;
    case SeededDefect::InchForMm:
      return FitFaultKind::Units;
    default:
      return FitFaultKind::Pieces;
  }
}

FindSelfIntersectionsFunction SelfIntersections()
{
#if HASP_WITH_CGAL
  return FindSelfIntersections;
#else
  return {};
#endif
}

std::string Words(const FitCertificate& certificate)
{
  std::string text;
  for (const FitFault& fault : certificate.faults)
    text += "; " + fault.text;
  return text.empty() ? "; holds" : text;
}

} // namespace

CertificateTrial TryCertificate(SeededDefect defect, std::uint32_t firstSeed, std::size_t count)
{
  CertificateTrial trial;
  for (std::uint32_t seed = firstSeed; seed < firstSeed + count; ++seed)
  {
    const SeededPart part = MakeSeededPart(seed, defect);
    const auto start = std::chrono::steady_clock::now();
    const FitCertificate certificate =
      CertifyFit(part.mesh, part.Bone(), part.claims, SelfIntersections());
    trial.milliseconds +=
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    const bool found = std::any_of(certificate.faults.begin(), certificate.faults.end(),
      [&](const FitFault& fault) { return fault.kind == ReasonFor(defect); });
    const bool clean = defect == SeededDefect::None;
    ++trial.parts;
    trial.triangles += part.mesh.triangles.size();
    trial.red += !certificate.Holds();
    trial.found += !clean && found;
    if (clean ? !certificate.Holds() : !found)
      trial.wrong.push_back(
        "seed " + std::to_string(seed) + ", " + SeededDefectName(defect) + Words(certificate));
  }
  return trial;
}

} // namespace hasp
