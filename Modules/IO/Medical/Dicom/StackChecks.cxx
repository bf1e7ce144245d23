#include "Dicom/DicomChecks.h"
#include "Volumes/VolumeFormat.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double SamePlaceMm = 1e-3; ///< thinner than any slice

std::string Count(std::size_t number, const char* thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

SliceStack LayoutOf(const DicomSlice& slice)
{
  const SliceRecord& r = slice.record;
  SliceStack layout;
  layout.dims = { int(r.columns), int(r.rows) };
  layout.spacing = { r.spacing[1], r.spacing[0] };
  layout.row = glm::normalize(Vector(r.orientation));
  const glm::dvec3 second = Vector(r.orientation + 3);
  layout.column = glm::normalize(second - glm::dot(second, layout.row) * layout.row);
  return layout;
}

/// Pixels can be the same only if they are read the same way.
bool ReadAlike(const DicomSlice& a, const DicomSlice& b)
{
  const SliceRecord &x = a.record, &y = b.record;
  return x.rows == y.rows && x.columns == y.columns && x.slope == y.slope &&
         x.intercept == y.intercept && x.isSigned == y.isSigned && x.bitsStored == y.bitsStored;
}

/// Leaves one slice a place, the first in the order of the paths.
void TakeDoublesOut(DicomStack& stack, const glm::dvec3& normal)
{
  const auto height = [&](const DicomSlice& s)
  { return glm::dot(Vector(s.record.position), normal); };
  std::stable_sort(stack.slices.begin(), stack.slices.end(),
    [&](const DicomSlice& a, const DicomSlice& b) { return height(a) < height(b); });
  std::vector<DicomSlice> single;
  for (DicomSlice& slice : stack.slices)
    if (!single.empty() && height(slice) - height(single.back()) < SamePlaceMm)
      stack.doubles.push_back({ single.size() - 1, std::move(slice) });
    else
      single.push_back(std::move(slice));
  stack.slices = std::move(single);
  stack.passport.doubledSlices = static_cast<int>(stack.doubles.size());
}

void AddDoubled(
  const DicomStack& stack, const std::vector<int>& places, std::vector<ImportFault>& faults)
{
  if (stack.doubles.empty())
    return;
  const auto& [of, copy] = stack.doubles.front();
  ImportFault fault(FaultKind::DoubledSlices,
    SliceName(stack.slices[of]) + " and " + SliceName(copy) + " lie at the same place");
  fault.resamplable = true;
  if (stack.doubles.size() > 1)
    fault.text += ", and so do " + Count(stack.doubles.size() - 1, "more pair");
  fault.text += "; take one of them out of the folder";
  for (const auto& [original, slice] : stack.doubles)
  {
    fault.slices.push_back(places[original]);
    fault.files.push_back(slice.number);
    // One that lies at its place but not beside it is another picture.
    const glm::dvec3 apart =
      Vector(slice.record.position) - Vector(stack.slices[original].record.position);
    fault.resamplable = fault.resamplable && ReadAlike(stack.slices[original], slice) &&
                        glm::length(apart) < SamePlaceMm;
  }
  fault.slices.erase(std::unique(fault.slices.begin(), fault.slices.end()), fault.slices.end());
  faults.push_back(fault);
}

/// Numbers of the slices along the stack from 1, the missing ones counted, too.
std::vector<int> PlacesOf(const DicomStack& stack, const StackMeasures& measures)
{
  std::vector<int> places;
  std::size_t gap = 0;
  for (int k = 0, place = 1; k < static_cast<int>(stack.slices.size()); ++k, ++place)
  {
    places.push_back(place);
    if (gap < measures.gaps.size() && measures.gaps[gap].below == k)
      place += measures.gaps[gap++].missing;
  }
  return places;
}

/// Missing slices if `missing`, else uneven ones: one fault for all gaps of its kind.
void AddGaps(DicomStack& stack, const StackMeasures& m, const std::vector<int>& places,
  bool missing, std::vector<ImportFault>& faults)
{
  ImportFault fault;
  fault.kind = missing ? FaultKind::MissingSlices : FaultKind::UnevenSpacing;
  const SliceGap* worst = nullptr;
  std::size_t gaps = 0;
  const auto off = [&](const SliceGap& gap) { return std::abs(gap.mm - m.usualGapMm); };
  for (const SliceGap& gap : m.gaps)
  {
    if ((gap.missing > 0) != missing)
      continue;
    ++gaps;
    if (!worst || off(gap) > off(*worst) + 1e-6) // the first of equal ones
      worst = &gap;
    fault.files.push_back(stack.slices[gap.below].number);
    fault.files.push_back(stack.slices[gap.below + 1].number);
    if (!missing)
      fault.slices.push_back(places[gap.below + 1]);
    for (int n = 1; n <= gap.missing; ++n)
      fault.slices.push_back(places[gap.below] + n);
  }
  if (!worst)
    return;
  const std::string between = " between " + SliceName(stack.slices[worst->below]) + " and " +
                              SliceName(stack.slices[worst->below + 1]);
  const std::string further = gaps == 1 ? "" : " (the worst of " + Count(gaps, "such gap") + ")";
  fault.millimetres = worst->mm;
  if (missing)
  {
    const std::size_t count = fault.slices.size();
    stack.passport.missingSlices = static_cast<int>(count);
    fault.text = Count(count, "slice") + (count == 1 ? " is" : " are") + " missing" +
                 (gaps == 1 ? between + ": they are " : ", the most" + between + ": these are ") +
                 Millimetres(worst->mm) + " apart, the others " + Millimetres(m.usualGapMm) +
                 ". Add what is missing, or export the series again";
  }
  else
  {
    stack.passport.unevenGaps = static_cast<int>(gaps);
    fault.text = "the slices are uneven: " + Millimetres(worst->mm) + between + further +
                 ", elsewhere " + Millimetres(m.usualGapMm) +
                 ". Export the series again with even slices";
  }
  const std::string beyond = GapsBeyondLimits(m);
  fault.resamplable = beyond.empty();
  if (!beyond.empty())
    fault.text += "; it is not resampled: " + beyond;
  faults.push_back(fault);
}

/// A slice beside the line of the others is on the way of no gantry.
void AddShifted(const DicomStack& stack, const StackMeasures& m, const std::vector<int>& places,
  std::vector<ImportFault>& faults)
{
  if (!m.tilted || m.straight)
    return;
  const DicomSlice& odd = stack.slices[m.oddSlice];
  ImportFault fault(FaultKind::ShiftedSlices,
    "the slices are shifted against each other: " + SliceName(odd) + " lies " +
      Millimetres(m.oddMm) +
      " beside the line of the others. Export the series again, or take out what does not belong "
      "to it");
  fault.slices = { places[m.oddSlice] };
  fault.files = { odd.number };
  fault.millimetres = m.oddMm;
  faults.push_back(fault);
}

void AddTilt(DicomStack& stack, const StackMeasures& m, const std::vector<int>& places,
  std::vector<ImportFault>& faults)
{
  if (!m.tilted || !m.leaning)
    return;
  const DicomSlice& farthest = stack.slices[m.farthestSlice];
  const double rounding = m.tiltDegrees < 1.0 ? 1000.0 : 10.0;
  stack.passport.tiltDegrees = m.tiltDegrees;
  ImportFault fault(FaultKind::GantryTilt,
    "the stack is tilted: " + SliceName(farthest) + " lies " + Millimetres(m.farthestAsideMm) +
      " beside the axis of " + SliceName(stack.slices.front()) + ", " +
      Text(std::round(rounding * m.tiltDegrees) / rounding) +
      " degrees (gantry tilt?). Straighten the series first");
  fault.slices = { places[m.farthestSlice] };
  fault.files = { farthest.number };
  fault.millimetres = m.farthestAsideMm;
  fault.degrees = m.tiltDegrees;
  const std::string beyond = TiltBeyondLimits(m);
  fault.resamplable = beyond.empty();
  if (!beyond.empty())
    fault.text += "; it is not resampled: " + beyond;
  faults.push_back(fault);
}

} // namespace

