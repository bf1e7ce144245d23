#include "PartCertificate.h"

#include "CertificateText.h"
#include "Failure.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VtkMessages.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeView.h"

#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <string_view>
#include <vector>

namespace hasp
{
namespace
{

FindSelfIntersectionsFunction SelfIntersectionsOfThisBuild()
{
#if HASP_WITH_CGAL
  return FindSelfIntersections;
#else
  return {};
#endif
}

} // namespace

TriangleMesh ReadPart(const std::string& path, Session& session)
{
  const LoadedSurface read = ReadSurface(path, FileLabel(path), session.quiet, session);
  session.resources.push_back({ "part", BytesOf(read), 0.0, "read back as written" });
  return WeldPoints(MakeTriangleMesh(read.surface));
}

TriangleMesh ReadBackStl(const std::string& stl)
{
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(stl.c_str());
  reader->MergingOff();
  reader->Update();
  ThrowVtkError(ExitCode::FailedCheck, "the part cannot be read back");
  return WeldPoints(MakeTriangleMesh(reader->GetOutput()));
}

FitCertificate MeasurePart(
  const TriangleMesh& part, const AnyGridView& bone, const PartClaims& claims, Session& session)
{
  session.progress.Step("measuring the part as written");
  const auto start = std::chrono::steady_clock::now();
  FitCertificate certificate;
  try
  {
    certificate = CertifyFit(part, bone, claims, SelfIntersectionsOfThisBuild(),
      [&session](double share)
      {
        session.progress.Share(share);
        return true;
      });
  }
  catch (const std::exception& error) // what cannot be measured does not hold
  {
    throw Failure(ExitCode::FailedCheck, SafeText(error));
  }
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back({ "certificate", 0, spent.count(), "measured; released again" });
  return certificate;
}

void MarkAsFailed(const std::string& stl)
{
  constexpr std::string_view words = " DOES NOT HOLD";
  std::string head(80, '\0');
  std::fstream file(stl, std::ios::in | std::ios::out | std::ios::binary);
  file.read(head.data(), 80);
  const std::size_t end = std::min(head.find_last_not_of(std::string_view("\0 ", 2)) + 1,
    head.size() - words.size()); // npos + 1 is 0
  head.replace(end, words.size(), words);
  file.seekp(0);
  file.write(head.data(), 80);
  if (!file.flush())
    throw Failure(ExitCode::WrongUse, "the part does not hold, and its file cannot say so");
}

FitCertificate CertifyPart(
  const TriangleMesh& part, vtkImageData* bone, const PartClaims& claims, Session& session)
{
  const FitCertificate certificate = MeasurePart(part, ViewImage(bone), claims, session);
  session.progress.Wipe();
  if (!session.json)
    std::cout << CertificateText(certificate);
  session.result["certificate"] = CertificateJson(certificate);
  return certificate;
}

void ThrowFaults(const FitCertificate& certificate, const std::string& words)
{
  std::vector<std::string> faults;
  for (const FitFault& fault : certificate.faults)
    faults.push_back(fault.text);
  throw FailedCheck(words, faults);
}

} // namespace hasp
