#pragma once
#include "Output/ReportContents.h"
#include "Planning/Plan.h"

#include <glm/vec3.hpp>

#include <map>

/// A plan's objects as tables of a case report. Internal to CaseReport. Any thread.
namespace hasp
{

struct ReportNaming
{
  const Plan& plan;
  bool names = false; ///< the user's own, too
};

/// "fragment 5", and its name if that is asked for.
QString CalledInReport(const ReportNaming& of, PlanId object);

/// How fragments go from the scan to where they are planned. `middles`: of fragments in the scan,
/// where that is known; the motion of those is their middle's, of others their seed's or none.
ReportTable FragmentTable(const ReportNaming& of, const std::map<PlanId, glm::dvec3>& middles);
ReportTable GroupTable(const ReportNaming& of);
ReportTable CutTable(const ReportNaming& of);
/// As planned, as scanned, and by how much that has changed.
ReportTable MeasureTable(const ReportNaming& of);
/// Scans and surfaces by what they hold: hashes, no names.
ReportTable SourceTable(const Plan& plan);

} // namespace hasp
