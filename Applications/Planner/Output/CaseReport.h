#pragma once
#include "Output/ReportContents.h"
#include "Output/ReportPictures.h"
#include "Planning/PlanFile.h"

#include <filesystem>
#include <string>

namespace hasp
{

struct Planner;

struct CaseReportOptions
{
  /// The user's names of objects, besides their numbers. They may be a patient's: only for who
  /// asks.
  bool names = false;
  QString date{}; ///< to be said in it; empty: none, so that equal plans have equal reports
};

/// What a plan says, for who carries it out: the case label, how fragments move, groups, pictures,
/// measures, cuts, parts with their verdicts, certificates and SHA-256, the plan's hash, the scans'
/// hashes, and what program made it. No path, no name of a file, no patient data but what the case
/// label holds.
///
/// Writes the HTML page, pictures in it, and beside it the same as NAME.pdf; each whole or not at
/// all, the page after the PDF. Equal plans with equal parts have equal reports, byte by byte, on
/// one machine. False after SayFault, which says what to do; else Say.
///
/// Fragments that are hidden are made for it; of those that cannot be shown, or not yet, the report
/// says that pictures lack them. Threads: RENDER. Cost: a surface of each fragment and eight
/// pictures: seconds.
bool WriteCaseReport(
  Planner& planner, const std::filesystem::path& html, const CaseReportOptions& options = {});

/// What that writes: its contents, without a window.
///
/// blobs    the folder that holds what parts name
/// bodies   in the scan: fragments move as the middles of theirs do
/// drawing  DrawReport's of them
/// missing  sentences on what pictures do not show
/// Any thread. Reads the parts' reports.
ReportContents DescribeCase(const PlanDocument& document, const std::filesystem::path& blobs,
  const ReportBodies& bodies, ReportDrawing drawing, const QStringList& missing,
  const CaseReportOptions& options = {});

/// The page, and beside it the PDF. Throws std::runtime_error without a path; then the page is as
/// it was. RENDER.
void SaveReport(const ReportContents& contents, const std::filesystem::path& html);

} // namespace hasp
