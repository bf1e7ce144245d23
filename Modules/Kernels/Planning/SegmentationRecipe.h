#pragma once
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

/// How bone becomes fragments, as plain values: what is done to a scan's samples, what is bone, and
/// what each voxel of it belongs to. Steps are done in order, each to what those before it left, so
/// that a segmentation can be made again, taken back step by step, and told apart from another.
/// Label 0 is nothing, 1 is bone that nobody has named yet, and a fragment is a label of its own.
/// World = patient LPS, mm.
namespace hasp
{

/// What a recipe has room for.
inline constexpr std::size_t MostSegmentationSteps = 10'000, MostStrokes = 10'000,
                             MostStrokePoints = 100'000;

/// Gaussian blur of the samples.
struct GaussianStep
{
  double sigmaMm = 0.5; ///< standard deviation, (0, 10]
  bool operator==(const GaussianStep&) const noexcept = default;
};

/// Median of the samples in a box; of more than 4,096 of the scan's voxels it is refused there.
struct MedianStep
{
  double radiusMm = 1.0; ///< half the box's edge, (0, 10]; at least one voxel each way
  bool operator==(const MedianStep&) const noexcept = default;
};

/// Edge-preserving filter (anisotropic diffusion): noise goes, edges stay.
struct EdgePreservingStep
{
  double edge = 100.0; ///< steps from voxel to voxel above this are edges, grey values, (0, 1e6]
  int iterations = 4;  ///< [1, 100]
  bool operator==(const EdgePreservingStep&) const noexcept = default;
};

/// What cone-beam scanners do wrong, taken back as far as it can be: shading that varies slowly
/// (cupping, bias), then contrast that varies from place to place.
struct ConeBeamStep
{
  double fieldMm = 60.0;    ///< shading is smooth over this length, [10, 500]
  double contrastMm = 0.0;  ///< grey is normalised over this length, 0: not at all, else [5, 100]
  double insideAbove = 0.0; ///< the patient is grey value > this, [-1e6, 1e6]
  bool operator==(const ConeBeamStep&) const noexcept = default;
};

/// Bone is lowest <= value <= highest: label 1 there, 0 elsewhere. Forgets all labels before it.
struct ThresholdStep
{
  double lowest = 226.0; ///< [-1e6, 1e6]
  double highest = 1e6;  ///< [lowest, 1e6]
  /// Values are blurred before, by a Gaussian of this standard deviation, 0: not at all, else up to
  /// 10. For this step alone: a split sees cracks that such a blur would close.
  double smoothMm = 0.0;
  bool operator==(const ThresholdStep&) const noexcept = default;
};

/// A brush drawn along a line: all within radiusMm of it.
struct BrushStroke
{
  std::uint16_t label = 2;        ///< what it marks; [0, 65535], 0 where it says so
  double radiusMm = 2.0;          ///< (0, 50]
  std::vector<glm::dvec3> points; ///< of the line, world; 1 to MostStrokePoints
  bool operator==(const BrushStroke&) const noexcept = default;
};

/// The voxels of a label are shared out among the labels of strokes that touch it. With norm 2 each
/// goes to the stroke that a random walk from it meets first, most likely (Grady 2006; BoneSplit);
/// with a smaller norm borders keep more to edges and cracks, up to the least cut with norm 1
/// (Sinop and Grady 2007). What no stroke is connected to keeps its label.
struct SplitStep
{
  std::uint16_t label = 1;          ///< whose voxels; [1, 65535]
  std::vector<BrushStroke> strokes; ///< labels in [1, 65535]; at most MostStrokes
  double beta = 90.0; ///< how much an edge of the image holds a walk back, [0, 1e12]; VoxelGraph.h
  double crack = 0.1; ///< a crack that is so deep holds it back to 1/e, [0, 1]; 0: none does
  double norm = 1.0;  ///< of differences of probabilities that is least, [1, 2]; SharpWalker.h
  bool operator==(const SplitStep&) const noexcept = default;
};

/// Voxels within a stroke become of its label, or nothing (label 0).
struct PaintStep
{
  BrushStroke stroke;     ///< label 0 erases
  std::uint16_t only = 0; ///< leaves all voxels but those of this label alone; 0: paints any
  bool operator==(const PaintStep&) const noexcept = default;
};

/// All voxels of a label become of another, or nothing (into 0).
struct MergeStep
{
  std::uint16_t from = 2; ///< [1, 65535]
  std::uint16_t into = 1; ///< [0, 65535], another than from
  bool operator==(const MergeStep&) const noexcept = default;
};

/// Connected pieces of a label (faces touch) become labels of their own: the largest keeps it, the
/// others get the next free numbers, large before small; what is smaller than leastMm3 is removed.
struct ComponentsStep
{
  std::uint16_t label = 1;       ///< [1, 65535]
  double leastMm3 = 0.0;         ///< [0, 1e9]
  bool keepLargestAlone = false; ///< all others are removed
  bool operator==(const ComponentsStep&) const noexcept = default;
};

/// Cavities of a label: voxels of label 0 from which no way leads out of the scan.
struct FillStep
{
  std::uint16_t label = 1; ///< [1, 65535]
  bool operator==(const FillStep&) const noexcept = default;
};

enum class Morphology
{
  Dilate,
  Erode,
  Open, ///< erode, then dilate: what is thinner than the ball goes
  Close ///< dilate, then erode: gaps narrower than the ball go
};

/// With a ball in world mm. Grows into label 0 alone, never into another fragment; the border of
/// the scan is no edge of the bone.
struct MorphologyStep
{
  std::uint16_t label = 1; ///< [1, 65535]
  Morphology operation = Morphology::Dilate;
  double radiusMm = 1.0; ///< (0, 50]
  bool operator==(const MorphologyStep&) const noexcept = default;
};

/// A new kind of step is a line here.
using SegmentationStep = std::variant<GaussianStep, MedianStep, EdgePreservingStep, ConeBeamStep,
  ThresholdStep, SplitStep, PaintStep, MergeStep, ComponentsStep, FillStep, MorphologyStep>;

/// What a label is called and how it is drawn. The user's words.
struct LabelName
{
  std::uint16_t label = 1; ///< [1, 65535]
  std::string name;        ///< UTF-8, at most 200 bytes, no control characters
  std::array<std::uint8_t, 3> colour{ 227, 218, 201 }; ///< red, green, blue
  bool operator==(const LabelName&) const noexcept = default;
};

/// What a segmentation is made from, besides the scan. A plain value.
struct SegmentationRecipe
{
  std::vector<SegmentationStep> steps; ///< at most MostSegmentationSteps; filters before all others
  std::vector<LabelName> names;        ///< each label once
  bool operator==(const SegmentationRecipe&) const noexcept = default;
};

/// Whether a step changes the samples and not the labels.
bool IsImageFilter(const SegmentationStep& step);

/// What a menu calls it: "Gaussian filter", "Split label 1". No text of the user's.
std::string StepLabel(const SegmentationStep& step);

/// Throws std::invalid_argument unless every number is finite and in its range, no filter stands
/// behind a step that is none and each label is named once. The message names the key as it stands
/// in the file, its value and the legal range ("segmentation recipe: steps[3]: sigmaMm is 0, must
/// be in (0, 10]"). O(points).
void ValidateSegmentationRecipe(const SegmentationRecipe& recipe);

/// The same of one step, but for its place among the others, or of one stroke of a label from
/// leastLabel on. `subject` begins the message.
void ValidateSegmentationStep(const SegmentationStep& step, const std::string& subject);
void ValidateBrushStroke(
  const BrushStroke& stroke, const std::string& subject, std::uint16_t leastLabel = 1);

/// Each label once, in [1, 65535], and its name a text that can be shown. `subject` begins the
/// message, which calls the list `list` and does not say a name.
void ValidateLabelNames(
  const std::vector<LabelName>& names, const std::string& subject, const char* list = "names");

} // namespace hasp
