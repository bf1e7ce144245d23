#pragma once
#include "Report.h"
#include "ReportRegistry.h"
#include "ReportTerms.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace hasp::testing
{

/// A quick report of that name that something was put into; what is wrong with it fails the test.
inline Report Filled(const std::string& name, const std::function<void(ReportContext&)>& fill)
{
  Report report;
  report.name = name;
  report.terms = TermsOf(name);
  ReportContext context{ report, {}, [](double, const std::string&) {} };
  context.settings.quick = true;
  fill(context);
  for (const std::string& fault : ReportFaults(report))
    ADD_FAILURE() << fault;
  return report;
}

inline const ReportRow& Row(const Report& report, const std::string& id)
{
  for (const ReportRow& row : report.rows)
    if (row.id == id)
      return row;
  ADD_FAILURE() << "no row " << id;
  static const ReportRow none;
  return none;
}

} // namespace hasp::testing
