#include "ReportPlanner.h"

#include "MeasuredChild.h"
#include "Report/Pairing.h"
#include "Report/Report.h"
#include "Report/ReportRegistry.h"
#include "Report/ScratchFolder.h"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double MostS = 900.0;

/// Rows of what the planner has measured.
class PlannerRows
{
public:
  explicit PlannerRows(Report& report) : Of(report) {}

  void Add(const Json& measured)
  {
    this->AddFirst(measured.at("first_ms").get<double>());
    for (const Json& one : measured.at("isovalue"))
      this->AddIsovalue(one);
    this->AddDrag(measured.at("drag"));
    this->AddIdle(measured.at("idle"));
    this->AddMemory(measured.at("reopened"));
  }

private:
  ReportRow& Row(const std::string& id, double value, const std::string& unit)
  {
    ReportRow row;
    row.id = id;
    row.method = "planner";
    row.value = value;
    row.unit = unit;
    this->Of.rows.push_back(row);
    return this->Of.rows.back();
  }

  void AddFirst(double ms)
  {
    ReportRow& row = this->Row("planner.first", 1e-3 * ms, "s");
    row.better = Better::Lower;
    row.data = "the sample, from the program's start to its first complete picture";
  }

  /// Beside a mesh made anew: pairs of pictures.
  void AddIsovalue(const Json& one)
  {
    const auto ours = one.at("ours_ms").get<std::vector<double>>();
    const auto rival = one.at("rival_ms").get<std::vector<double>>();
    const std::string size = std::to_string(one.at("size").get<int>());
    std::vector<double> ratios;
    for (std::size_t n = 0; n < ours.size(); ++n)
      ratios.push_back(ours[n] / rival[n]);
    const Quartiles ratio = QuartilesOf(ratios), time = QuartilesOf(ours);
    ReportRow& row = this->Row("planner.isovalue@" + size, ratio.median, "ratio");
    row.rival = "vtkFlyingEdges3D and its mesh, in the same view";
    row.q1 = ratio.q1;
    row.q3 = ratio.q3;
    row.n = int(ratios.size());
    row.better = Better::Lower;
    row.error = one.at("rms_255").get<double>();
    row.errorUnit = "of 255, rms of the picture to the settled one";
    row.timeS = 1e-3 * time.median;
    row.data = "phantom " + size + "^3, 1280x800";
    if (size == "256")
    {
      ReportRow& bar = this->Row("planner.isovalue.ms", time.median, "ms");
      bar.better = Better::Lower;
      bar.bars.push_back({ {}, 100.0 });
      bar.data = "the same: from a new isovalue to its picture";
    }
  }

  void AddDrag(const Json& drag)
  {
    const auto fps = [](const Json& one)
    { return one.at("frames").get<double>() / one.at("seconds").get<double>(); };
    ReportRow& row = this->Row("planner.drag.fps", fps(drag), "frames a second");
    row.better = Better::Higher;
    row.bars.push_back({ 15.0, {} });
    row.n = drag.at("frames").get<int>();
    row.error = drag.at("rms_255").get<double>();
    row.errorUnit = "of 255, rms of a picture in motion to all pixels";
    row.timeS = drag.at("seconds").get<double>() / std::max(1.0, drag.at("frames").get<double>());
    row.data = "broken mandible, with contact, 1280x800";
    ReportRow& full = this->Row("planner.drag.fps.full", fps(drag.at("full")), "frames a second");
    full.better = Better::Higher;
    full.data = "the same with all pixels: without dynamic resolution";
    ReportRow& share = this->Row("planner.drag.share", drag.at("share").get<double>(), "share");
    share.bars.push_back({ 0.5, {} });
    share.better = Better::Higher;
    share.data = "least pixels along an axis while it moved";
    ReportRow& tick = this->Row("planner.drag.tick", drag.at("tick_us").get<double>(), "us");
    tick.better = Better::Lower;
    tick.n = drag.at("ticks").get<int>();
    tick.data = "CPU time of a haptic tick beside the frames, median; skipped " +
                std::to_string(drag.at("skipped").get<long long>());
  }

  void AddIdle(const Json& idle)
  {
    ReportRow& row = this->Row("planner.idle.frames", idle.at("frames").get<double>(), "count");
    row.better = Better::Lower;
    row.bars.push_back({ {}, 0.0 });
    row.data = std::to_string(idle.at("seconds").get<double>()) + " s without an event";
  }

  void AddMemory(const Json& reopened)
  {
    const double grown =
      reopened.at("bytes_after").get<double>() - reopened.at("bytes_before").get<double>();
    ReportRow& row = this->Row("planner.reopened", grown / 1048576.0, "MiB");
    row.better = Better::Lower;
    row.n = reopened.at("times").get<int>();
    row.data = "growth of resident memory over so many times new plan, open plan";
  }

  Report& Of;
};

void AddAbsent(Report& report, const std::string& why)
{
  ReportRow row;
  row.id = "planner.drag.fps";
  row.method = "planner";
  row.rival = "the planner";
  row.absent = why;
  report.rows.push_back(row);
}

/// The program beside this one; empty: it is not built.
std::string PlannerProgram()
{
  std::error_code ignored;
  const fs::path program =
    fs::read_symlink("/proc/self/exe", ignored).parent_path() / "hasp-planner";
  return fs::exists(program, ignored) ? program.string() : std::string();
}

/// Runs it on $DISPLAY, or on a screen of its own.
MeasuredChild RunPlanner(const std::vector<std::string>& words)
{
  const char* display = std::getenv("DISPLAY");
  if (display && *display)
    return RunMeasured(words, { PlannerProgram(), MostS });
  std::vector<std::string> screen{ "-a", "-s", "-screen 0 1280x800x24 -noreset", PlannerProgram() };
  screen.insert(screen.end(), words.begin(), words.end());
  return RunMeasured(screen, { "/usr/bin/xvfb-run", MostS });
}
} // namespace

void ReportPlanner(ReportContext& context)
{
  if (PlannerProgram().empty())
    return AddAbsent(context.report, "bin/hasp-planner is not in this build");
  const ScratchFolder scratch;
  const fs::path figures = fs::path(scratch.Path()) / "figures.json";
  context.progress(0.0, "measuring the planner");
  std::vector<std::string> words{ "--measure", figures.string(), "--state",
    (fs::path(scratch.Path()) / "state").string() };
  if (context.settings.quick)
    words.push_back("--quick");
  try
  {
    const MeasuredChild child = RunPlanner(words);
    if (child.exitCode != 0 || !fs::exists(figures))
      return AddAbsent(context.report,
        "the planner ended with " + std::to_string(child.exitCode) + ": " + child.error);
  }
  catch (const std::runtime_error& error)
  {
    return AddAbsent(context.report, std::string("no screen: ") + error.what());
  }
  PlannerRows(context.report).Add(Json::parse(std::ifstream(figures)));
}

} // namespace hasp
