#pragma once
#include "Grid/ResourceUse.h"

#include <nlohmann/json_fwd.hpp>

namespace hasp
{

/// What was built and what was skipped, as a table: resource, bytes, milliseconds, why.
std::string ExplainTable(const ResourceList& resources);

/// The same as a JSON array of {"resource", "bytes", "ms", "reason"}.
nlohmann::ordered_json ExplainJson(const ResourceList& resources);

} // namespace hasp
