#include "Segmentation/ConeBeam.h"

#include "Grid/ProgressPart.h"
#include "Segmentation/ConeBeamField.h"
#include "Segmentation/ConeBeamLevels.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

void Check(const AnyGridView& grid, const ConeBeamSettings& settings, const GridGeometry& corrected)
{
  GeometryOf(grid).Validate();
  const auto range = [](const char* name, double value, double low, double high)
  {
    if (!(value >= low && value <= high))
      throw std::invalid_argument(std::string("cone beam: ") + name + " is " +
                                  std::to_string(value) + ", must be in [" + std::to_string(low) +
                                  ", " + std::to_string(high) + "]");
  };
  range("fieldMm", settings.fieldMm, 10.0, 500.0);
  if (settings.contrastMm != 0.0)
    range("contrastMm, where it is not 0,", settings.contrastMm, 5.0, 100.0);
  range("insideAbove", settings.insideAbove, -1e6, 1e6);
  if (GeometryOf(grid).dims != corrected.dims)
    throw std::invalid_argument("cone beam: the corrected image must be as large as the scan");
}

/// Grey values on a scale of the patient's own: with air 0 is air and 1 soft tissue, without it 1
/// is soft tissue and the patient's values span 1.
struct Scale
{
  double zero, unit;

  double operator()(double grey) const { return (grey - this->zero) / this->unit; }
  double Grey(double share) const { return this->zero + share * this->unit; }
};

Scale ScaleOf(const ConeBeamLevels& levels)
{
  if (levels.air)
    return { *levels.air, levels.softTissue - *levels.air };
  const double span = levels.highest - levels.lowest;
  return { levels.softTissue - span, span };
}

/// Means of what lies within `window` of the field, by Tukey's biweight.
BlockData NearField(const BlockGrid& grid, const BlockHistograms& histograms,
  const std::vector<double>& field, double window)
{
  BlockData data{ std::vector<double>(grid.Size()), std::vector<double>(grid.Size()) };
  const BlockField between(grid, field);
  const double whole = double(grid.voxels.x) * grid.voxels.y * grid.voxels.z;
  for (std::size_t n = 0; n < grid.Size(); ++n)
  {
    const BlockHistograms::Block& block = histograms.blocks[n];
    const glm::ivec3 at(
      n % grid.count.x, n / grid.count.x % grid.count.y, n / grid.count.x / grid.count.y);
    // The samples lie around their centroid, not around the block's middle.
    const double there = between.At(glm::dvec3(at) + glm::dvec3(block.centroid));
    double weight = 0.0, sum = 0.0;
    for (int b = 0; b < BlockHistograms::Bins; ++b)
    {
      const double off = (block.mean[b] - there) / window;
      if (block.count[b] == 0 || std::abs(off) >= 1.0)
        continue;
      const double w = block.count[b] * std::pow(1.0 - off * off, 2.0);
      weight += w;
      sum += w * block.mean[b];
    }
    if (weight > 0.0)
    {
      data.weight[n] = weight / whole;
      data.value[n] = sum / weight - (there - field[n]);
    }
  }
  return data;
}

/// Standard deviation of soft tissue about the field, from the median of its distances.
double NoiseAbout(
  const BlockHistograms& histograms, const std::vector<double>& field, double window)
{
  constexpr int steps = 200;
  std::array<double, steps> counts{};
  double all = 0.0;
  for (std::size_t n = 0; n < field.size(); ++n)
    for (int b = 0; b < BlockHistograms::Bins; ++b)
    {
      const double off = std::abs(histograms.blocks[n].mean[b] - field[n]) / window;
      if (histograms.blocks[n].count[b] == 0 || off >= 1.0)
        continue;
      counts[static_cast<int>(off * steps)] += histograms.blocks[n].count[b];
      all += histograms.blocks[n].count[b];
    }
  double sum = 0.0;
  for (int s = 0; s < steps; ++s)
    if ((sum += counts[s]) >= 0.5 * all)
      return 1.4826 * window * (s + 0.5) / steps; // of a normal distribution
  return window;
}

struct Shading
{
  std::vector<double> field;                      ///< soft tissue's value on the Scale, a block
  double mean = 1.0, lowest = 1.0, highest = 1.0; ///< of it, where there is soft tissue
};

constexpr double Widest = 0.3; ///< biweight at first: cupping is within, compact bone is not
constexpr double LeastGain = 0.5, MostGain = 2.0;

