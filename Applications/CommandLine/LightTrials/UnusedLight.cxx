#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Light/ProgressivePaths.h"
#include "Light/SceneLightCache.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace hasp
{
namespace
{

std::ptrdiff_t Threads()
{
  std::error_code none;
  return std::distance(std::filesystem::directory_iterator("/proc/self/task", none),
    std::filesystem::directory_iterator());
}

} // namespace

void AddUnusedLight(ReportContext& context)
{
  constexpr std::size_t Stack = 8UL << 20;
  auto& unused = context.report.unused;
  const LitScene nothing({}, {}, UniformLight(1.0F));
  std::size_t trees = 0;
  for (const LitBody& body : nothing.Bodies())
    trees += body.cells ? body.cells->Bytes() : body.mesh->Bytes();
  unused.push_back({ "light, trees", trees, 0.0, "no body takes light" });
  unused.push_back({ "light, environment", UniformLight(1.0F)->Bytes(), 0.0,
    "the same light from everywhere: no map, no tables" });
  const LitScene lamps({ BodyOf(SquareMesh(10.0), {}) }, { LitLamp() }, UniformLight(0.0F));
  SceneLightCache cache;
  LitPicture lit;
  SceneLightRequest request;
  request.kind = SceneLightRequest::Kind::Lamps;
  cache.Light(lamps, OrbitView(lamps, 0.0, 16), {}, request, lit);
  unused.push_back({ "light, kept", cache.Bytes(), 0.0, "lamps alone, nothing is kept" });
  const std::ptrdiff_t before = Threads();
  const ProgressivePaths paths;
  const auto more = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, Threads() - before));
  unused.push_back({ "light, paths", paths.Bytes(), 0.0, "no picture by paths is asked for" });
  unused.push_back({ "light, thread", more * Stack, 0.0, "no picture by paths is asked for" });
}

void AddWorstLight(ReportContext& context, const std::string& id)
{
  const ReportRow* worst = nullptr;
  for (const ReportRow& row : context.report.rows)
  {
    if (!row.id.starts_with(id + ".") || row.id.find('@') != std::string::npos || row.bars.empty())
      continue;
    const bool higher = BetterOf(row) == Better::Higher;
    if (!worst || (higher ? *row.value < *worst->value : *row.value > *worst->value))
      worst = &row;
  }
  if (!worst)
    return;
  ReportRow row = *worst;
  row.id = id;
  row.data = "the worst of its kinds, " + worst->id;
  context.report.rows.push_back(row);
}

} // namespace hasp
