#include "ReportPlanner.h"

#include "MeasuredChild.h"
#include "Report/Pairing.h"
#include "Report/Report.h"
#include "Report/ReportRegistry.h"
#include "Report/ReportText.h"
#include "Report/ScratchFolder.h"
#include "ReportPlannerCases.h"

#include <nlohmann/json.hpp>

#include <algorithm>
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

constexpr int MostS = 900;

double Fps(const Json& drag)
{
  return drag.at("frames").get<double>() / drag.at("seconds").get<double>();
}

double MsOfFrame(const Json& drag)
{
  return 1e3 / Fps(drag);
}

/// By how much a figure has grown from the first to the last of its samples: the medians of both
/// halves are half of that apart, and no sample alone matters.
double Growth(const std::vector<double>& samples)
{
  const auto middle = samples.begin() + std::ptrdiff_t(samples.size() / 2);
  return 2.0 * (QuartilesOf({ middle, samples.end() }).median -
                 QuartilesOf({ samples.begin(), middle }).median);
}

/// Rows and curves of what the planner has measured.
class PlannerRows
{
public:
  explicit PlannerRows(Report& report) : Of(report) {}

  void Add(const Json& measured)
  {
    this->AddFirst(measured.at("first"));
    for (const Json& one : measured.at("isovalue"))
      this->AddIsovalue(one);
    this->AddDrag(measured.at("drag"));
    this->AddIdle(measured.at("idle"));
    this->AddMemory(measured.at("reopened"));
  }

private:
  ReportRow& Row(const std::string& id, double value, const std::string& unit, Better better)
  {
    ReportRow row;
    row.id = id;
    row.method = "planner";
    row.value = value;
    row.unit = unit;
    row.better = better;
    this->Of.rows.push_back(row);
    return this->Of.rows.back();
  }
  void Point(const std::string& id, const std::string& method, double ms, double rms)
  {
    const auto found = std::find_if(this->Of.curves.begin(), this->Of.curves.end(),
      [&](const ReportCurve& curve) { return curve.id == id && curve.method == method; });
    if (found == this->Of.curves.end())
      this->Of.curves.push_back({ id, method, "ms", "of 255, rms", { { ms, rms } } });
    else
      found->points.emplace_back(ms, rms);
  }

  void AddFirst(const Json& first)
  {
    ReportRow& row =
      this->Row("planner.first", 1e-3 * first.at("ms").get<double>(), "s", Better::Lower);
    row.data = "the sample, " + first.at("sample").get<std::string>();
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
    const double rivalMs = QuartilesOf(rival).median, rms = one.at("rms_255").get<double>();
    const double rivalRms = one.at("rival_rms_255").get<double>();
    ReportRow& row = this->Row("planner.isovalue@" + size, ratio.median, "ratio", Better::Lower);
    row.rival = "vtkFlyingEdges3D and its mesh, in the same view: " + FigureText(rivalMs, "ms") +
                ", " + FigureText(rivalRms, "of 255 off");
    row.q1 = ratio.q1;
    row.q3 = ratio.q3;
    row.n = int(ratios.size());
    row.error = rms;
    row.errorUnit = "of 255, rms of the picture to the one at rest";
    row.timeS = 1e-3 * time.median;
    row.data = "phantom " + size +
               "^3, 1280x800; from one isovalue to the next pictures differ by " +
               FigureText(one.at("changed_255").get<double>(), "of 255");
    ReportRow& ms = this->Row("planner.isovalue.ms@" + size, time.median, "ms", Better::Lower);
    ms.q1 = time.q1;
    ms.q3 = time.q3;
    ms.n = int(ours.size());
    if (size == "256")
      ms.bars.push_back({ {}, 100.0 });
    this->Point("planner.isovalue", "the planner, while the isovalue moves", time.median, rms);
    this->Point("planner.isovalue", "vtkFlyingEdges3D's mesh", rivalMs, rivalRms);
  }

