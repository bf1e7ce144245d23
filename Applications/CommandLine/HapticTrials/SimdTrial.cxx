#include "HapticTrials.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SimdScene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <span>

namespace hasp
{
namespace
{

constexpr int Points = 20'000;
constexpr const char* RivalO2 = "array of structures, linear float volume, glm, g++ -O2";
constexpr const char* RivalNative =
  "array of structures, linear float volume, glm, g++ -O3 -march=native";

/// One row's figures that the issue names.
struct SimdBar
{
  const char* id;     ///< of the row
  const char* prefix; ///< of the kernels' names
  const char* name;
  ContactTerms terms;
  double bar, aim;
};

constexpr SimdBar Bars[] = {
  { "haptics.simd.static.avx2", "AVX2", "AVX2", ContactTerms::Force, 3.3, 5.0 },
  { "haptics.simd.static.avx512", "AVX3", "AVX-512", ContactTerms::Force, 4.2, 6.0 },
  { "haptics.simd.matrix.avx2", "AVX2", "AVX2", ContactTerms::Matrix, 4.0, 5.0 },
  { "haptics.simd.matrix.avx512", "AVX3", "AVX-512", ContactTerms::Matrix, 5.0, 7.0 },
};

std::string DataText(const SimdScene& scene, ContactTerms terms)
{
  const ContactSums truth = scene.Truth(terms);
  char text[120];
  std::snprintf(text, sizeof text, "%d^3 int16, %u points in the shell's order, %.0f%% in contact",
    scene.Size(), scene.Points(), 100.0 * truth.contacts / scene.Points());
  return text;
}

PairedTimes Race(
  const SimdScene& scene, const ContactKernels& kernels, ContactTerms terms, bool native, int pairs)
{
  constexpr int Repeats = 4; // a millisecond or more each
  const auto many = [](const std::function<void()>& feel)
  {
    for (int n = 0; n < Repeats; ++n)
      feel();
  };
  PairSettings settings;
  settings.pairs = pairs;
  PairedTimes times =
    ComparePairs([&] { return ThreadTimeOf([&] { many([&] { scene.Ours(kernels, terms); }); }); },
      [&] { return ThreadTimeOf([&] { many([&] { scene.Rival(terms, native); }); }); }, settings);
  for (Timing* timing : { &times.a, &times.b })
  {
    timing->wallS /= Repeats;
    timing->cpuS /= Repeats;
  }
  return times;
}

void AddRow(ReportContext& context, const SimdScene& scene, const SimdBar& bar)
{
  const bool quick = context.settings.quick;
  const ContactKernels* kernels = FindKernels(bar.prefix);
  for (const bool native : { false, true })
  {
    const std::string id = IdAt(std::string(bar.id) + (native ? ".native" : ""), scene.Size(), 128);
    const std::string rival = native ? RivalNative : RivalO2;
    if (kernels == nullptr)
    {
      context.report.rows.push_back(AbsentRow(id, rival, WhyNoKernels(bar.name)));
      continue;
    }
    const PairedTimes times = Race(scene, *kernels, bar.terms, native, quick ? 15 : 61);
    const double error = WrenchError(
      scene.Ours(*kernels, bar.terms).contact, scene.Truth(bar.terms).contact, scene.Radius());
    ReportRow row = CpuRatio(id, times, rival, { error, "of the force" },
      std::string(kernels->name) + ", " + DataText(scene, bar.terms), true);
    // AVX-512's bars are those of 128^3.
    if (!native && (scene.Size() == 128 || std::string(bar.prefix) == "AVX2"))
    {
      row.bars = { { bar.bar, {} } };
      row.data += "; aim " + std::to_string(static_cast<int>(bar.aim));
    }
    context.report.rows.push_back(row);
  }
}

/// The largest of all terms, kernels and sizes: vectors against one point after the other on the
/// same map; int16 against float distances, both one after the other.
struct Errors
{
  double lanes = 0.0, int16 = 0.0;
  int vectors = 0, cases = 0;
  Timing time, oneByOne; ///< of 20,000 points, the last case
};

void Measure(const SimdScene& scene, Errors& errors)
{
  const std::vector<ContactKernels> all = AllContactKernels();
  for (const ContactTerms terms : { ContactTerms::Force, ContactTerms::Matrix, ContactTerms::Snap })
  {
    Wrench scalar;
    errors.oneByOne =
      ThreadTimeOf([&] { scalar = scene.Ours(ScalarContactKernels(), terms).contact; });
    errors.int16 =
      WorseOf(errors.int16, WrenchError(scalar, scene.Truth(terms).contact, scene.Radius()));
    ++errors.cases;
    for (const ContactKernels& kernels : std::span(all).subspan(1)) // the first is the scalar one
    {
      ContactSums sums;
      errors.time = ThreadTimeOf([&] { sums = scene.Ours(kernels, terms); });
      errors.lanes = WorseOf(errors.lanes, WrenchError(sums.contact, scalar, scene.Radius()));
      ++errors.vectors;
    }
  }
}

void AddErrors(ReportContext& context, const Errors& errors)
{
  const std::string data = "128^3 and 256^3, " + std::to_string(Points) +
                           " points, half in contact; force alone, with its matrix, Snap-to-fit";
  ReportRow lanes = ErrorFigure("haptics.wrench", { errors.lanes, "of the force" },
    "one point after the other on the same int16 map", errors.time, data);
  lanes.n = errors.vectors;
  lanes.bars = { { {}, 1e-5 } };
  if (AllContactKernels().size() == 1)
    lanes = AbsentRow("haptics.wrench", lanes.rival, WhyNoKernels("vectors"));
  ReportRow int16 = ErrorFigure("haptics.wrench.int16", { errors.int16, "of the force" },
    "the same bricks in float", errors.oneByOne, data);
  int16.n = errors.cases;
  int16.bars = { { {}, 1e-4 } };
  context.report.rows.insert(context.report.rows.end(), { lanes, int16 });
}

} // namespace

void TrySimd(ReportContext& context)
{
  Errors errors;
  for (const int samples : { 128, 256 })
  {
    const SimdScene scene(samples, Points);
    for (const SimdBar& bar : Bars)
      AddRow(context, scene, bar);
    Measure(scene, errors);
  }
  AddErrors(context, errors);
}

} // namespace hasp
