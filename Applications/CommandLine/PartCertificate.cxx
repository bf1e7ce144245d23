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
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

#include <chrono>
#include <iostream>
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

TriangleMesh ReadPart(const std::string& path, Session& session)
{
  const LoadedSurface read = ReadSurface(path, FileLabel(path), session.quiet, session);
  session.resources.push_back({ "part", BytesOf(read), 0.0, "read back as written" });
  return WeldPoints(MakeTriangleMesh(read.surface));
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
      return ReadPart(pendingFile, session);
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
