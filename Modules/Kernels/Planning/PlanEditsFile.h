#pragma once
#include "Planning/PlanEdits.h"

#include <string>
#include <vector>

namespace hasp
{

/// Edits as JSON, for those who write them by hand or by a program:
///
///   { "format": "hasp-edits-5", "edits": [{ "add": "cut", "object": { "id": 3, … } }, …] }
///
/// each as in a plan's history (Utilities/Docs/Formats.md#plans). The number is that of the plan's
/// own format; older ones are read. Strict, and what an edit holds is checked by Apply. Errors are
/// std::runtime_error (syntax) or std::invalid_argument (content) and say which key, never a text
/// of the file. Needs HASP_ENABLE_JSON and HASP_ENABLE_OPENSSL, as plans do. Any thread.
std::vector<PlanEdit> ParseEdits(const std::string& json);
std::string FormatEdits(const std::vector<PlanEdit>& edits);

} // namespace hasp
