#pragma once
#include "Evaluation/FitCertificate.h"

#include <string>
#include <vector>

namespace hasp
{

/// A measure of a certificate as its reader sees it.
struct CertificateRow
{
  std::string measure, measured, limit; ///< without a limit: it is told alone
  bool fault = false;                   ///< it is beyond
  bool missing = false;                 ///< it could not be measured: it holds nothing
};

/// All that was measured, in the order of a part's life: its mesh, its walls, its fit.
std::vector<CertificateRow> CertificateTable(const FitCertificate& certificate);

} // namespace hasp
