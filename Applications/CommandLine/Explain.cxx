#include "Explain.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace hasp
{

std::string ExplainTable(const ResourceList& resources)
{
  std::size_t width = 8;
  for (const ResourceUse& use : resources)
    width = std::max(width, use.resource.size());
  std::string table =
    "resource" + std::string(width - 8, ' ') + "         bytes          ms  why\n";
  char figures[64];
  for (const ResourceUse& use : resources)
  {
    std::snprintf(figures, sizeof figures, "%14zu%12.3f  ", use.bytes, use.milliseconds);
    table +=
      use.resource + std::string(width - use.resource.size(), ' ') + figures + use.reason + "\n";
  }
  return table;
}

nlohmann::ordered_json ExplainJson(const ResourceList& resources)
{
  auto list = nlohmann::ordered_json::array();
  for (const ResourceUse& use : resources)
    list.push_back({ { "resource", use.resource }, { "bytes", use.bytes },
      { "ms", use.milliseconds }, { "reason", use.reason } });
  return list;
}

} // namespace hasp
