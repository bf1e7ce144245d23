#include "DiceRows.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <cstdio>

namespace hasp
{
namespace
{

constexpr const char* Truth =
  "the voxel truth that the scan was made with; others' methods: segmentation.error_time";

} // namespace

void DiceRows::Put(ReportContext& context, const std::string& id, const Worst& figure,
  const std::string& unit, const std::string& data, double bar, int n) const
{
  ReportRow row;
  row.id = id;
  row.value = figure.dice;
  row.unit = unit;
  row.better = Better::Higher;
  row.rival = Truth;
  row.error = 1.0 - figure.dice;
  row.errorUnit = "1 - " + unit;
  row.timeS = figure.seconds;
  row.n = n;
  row.data = data;
  if (bar > 0.0)
    row.bars = { { bar, {} } };
  context.report.rows.push_back(row);
}

void DiceRows::Add(ReportContext& context, const TrialScan& scan, const TrialResult& result)
{
  char voxel[80];
  std::snprintf(
    voxel, sizeof voxel, "; one voxel: %.3g mm, the largest", OneVoxelMm(scan.scan.geometry));
  const std::string data = scan.data + "; " + this->Strokes + "; " + result.Text();
  const int fragments = static_cast<int>(result.dice.labels.size());
  const Worst volume{ result.dice.Worst().Dice(), result.allS, scan.key };
  const Worst surface{ result.dice.WorstSurface().SurfaceDice(), result.allS, scan.key };
  this->Put(
    context, "segmentation.dice" + this->At + "." + scan.key, volume, "Dice", data, 0.0, fragments);
  this->Put(context, "segmentation.surface" + this->At + "." + scan.key, surface, "surface Dice",
    data + voxel, 0.0, fragments);
  if (!scan.isBarred)
    return;
  ++this->Cases;
  if (volume.dice < this->Volume.dice)
    this->Volume = volume;
  if (surface.dice < this->Surface.dice)
    this->Surface = surface;
}

void DiceRows::AddAbsent(
  ReportContext& context, const std::string& key, const std::string& why) const
{
  for (const char* kind : { "segmentation.dice", "segmentation.surface" })
    context.report.rows.push_back(AbsentRow(kind + this->At + "." + key, Truth, why));
}

void DiceRows::AddWorst(ReportContext& context, double diceBar, double surfaceBar, double aim) const
{
  char of[20] = "";
  if (aim > 0.0)
    std::snprintf(of, sizeof of, "; aim %.2f", aim);
  const std::string text = "; " + this->Strokes + of;
  const auto words = [&](const Worst& worst) { return "worst of all, " + worst.of + text; };
  this->Put(context, "segmentation.dice" + this->At, this->Volume, "Dice", words(this->Volume),
    diceBar, this->Cases);
  this->Put(context, "segmentation.surface" + this->At, this->Surface, "surface Dice",
    words(this->Surface), surfaceBar, this->Cases);
}

} // namespace hasp
