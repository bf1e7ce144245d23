#pragma once
#include "Evaluation/FitCertificate.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hasp
{

/// "holds", "DOES NOT HOLD", or, of a part that nothing is claimed of, what can be said then.
std::string CertificateVerdict(const FitCertificate& certificate);

/// A line a figure, and the verdict; without the faults, which whoever fails says (Faulty).
std::string CertificateText(const FitCertificate& certificate);

/// All of it: what was measured, the limits it was held to, and the faults with their places. A
/// page with pictures is to be made of this alone. What was not measured is null, so is "passed" of
/// a sound mesh that was not held to a recipe; lengths are mm,
/// "at" is world, patient LPS.
nlohmann::ordered_json CertificateJson(const FitCertificate& certificate);

} // namespace hasp
