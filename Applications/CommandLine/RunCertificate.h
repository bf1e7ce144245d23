#pragma once
#include "Evaluation/FitCertificate.h"
#include "PlanRebuild.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

/// Parts of a plan, certified as `hasp run` has written them.
namespace hasp
{

struct Session;

struct CertifiedPart
{
  TriangleMesh mesh; ///< as read back
  FitCertificate certificate;
};

/// Reads a part's file back and certifies it; puts "verdict", "faults", "certificate" and, where
/// there is one, the "recipe" into its report. Throws Failure: FailedCheck for what cannot be
/// measured.
CertifiedPart CertifyFile(
  const PartCheck& check, const std::string& stl, nlohmann::ordered_json& report, Session& session);

/// Certificates as pages.
struct PartPages
{
  std::string folder; ///< where KIND-ID.html goes; empty: none is made
  std::string fate;   ///< what becomes of a part that does not hold: "The part was not kept."
};

/// Of the part's file as it stays. Throws Failure: WrongUse if the page cannot be written. RENDER
/// thread.
void WritePartPage(const PartCheck& check, const CertifiedPart& certified, const std::string& stl,
  const std::string& stem, const PartPages& pages, Session& session);

} // namespace hasp
