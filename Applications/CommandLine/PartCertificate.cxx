#include "PartCertificate.h"

#include "CertificateText.h"
#include "Session.h"
#include "SurfaceInput.h"
#include "VerbWork.h"
#include "VtkMessages.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeView.h"

#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

#include <chrono>
#include <iostream>
#include <stdexcept>
#include <type_traits>
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

template <typename Reader>
TriangleMesh ReadByVtk(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  if constexpr (std::is_same_v<Reader, vtkSTLReader>)
    reader->MergingOff();
  reader->Update();
  ThrowVtkError(ExitCode::FailedCheck, "the part cannot be read back");
  return WeldPoints(MakeTriangleMesh(reader->GetOutput()));
}

} // namespace

PrintedPart ReadPart(const std::string& path, Session& session)
{
  const LoadedSurface read = ReadSurface(path, FileLabel(path), session.quiet, session);
  session.resources.push_back({ "part", BytesOf(read), 0.0, "read back as written" });
  return { WeldPoints(MakeTriangleMesh(read.surface)), read.passport.label.doesNotHold };
}

TriangleMesh ReadBack(const std::string& pendingFile, Session& session)
{
  if (pendingFile.ends_with(".ply"))
    return ReadByVtk<vtkPLYReader>(pendingFile);
  if (pendingFile.ends_with(".obj"))
    return ReadByVtk<vtkOBJReader>(pendingFile);
  if (pendingFile.ends_with(".3mf"))
    try
    {
      return ReadPart(pendingFile, session).mesh;
    }
    catch (const Failure& failure)
    {
      throw Failure(ExitCode::FailedCheck, failure.what());
    }
  return ReadBackStl(pendingFile);
}

TriangleMesh ReadBackStl(const std::string& file)
{
  return ReadByVtk<vtkSTLReader>(file);
}

FitCertificate MeasurePart(
  const TriangleMesh& part, const AnyGridView& bone, const PartClaims& claims, Session& session)
{
  session.progress.Step("measuring the part as written");
  const auto start = std::chrono::steady_clock::now();
  const auto progress = [&session](double share) { return session.progress.Share(share); };
  const FitCertificate certificate = Try(ExitCode::FailedCheck, "the part cannot be measured: ",
    [&]
    {
      try
      {
        return CertifyFit(part, bone, claims, SelfIntersectionsOfThisBuild(), progress);
      }
      catch (const std::invalid_argument& error) // of claims and volume: no fault of the part
      {
        throw Failure(ExitCode::BadInput, SafeText(error));
      }
    });
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  session.resources.push_back({ "certificate", 0, spent.count(), "measured; released again" });
  return certificate;
}

FitCertificate CertifyPart(
  const PrintedPart& part, vtkImageData* bone, const PartClaims& claims, Session& session)
{
  FitCertificate certificate = MeasurePart(part.mesh, ViewImage(bone), claims, session);
  if (part.saidRed)
    certificate.faults.push_back({ FitFaultKind::SaidRed,
      "its file says that it DOES NOT HOLD: it was kept by --force", std::nullopt });
  session.progress.Wipe();
  if (!session.json)
    std::cout << CertificateText(certificate);
  session.result["certificate"] = CertificateJson(certificate);
  return certificate;
}

Failure Faulty(const FitCertificate& certificate, const std::string& words)
{
  std::vector<std::string> faults;
  for (const FitFault& fault : certificate.faults)
    faults.push_back(fault.text);
  return FailedCheck(words, faults);
}

} // namespace hasp
