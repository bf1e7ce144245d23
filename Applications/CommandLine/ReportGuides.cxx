#include "ReportGuides.h"

#include "GuideTrials.h"
#include "MeasuredChild.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Evaluation/FitCertificate.h"
#include "Grid/GridView.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{

std::string Beside(const char* name)
{
  std::error_code none;
  const std::filesystem::path program =
    std::filesystem::read_symlink("/proc/self/exe", none).replace_filename(name);
  return std::filesystem::exists(program, none) ? program.string() : std::string();
}

PartRunner RandomParts()
{
  constexpr double LimitS = 20.0; // for a part; a second is usual
  PartRunner runner;
  const std::string program = Beside("hasp-part-trial");
  if (program.empty())
  {
    runner.absent =
      "hasp-part-trial, the child process that makes them, is not beside this program";
    return runner;
  }
  const MeasuredChild told = RunMeasured({ "kinds" }, { program, LimitS });
  std::istringstream kinds(told.output);
  for (RandomKind kind; kinds >> kind.name >> kind.shares;)
    runner.kinds.push_back(kind);
  if (runner.kinds.empty())
    runner.absent = "hasp-part-trial does not run";
  runner.run = [program](const std::string& kind, std::uint32_t first, std::size_t count)
  {
    try
    {
      const MeasuredChild child =
        RunMeasured({ kind, std::to_string(first), std::to_string(count) },
          { program, LimitS * double(count) });
      return PartRun{ child.output, child.late ? "too late"
                                    : child.exitCode != 0
                                      ? "exit code " + std::to_string(child.exitCode)
                                      : "" };
    }
    catch (const std::runtime_error& failure) // it ended before it could be looked at
    {
      return PartRun{ {}, failure.what() };
    }
  };
  return runner;
}

/// What a part that claims nothing, and a bone that is not there, have measured: nothing.
void AddUnusedMeasures(ReportContext& context)
{
  TriangleMesh corner;
  corner.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  corner.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  const std::vector<std::int16_t> air(8, -1000);
  const GridGeometry grid{ glm::ivec3(2), glm::dvec3(0), glm::dvec3(1), glm::dmat3(1) };
  const FitCertificate c =
    CertifyFit(corner, GridView<const std::int16_t>{ air.data(), grid }, PartClaims{}, {});
  context.report.unused.push_back({ "gap and shell",
    c.gap || c.shell ? sizeof(GuideGap) + sizeof(ShellThickness) : 0, 0.0, "no shell is claimed" });
  context.report.unused.push_back({ "fits of slots and holes",
    c.slots.capacity() * sizeof(SlotFit) + c.holes.capacity() * sizeof(HoleFit), 0.0,
    "none are claimed" });
  context.report.unused.push_back(
    { "ways on to the bone", c.insertion ? sizeof(Insertion) : 0, 0.0, "no direction is claimed" });
}

} // namespace

void ReportGuides(ReportContext& context)
{
  const ReportSettings& settings = context.settings;
  TryGuideTimes(context);
  TryPlans(context, settings.quick ? 100 : 1000);
  TryParts(context, RandomParts(),
    settings.quick  ? 32
    : settings.soak ? 10'000
                    : 1000,
    settings.quick ? 4 : 60);
  TryCertificates(context, settings.quick ? 1 : 20);
  AddUnusedMeasures(context);
}

} // namespace hasp
