#pragma once
#include "Evaluation/TrialTable.h"

#include <string>

namespace hasp
{

struct ReportContext;

/// Paper IV's table, as `hasp evaluate FOLDER` makes it, in rows: reduction.precision.intra,
/// reduction.precision.inter and reduction.accuracy, means over pairs with their quartiles. The row
/// itself is the mean distance between surfaces; .max, .rotation, .translation and .tre are the
/// table's other columns; @case1 ... are its lines, with all columns told. What has no pairs has no
/// row. Any thread, one at a time.
void AddTrialRows(ReportContext& context, const TrialTable& table, const std::string& data);

} // namespace hasp