Shading FindShading(const BlockGrid& grid, const BlockHistograms& histograms, double fieldMm,
  const ProgressFunction& progress)
{
  constexpr std::array<double, 7> windows{ Widest, 0.24, 0.19, 0.15, 0.12, 0.1, 0.1 };
  Shading shading{ std::vector<double>(grid.Size(), 1.0) };
  BlockData data;
  for (std::size_t step = 0; step < windows.size(); ++step)
  {
    // Four standard deviations: less would cut soft tissue's own noise off on one side.
    const double noise = NoiseAbout(histograms, shading.field, Widest);
    const double window = std::min(std::max(windows[step], 4.0 * noise), Widest);
    data = NearField(grid, histograms, shading.field, window);
    const bool last = step + 1 == windows.size();
    FitThinPlate(grid, data, fieldMm, last ? 1e-5 : 1e-3, shading.field,
      PartOf(progress, double(step) / windows.size(), double(step + 1) / windows.size()));
    for (double& f : shading.field)
      f = std::clamp(f, LeastGain, MostGain);
  }
  double weights = 0.0, sum = 0.0;
  shading.lowest = MostGain;
  shading.highest = LeastGain;
  for (std::size_t n = 0; n < grid.Size(); ++n)
  {
    weights += data.weight[n];
    sum += data.weight[n] * shading.field[n];
    if (data.weight[n] < 0.1)
      continue;
    shading.lowest = std::min(shading.lowest, shading.field[n]);
    shading.highest = std::max(shading.highest, shading.field[n]);
  }
  if (weights > 0.0)
    shading.mean = sum / weights;
  if (shading.lowest > shading.highest)
    shading.lowest = shading.highest = shading.mean; // no block has more than a few samples
  return shading;
}

/// body(row of the field, number of its first sample) for all rows, on all threads.
template <typename Body>
void ForEachRow(const BlockGrid& grid, const std::vector<double>& field,
  const ProgressFunction& progress, const Body& body)
{
  const BlockField between(grid, field);
  const std::int64_t rows = std::int64_t(grid.dims.y) * grid.dims.z;
  const std::int64_t grain = std::max(1, 65536 / grid.dims.x), together = 64 * grain;
  for (std::int64_t from = 0; from < rows; from += together)
  {
    ReportProgress(progress, double(from) / double(rows));
    ParallelFor(from, std::min(from + together, rows), grain,
      [&](std::int64_t first, std::int64_t last)
      {
        std::vector<float> row;
        for (std::int64_t n = first; n < last; ++n)
        {
          between.Row(static_cast<int>(n % grid.dims.y), static_cast<int>(n / grid.dims.y), row);
          body(row, n * grid.dims.x);
        }
      });
  }
}

template <typename T>
class Correction
{
public:
  Correction(const GridView<const T>& view, const ConeBeamSettings& settings, float* corrected)
    : View(view),
      Settings(settings),
      Corrected(corrected)
  {
  }

  ConeBeamFindings Run(const ProgressFunction& progress)
  {
    const ConeBeamLevels levels =
      FindConeBeamLevels(this->View, this->Settings.insideAbove, PartOf(progress, 0.0, 0.25));
    ConeBeamFindings found;
    found.air = levels.air;
    found.softTissue = levels.softTissue;
    const Scale scale = ScaleOf(levels);
    if (!(levels.highest > levels.lowest) || !(scale.unit > 0.0))
    {
      if (!levels.air)
        found.lowest = found.highest = 0.0;
      this->Copy(); // one single value has no shading
      return found;
    }
    const double last = this->Settings.contrastMm > 0.0 ? 0.7 : 1.0;
    this->RemoveShading(scale, found, PartOf(progress, 0.25, last));
    if (this->Settings.contrastMm > 0.0)
      this->LevelContrast(scale.unit, levels.highest, found, PartOf(progress, last, 1.0));
    ReportProgress(progress, 1.0);
    return found;
  }

private:
  bool Inside(std::size_t n) const
  {
    const double value = this->View.data[n];
    return value > this->Settings.insideAbove && std::isfinite(value);
  }

  void Copy() { std::copy_n(this->View.data, this->View.geometry.Size(), this->Corrected); }

