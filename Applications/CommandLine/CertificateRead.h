#pragma once
#include "Evaluation/FitCertificate.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

/// Certificates as plans keep them.
namespace hasp
{

/// What CertificateJson has written, for CertificateTable, CertificateText and CertificateHtml:
/// they say the same of it, but for faults, which are in the words of PartReport. Claims are what
/// those need of them: limits and names, no places. Throws std::runtime_error, with no text of it,
/// on what is no such certificate.
FitCertificate ReadCertificate(const nlohmann::ordered_json& json);

/// The one in a part's report (PartFile::report); nothing of a part that was not certified. Throws
/// likewise.
std::optional<FitCertificate> CertificateOfReport(const std::string& report);

} // namespace hasp
