#pragma once
#include "Output/CaseReport.h"

#include "../../CommandLine/Testing/HaspProcess.h"
#include "CertificateText.h"
#include "OffscreenQt.h"
#include "Planning/PlanEditsFile.h"
#include "vtkHaspHeadlessWindows.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "vtkSphereSource.h"

#include <cmath>

// Plans that reports are written of.
namespace
{

namespace fs = std::filesystem;
using namespace hasp;

constexpr const char* Erika = "Erika"; // whose name no report may say

vtkSmartPointer<vtkPolyData> Ball(const glm::dvec3& at, double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(at.x, at.y, at.z);
  source->SetRadius(radius);
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->Update();
  return source->GetOutput();
}

/// The plan of Data/phantom-plan-edits.json: the jaw 2, cuts 3 and 4, its pieces 5, 6 and 7, guide
/// 8 and plate 9; then piece 6 is moved. Its pieces are balls here.
class CaseReport : public HaspTest
{
protected:
  CaseReport()
  {
    unsetenv("DISPLAY"); // pictures as where there is none
    UseHeadlessWindows();
    UseOffscreenQt();
    for (const PlanEdit& edit : ParseEdits(ReadBytes(HASP_PLAN_EDITS)))
      this->document.history.Do(edit);
    const double half = 15.0 * std::acos(-1.0) / 180.0; // of 30 degrees, about the ball's middle
    const glm::dquat turn(std::cos(half), 0.0, 0.0, std::sin(half));
    const glm::dvec3 middle(-35.0, -45.0, -95.0), by(3.0, 4.0, 0.0);
    this->document.history.Do(PoseFragments{ { { 6, { middle + by - turn * middle, turn } } } });
    this->bodies.fragments = { { 5, Ball({ 10.0, -75.0, -95.0 }, 12.0) }, { 6, Ball(middle, 10.0) },
      { 7, Ball({ -20.0, -67.0, -95.0 }, 8.0) } };
    this->bodies.parts = { { 8, Ball({ -25.0, -75.0, -95.0 }, 5.0) } };
    fs::create_directories(this->Blobs());
  }
  fs::path Blobs() const { return this->folder / "plan.hasp"; }
  void Do(const PlanEdit& edit) { this->document.history.Do(edit); }
  /// A guide that was measured; red: it has a fault.
  FitCertificate KeepGuide(bool red = false)
  {
    FitCertificate c;
    c.claims.leastWallMm = 0.71;
    c.claims.slots.push_back({ .widthMm = 1.25, .toleranceMm = 0.1 });
    c.mesh.triangles = 4321;
    c.mesh.pieces = 1;
    c.pieces.resize(1);
    c.selfIntersections = 0;
    c.wall = { 10.5, 0.83, { 1, 2, 3 }, 0.9, 1.0 };
    c.slots.push_back({ 14, 1.24, { 2, 0, 0 }, 1.23, 0.03, 0.04, 0.05, 15.5, 16.5, std::nullopt });
    if (red)
      c.faults.push_back({ FitFaultKind::ThinWall, Erika, glm::dvec3(1, 2, 3) });
    const nlohmann::ordered_json report{ { "triangles", 4321 }, { "volume_mm3", 987.6 },
      { "verdict", red ? "red" : "green" }, { "certificate", CertificateJson(c) } };
    this->KeepPart(8, report.dump());
    return c;
  }
  void KeepPart(PlanId object, const std::string& report)
  {
    this->bytes = WriteBlob(this->Blobs(), std::string("solid ") + Erika);
    this->document.parts.push_back(
      { object, PartFormat::Stl, PartInputs(this->document.history.Current(), object), this->bytes,
        WriteBlob(this->Blobs(), report) });
  }
  /// Without pictures.
  ReportContents Contents(const CaseReportOptions& options = {}) const
  {
    return DescribeCase(this->document, this->Blobs(), this->bodies, {}, {}, options);
  }
  ReportContents ContentsWithPictures() const
  {
    return DescribeCase(this->document, this->Blobs(), this->bodies,
      DrawReport(this->document.history.Current(), this->bodies), {});
  }
  /// The rows of the table with that title; none: no such table.
  std::vector<QStringList> Rows(const QString& title) const
  {
    for (const ReportTable& table : this->Contents().tables)
      if (table.title == title)
        return table.rows;
    return {};
  }
  QStringList RowOf(const QString& title, const QString& first) const
  {
    for (const QStringList& row : this->Rows(title))
      if (row.front() == first)
        return row;
    return {};
  }

  PlanDocument document;
  ReportBodies bodies;
  std::string bytes; ///< of the part's file: their hash
};

} // namespace