  void AddDrag(const Json& drag)
  {
    const Json& full = drag.at("full");
    ReportRow& row = this->Row("planner.drag.fps", Fps(drag), "frames a second", Better::Higher);
    row.bars.push_back({ 15.0, {} });
    row.n = drag.at("frames").get<int>();
    row.error = drag.at("rms_255").get<double>();
    row.errorUnit = "of 255, rms of a picture in motion to all pixels";
    row.timeS = 1e-3 * MsOfFrame(drag);
    row.data = "broken mandible, with contact, 1280x800";
    this->Row("planner.drag.fps.full", Fps(full), "frames a second", Better::Higher).data =
      "the same with all pixels, without dynamic resolution; the picture then differs by " +
      FigureText(full.at("rms_255").get<double>(), "of 255 from the one at rest");
    ReportRow& share =
      this->Row("planner.drag.share", drag.at("share").get<double>(), "share", Better::Higher);
    share.bars.push_back({ 0.5, {} });
    share.data = "least pixels along an axis while it moved";
    ReportRow& touching = this->Row(
      "planner.drag.touching", drag.at("touching").get<double>(), "share", Better::Higher);
    touching.bars.push_back({ 0.5, {} });
    touching.data =
      "looks that found the fragment in contact: else the figures are of another case";
    this->AddTicks(drag);
    for (const Json& one : { drag, full })
      this->Point("planner.drag", one == full ? "all pixels" : "dynamic resolution", MsOfFrame(one),
        one.at("rms_255").get<double>());
  }

  void AddTicks(const Json& drag)
  {
    ReportRow& tick =
      this->Row("planner.drag.tick", drag.at("tick_us").get<double>(), "us", Better::Lower);
    tick.n = drag.at("ticks").get<int>();
    tick.data = "CPU time of a haptic tick beside the frames, median; 99 of 100 within " +
                FigureText(drag.at("tick_us_p99").get<double>(), "us") + "; skipped " +
                std::to_string(drag.at("skipped").get<long long>());
  }

  void AddIdle(const Json& idle)
  {
    ReportRow& row =
      this->Row("planner.idle.frames", idle.at("frames").get<double>(), "count", Better::Lower);
    row.bars.push_back({ {}, 0.0 });
    row.data = "all views, " + FigureText(idle.at("seconds").get<double>(), "s without an event");
  }

  void AddMemory(const Json& reopened)
  {
    constexpr double MiB = 1024.0 * 1024.0, MostKiBATime = 16.0;
    const auto bytes = reopened.at("bytes").get<std::vector<double>>();
    const int times = reopened.at("times").get<int>();
    const double grown = Growth(bytes);
    ReportRow& row = this->Row("planner.reopened", grown / MiB, "MiB", Better::Lower);
    row.n = times;
    row.bars.push_back({ {}, MostKiBATime, "KiB each time", grown / 1024.0 / times });
    const auto [least, most] = std::minmax_element(bytes.begin(), bytes.end());
    row.data = "growth of resident memory, of " + FigureText(bytes.back() / MiB, "MiB") +
               "; it was within " + FigureText((*most - *least) / MiB, "MiB");
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

/// Runs it on $DISPLAY, or on a screen of its own, which goes with it: what is late ends first.
MeasuredChild RunPlanner(const std::vector<std::string>& words)
{
  const std::string limit = std::to_string(MostS);
  std::vector<std::string> run{ "/usr/bin/timeout", "-k", "9", limit, PlannerProgram() };
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
    run.insert(run.begin(), { "/usr/bin/xvfb-run", "-a", "-s", "-screen 0 1280x800x24 -noreset" });
  const std::string program = run.front();
  run.erase(run.begin());
  run.insert(run.end(), words.begin(), words.end());
  return RunMeasured(run, { program, MostS + 60.0 });
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
  if (!context.settings.quick)
    ReportPlannerCases(context);
}

} // namespace hasp
