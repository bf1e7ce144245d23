#pragma once
#include "CertificatePictures.h"

#include <string>
#include <vector>

namespace hasp
{

/// What a page says of a part besides its certificate. Of files it says hashes and nothing else.
struct CertificatePage
{
  std::string partHash;   ///< SHA-256 of the part's file, hexadecimal; empty: not hashed
  std::string recipeHash; ///< of the recipe's; empty: none was given, or not hashed
  std::string fate;       ///< "It was not kept.", and what else is to be known; may be empty
  std::vector<CertificatePicture> pictures{};
  std::string noPictures{}; ///< why there are none
};

/// The certificate as one HTML page that needs nothing else: the verdict in words first, faults by
/// the numbers that pictures mark them with, what was measured beside its limits, the gap's
/// histogram, pictures. No script, no clock: equal parts make equal pages.
std::string CertificateHtml(const FitCertificate& certificate, const CertificatePage& page);

/// The inner wall's area over its gap, as an SVG element, with the gap asked for and its tolerance.
std::string GapHistogramSvg(const GuideGap& gap, const ClaimedShell& shell);

struct PageRequest
{
  std::string path;   ///< of the .html file; empty: none is asked for, and none is made
  std::string part;   ///< path of the part's file, as it stays
  std::string recipe; ///< and of its recipe's; may be empty
  std::string fate;   ///< as above
};

/// Draws the pictures and writes the page. Where nothing can be drawn the page says so. What was
/// made or not is listed among the session's resources. Throws Failure: WrongUse if the page cannot
/// be written. RENDER thread.
void WriteCertificatePage(const TriangleMesh& part, vtkImageData* bone,
  const FitCertificate& certificate, const PageRequest& request, Session& session);

} // namespace hasp
