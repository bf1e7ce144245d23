#include "RunCertificate.h"

#include "CertificatePage.h"
#include "CertificateText.h"
#include "PartCertificate.h"
#include "PartReport.h"
#include "Session.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace hasp
{
namespace
{
vtkSmartPointer<vtkImageData> ImageOf(const AnyGridView& bone)
{
  return std::visit(
    []<typename T>(const GridView<const T>& view) {
      return MakeImage(view.geometry, std::vector<T>(view.data, view.data + view.geometry.Size()));
    },
    bone);
}

/// What a page must say of bone that the part was not held to.
std::string WhatBone(const PartCheck& check)
{
  return check.alone == 0 ? ""
                          : "It was held to fragment " + std::to_string(check.alone) +
                              " alone: other bone of the scan was not looked at.";
}
} // namespace

CertifiedPart CertifyFile(
  const PartCheck& check, const std::string& stl, nlohmann::ordered_json& report, Session& session)
{
  CertifiedPart part{ ReadBack(stl, session), {} };
  part.certificate = MeasurePart(part.mesh, check.bone, check.claims, session);
  if (!part.certificate.Holds() || ClaimFit(part.certificate.claims))
    report["verdict"] = part.certificate.Holds() ? "green" : "red";
  for (const FitFault& fault : part.certificate.faults)
    report["faults"].push_back(fault.text);
  if (check.alone != 0)
    report["held_to_fragment"] = check.alone;
  report["certificate"] = CertificateJson(part.certificate);
  if (const std::string recipe = RecipeText(check); !recipe.empty())
    report["recipe"] = nlohmann::ordered_json::parse(recipe);
  return part;
}

void WritePartPage(const PartCheck& check, const CertifiedPart& certified, const std::string& stl,
  const std::string& stem, const PartPages& pages, Session& session)
{
  if (pages.folder.empty())
    return;
  const std::string recipe = RecipeText(check), recipeFile = recipe.empty() ? "" : stl + ".json";
  if (!recipe.empty())
    WriteBytes(recipe, recipeFile); // for its hash, which the page says
  WriteCertificatePage(certified.mesh, ImageOf(check.bone), certified.certificate,
    { (std::filesystem::path(pages.folder) / (stem + ".html")).string(), stl, recipeFile,
      (certified.certificate.Holds() ? "" : pages.fate + " ") + WhatBone(check) },
    session);
  if (!recipe.empty())
    std::filesystem::remove(recipeFile);
}

} // namespace hasp
