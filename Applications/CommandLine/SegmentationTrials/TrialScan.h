#pragma once
#include "Segmentation/LabelSplit.h"
#include "SegmentationTrials.h"
#include "Studies/SimulatedStrokes.h"
#include "Studies/SyntheticFracture.h"

#include "Evaluation/Dice.h"

#include <functional>
#include <string>
#include <vector>

namespace hasp
{

/// A broken bone that is scanned, and its truth.
struct TrialScan
{
  std::string key;  ///< "head": of rows' ids
  std::string data; ///< what rows say of it
  FracturedScan scan;
  /// Whether bars hold for it. A hairline of a third of a voxel in noisy CT is no more to be seen.
  bool isBarred = true;

  GridView<const std::int16_t> Samples() const
  {
    return { this->scan.samples.data(), this->scan.geometry };
  }
  GridView<const Label> Truth() const { return { this->scan.truth.data(), this->scan.geometry }; }
};

/// How large and how broken.
struct TrialScanSettings
{
  double headMm = 0.6, mandibleMm = 0.6; ///< spacing of the phantoms
  bool coneBeam = false;
  std::uint64_t seed = 1;
};

/// The smaller ones of quick reports.
TrialScanSettings ScanSettings(const ReportContext& context);

/// One after the other, since a scan holds some hundred MB: head and mandible with hairlines, and
/// the skull, if there is one, with a saw's kerfs and then with hairlines. A minute for a head of
/// 0.6 mm.
void ForEachTrialScan(const TrialScanSettings& settings, const RealSkull& skull,
  const std::function<void(const TrialScan&)>& visit);

/// What is bone in a scan, and how its voxels hang together: what all strokes are tried on.
class TrialBone
{
public:
  /// grey   of the scan, corrected or as it is; lives as long as this
  TrialBone(const AnyGridView& grey, double threshold);
  /// Bone is where `smooth`, the same without its noise, is above the threshold; closed by a ball,
  /// and its cavities filled.
  TrialBone(const AnyGridView& grey, const AnyGridView& smooth, double threshold, double closeMm);

  GridView<const Label> View() const { return { this->Mask.data(), this->Geometry }; }
  const AnyGridView& Grey() const { return this->Samples; }
  std::vector<SeedVoxels> Seeds(const std::vector<BrushStroke>& strokes) const;

private:
  AnyGridView Samples;
  GridGeometry Geometry;
  std::vector<Label> Mask;
};

/// What came of a simulated user's work.
struct TrialResult
{
  SimulatedUser user;
  SegmentationDice dice;
  double firstS = 0.0;  ///< from the mask to the first split
  double strokeS = 0.0; ///< median of one more stroke; 0 if none was needed
  double allS = 0.0;    ///< all splits

  std::string Text() const; ///< strokes, times, and the worst fragments
};

/// A simulated user with the random walker, held to the truth.
TrialResult TryUser(const TrialBone& bone, const TrialScan& scan, int strokes, std::uint64_t seed);

/// One voxel, as surface Dice is asked at: the largest spacing of the scan.
double OneVoxelMm(const GridGeometry& grid);

SegmentationDice CompareWithTruth(
  const TrialScan& scan, const std::vector<Label>& labels, LabelPairing pairing);

} // namespace hasp
