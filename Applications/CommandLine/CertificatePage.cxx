#include "CertificatePage.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"

#include <chrono>

namespace hasp
{

void WriteCertificatePage(const TriangleMesh& part, vtkImageData* bone,
  const FitCertificate& certificate, const PageRequest& request, Session& session)
{
  if (request.path.empty())
    return session.resources.push_back({ "certificate's page", 0, 0.0, "no --html was asked for" });
  CertificatePage page{ HashOfFile(request.part), HashOfFile(request.recipe), request.fate };
  const auto start = std::chrono::steady_clock::now();
  try
  {
    page.pictures = DrawCertificate(part, bone, certificate, session);
  }
  catch (const Failure& failure)
  {
    if (failure.code != ExitCode::CannotDraw)
      throw;
    page.noPictures = failure.what(); // the certificate stands without
    SayWarning(session, "the page has no pictures: " + page.noPictures);
  }
  const std::string html = CertificateHtml(certificate, page);
  WriteFile(request.path, html);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back(
    { "certificate's page", html.size(), spent.count(), "--html; with pictures drawn for it" });
  session.progress.Wipe();
}

} // namespace hasp
