#pragma once
#include "Planning/SeedsFile.h"
#include "Planning/SegmentationRecipe.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}
class vtkImageData;

namespace hasp
{

struct Passport;
struct Session;

/// How labels are made of a scan: by a recipe's file, or by what stands on the command line.
struct SegmentationChoices
{
  std::string recipe;
  std::optional<double> threshold;
  std::string preset;
  std::vector<std::string> seeds;
  double seedRadiusMm = 2.0, beta = 90.0, crack = 0.1, norm = 1.0;
  double gaussianMm = 0.0, medianMm = 0.0; ///< 0: none
  double smoothMm = 0.0;                   ///< of the threshold's values alone, 0: not at all
  bool coneBeam = false;
  double fieldMm = 60.0, insideAbove = 0.0;
  double openMm = 0.0, closeMm = 0.0; ///< of bone, 0: not at all
  bool fill = false, keepLargest = false;
  std::optional<double> leastMm3; ///< of pieces that become fragments, where there are no seeds
};

void AddSegmentationOptions(CLI::App& verb, SegmentationChoices& choices);

/// A recipe, of which one threshold may still be open.
struct ChosenSegmentation
{
  SegmentationRecipe recipe;
  std::optional<std::size_t> openThreshold; ///< a step that ProposeThresholdStep is for
  std::optional<Seeds> seeds;               ///< that its split and its names are made of
};

/// Reads what is to be read. Where no threshold is given it is 226 where the values are HU, else
/// left open. Throws Failure.
ChosenSegmentation ChooseSegmentation(
  const SegmentationChoices& choices, const Passport& passport, Session& session);

/// What the histogram of a scan proposes, as the steps before left it and smoothMm blurs it; it is
/// said.
ThresholdStep ProposeThresholdStep(vtkImageData* image, double smoothMm, Session& session);

} // namespace hasp
