#pragma once
#include "Output/ReportTables.h"
#include "Planning/PlanFile.h"

#include <filesystem>
#include <vector>

namespace hasp
{

/// The parts of a plan, and a table more for each one that has a certificate. Internal to
/// CaseReport.
///
/// blobs  the folder that holds what parts name. A report there that is none of ours is said to be
///        missing, without a text of it.
/// Any thread; reads the parts' reports.
std::vector<ReportTable> PartTables(
  const PlanDocument& document, const std::filesystem::path& blobs, const ReportNaming& of);

} // namespace hasp
