#pragma once
#include "Evaluation/FitCertificate.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hasp
{

/// A line a figure, and the verdict.
std::string CertificateText(const FitCertificate& certificate);

/// All of it: what was measured, the limits it was held to, and the faults with their places. A
/// page with pictures is to be made of this alone. What was not measured is null; lengths are mm,
/// "at" is world, patient LPS.
nlohmann::ordered_json CertificateJson(const FitCertificate& certificate);

} // namespace hasp