void SortAndMeasure(DicomStack& stack)
{
  std::vector<ImportFault>& faults = stack.passport.faults;
  stack.layout = LayoutOf(stack.slices.front());
  TakeDoublesOut(stack, stack.layout.Normal());
  for (const DicomSlice& slice : stack.slices)
    stack.layout.origins.push_back(Vector(slice.record.position));
  GridGeometry& g = stack.passport.geometry;
  g.dims = { stack.layout.dims, int(stack.slices.size()) };
  g.spacing = { stack.layout.spacing, 0.0 };
  g.origin = stack.layout.origins.front();
  g.direction = glm::dmat3(stack.layout.row, stack.layout.column, stack.layout.Normal());
  if (stack.slices.size() < 2)
  {
    AddDoubled(stack, { 1 }, faults);
    faults.emplace_back(
      FaultKind::SingleSlice, "the series has a single slice, a volume needs at least two");
    return;
  }
  const StackMeasures m = MeasureStack(stack.layout);
  const std::vector<int> places = PlacesOf(stack, m);
  AddDoubled(stack, places, faults);
  AddGaps(stack, m, places, true, faults);
  AddGaps(stack, m, places, false, faults);
  AddShifted(stack, m, places, faults);
  AddTilt(stack, m, places, faults);
  stack.passport.gapDeviationMm = m.gapDeviationMm;
  const bool even = m.gaps.empty();
  g.spacing.z = even ? m.heights.back() / double(m.heights.size() - 1) : m.usualGapMm;
}

} // namespace hasp