  void RemoveShading(const Scale& scale, ConeBeamFindings& found, const ProgressFunction& progress)
  {
    const BlockGrid grid = MakeBlocks(this->View.geometry, this->Settings.fieldMm / 6.0);
    const auto value = [&](std::size_t n)
    { return this->Inside(n) ? scale(this->View.data[n]) : -1.0; };
    const BlockHistograms histograms =
      CountBlocks(grid, 1.0 - 2.0 * Widest, 1.0 + 2.0 * Widest, value, PartOf(progress, 0.0, 0.4));
    const Shading shading =
      FindShading(grid, histograms, this->Settings.fieldMm, PartOf(progress, 0.4, 0.6));
    const double mean = shading.mean;
    found.softTissue = scale.Grey(mean);
    found.lowest = found.air ? shading.lowest / mean : (shading.lowest - mean) * scale.unit;
    found.highest = found.air ? shading.highest / mean : (shading.highest - mean) * scale.unit;
    const bool gain = found.air.has_value();
    ForEachRow(grid, shading.field, PartOf(progress, 0.6, 1.0),
      [&](const std::vector<float>& field, std::size_t first)
      {
        for (std::size_t i = 0; i < field.size(); ++i)
        {
          const T sample = this->View.data[first + i];
          if (!this->Inside(first + i))
            this->Corrected[first + i] = sample;
          else if (const double f = std::clamp<double>(field[i], LeastGain, MostGain); gain)
            this->Corrected[first + i] =
              static_cast<float>(scale.zero + (sample - scale.zero) * (mean / f));
          else
            this->Corrected[first + i] = static_cast<float>(sample - (f - mean) * scale.unit);
        }
      });
  }

  void LevelContrast(
    double unit, double highest, ConeBeamFindings& found, const ProgressFunction& progress);

  const GridView<const T>& View;
  ConeBeamSettings Settings;
  float* Corrected;
};

/// Samples that exceed soft tissue by more than half of `contrast`, and the sum of their excess.
void SumAbove(const BlockHistograms::Block& block, double contrast, double& count, double& excess)
{
  for (int b = 0; b < BlockHistograms::Bins; ++b)
    if (block.mean[b] > 0.5 * contrast)
    {
      count += block.count[b];
      excess += double(block.count[b]) * block.mean[b];
    }
}

/// The level that is twice the threshold halfway between soft tissue, 0, and the mean above it.
double MeanContrast(const BlockHistograms& histograms, double highest)
{
  double contrast = highest;
  for (int step = 0; step < 20; ++step)
  {
    double count = 0.0, excess = 0.0;
    for (const BlockHistograms::Block& block : histograms.blocks)
      SumAbove(block, contrast, count, excess);
    if (count == 0.0)
      return 0.0;
    contrast = excess / count;
  }
  return contrast;
}

template <typename T>
void Correction<T>::LevelContrast(
  double unit, double highest, ConeBeamFindings& found, const ProgressFunction& progress)
{
  const double soft = found.softTissue, top = highest - soft;
  if (!(top > 0.01 * unit))
    return; // nothing stands out
  const BlockGrid grid = MakeBlocks(this->View.geometry, this->Settings.contrastMm / 6.0);
  const auto excess = [&](std::size_t n)
  { return this->Inside(n) ? std::min<double>(this->Corrected[n] - soft, 0.999 * top) : -1.0; };
  const BlockHistograms histograms =
    CountBlocks(grid, 0.0, top, excess, PartOf(progress, 0.0, 0.5));
  const double mean = MeanContrast(histograms, top);
  found.boneContrast = mean;
  if (mean == 0.0)
    return;
  constexpr double few = 0.01; // of a window's samples: fewer say little against the mean
  const double whole = double(grid.voxels.x) * grid.voxels.y * grid.voxels.z;
  std::vector<double> contrast(grid.Size(), mean);
  for (int step = 0; step < 4; ++step)
  {
    std::vector<double> counts(grid.Size()), sums(grid.Size());
    for (std::size_t n = 0; n < grid.Size(); ++n)
      SumAbove(histograms.blocks[n], contrast[n], counts[n], sums[n]);
    BlurBlocks(grid, 0.5 * this->Settings.contrastMm, counts);
    BlurBlocks(grid, 0.5 * this->Settings.contrastMm, sums);
    for (std::size_t n = 0; n < grid.Size(); ++n)
      contrast[n] = (sums[n] + few * whole * mean) / (counts[n] + few * whole);
  }
  ForEachRow(grid, contrast, PartOf(progress, 0.5, 1.0),
    [&](const std::vector<float>& there, std::size_t first)
    {
      for (std::size_t i = 0; i < there.size(); ++i)
      {
        float& sample = this->Corrected[first + i];
        if (this->Inside(first + i) && sample > soft)
          sample = static_cast<float>(
            soft + (sample - soft) * mean / std::clamp<double>(there[i], 0.5 * mean, 2.0 * mean));
      }
    });
}

} // namespace

ConeBeamFindings CorrectConeBeam(const AnyGridView& grid, const ConeBeamSettings& settings,
  GridView<float> corrected, const ProgressFunction& progress)
{
  Check(grid, settings, corrected.geometry);
  return std::visit(
    [&](const auto& view)
    {
      using Sample = std::remove_cv_t<std::remove_reference_t<decltype(*view.data)>>;
      return Correction<Sample>(view, settings, corrected.data).Run(progress);
    },
    grid);
}

} // namespace hasp
