#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"
#include "Grid/SliceStack.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Makes a regular volume of a stack that is tilted, lacks slices or is uneven.
///
/// Cubic between the measured slices around a made one, without leaving the range of the two next
/// to it (Fritsch & Carlson 1980), and bilinear within a slice that has to move sideways by a part
/// of a sample. A slice at its place, or whole samples beside it, is copied as it is.
namespace hasp
{

/// What is still mended. Beyond it a stack is refused: too much of it would be made up.
struct ResampleLimits
{
  int gapSlices = 5;         ///< slices made in one gap, >= 0
  double gapMm = 10.0;       ///< distance of the measured slices around a made one, mm, > 0
  double madeShare = 0.2;    ///< of all slices: those made where slices are missing, in [0,1]
  double tiltDegrees = 45.0; ///< in (0, 90); no gantry tilts so far
};

/// What was done to a stack, and how far its surfaces may be off.
///
/// The error is measured on the stack itself by leaving out: slices that were measured are
/// predicted from their neighbours as the made ones are, over the same distance, and at strong
/// edges the way along the gradient from the measured to the predicted surface is taken, at the
/// worst gap. It says what resampling adds; what the scanner's own slices miss between them is not
/// in it. A surface that is not found between the two slices counts as their distance. Against
/// closed forms (sphere, torus, gyroid, shell; tilts of 5 to 25 degrees, gaps of 1 to 5 slices)
/// error95 was 0.77 to 7.6 times the true one where that is above 0.01 mm: TestResampleStack prints
/// the table.
struct ResampleRecord
{
  double tiltDegrees = 0.0;  ///< that was rectified, in [0, 90); 0: there was none
  double farthestMove = 0.0; ///< mm by which a slice moved within its plane, >= 0
  int slicesMeasured = 0;    ///< that came in
  int slicesCopied = 0;      ///< of the result: each lies at a measured slice
  int slicesMade = 0;        ///< of the result: between measured slices
  int slicesFilled = 0;      ///< of the made ones: where slices are missing
  double farthestMm = 0.0;   ///< of a made sample from the nearest measured slice
  double forgivenMm = 0.0;   ///< largest distance of a copied slice from its place in the result
  double outsideShare = 0.0; ///< of the result's samples: beside every slice, set to the smallest
                             ///< measured sample; in [0,1)
  bool errorKnown = true;    ///< false: something was made, and there is nothing to measure it by
  int edgesJudged = 0;       ///< strong edges the error was measured at
  double error50 = 0.0;      ///< mm, half of the edges are off by no more
  double error95 = 0.0;      ///< mm, 95 % of them are off by no more
};

/// One slice of the result: (1 - share) * below + share * above.
struct SliceRecipe
{
  int below = 0;      ///< index of a measured slice
  int above = 0;      ///< the same or the next one
  double share = 0.0; ///< in [0,1); 0: `below` alone
};

/// How a stack is to be resampled. Made by PlanResampling only.
struct ResamplePlan
{
  SliceStack stack;
  StackMeasures measures;
  GridGeometry geometry;           ///< of the result: right-handed, axes row, column, normal
  std::vector<glm::dvec2> shifts;  ///< per measured slice, in samples: its (0,0) in the result
  std::vector<SliceRecipe> slices; ///< per slice of the result
  ResampleRecord record;           ///< all but the outside share and the error
};

/// Why a stack is beyond the limits, as a part of a sentence ("a gap of 12 mm needs 11 slices, at
/// most 5 are made in one gap"); empty if it is not.
std::string GapsBeyondLimits(const StackMeasures& measures, const ResampleLimits& limits = {});
std::string TiltBeyondLimits(const StackMeasures& measures, const ResampleLimits& limits = {});

/// The result's slices have the usual distance of the stack, stretched so that the first and the
/// last measured slice are slices of the result; its rows and columns are those of the first slice,
/// continued as far as any slice reaches. A stack that is regular keeps its geometry.
/// Throws std::invalid_argument like MeasureStack; beyond the limits; and for slices that lie
/// sideways without being on one line, which no tilt explains.
ResamplePlan PlanResampling(const SliceStack& stack, const ResampleLimits& limits = {});

/// Carries a plan out and measures its error.
///
/// samples    stack.dims.x * stack.dims.y values a slice, slices in the stack's order, all finite
/// result     geometry.Size() values, not overlapping the samples
///
/// T is int16 (rounded to the nearest, halves to even) or float. No value is made that is outside
/// the range of the measured ones. All threads, the same bits with any number of them. Throws
/// Cancelled. O(result), and about a second at most for the error.
template <typename T>
ResampleRecord Resample(
  const ResamplePlan& plan, const T* samples, T* result, const ProgressFunction& progress = {});

/// The error alone, into the record. Part of Resample.
template <typename T>
void MeasureResamplingError(const ResamplePlan& plan, const T* samples, ResampleRecord& record);

} // namespace hasp
