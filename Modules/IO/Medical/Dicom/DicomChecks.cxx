#include "Dicom/DicomChecks.h"
#include "Dicom/DicomTerms.h"
#include "Volumes/VolumeFormat.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hasp
{
namespace
{

const char* const ExportAgain = "; export the series again from its source";

glm::dvec3 Vector(const double* numbers)
{
  return { numbers[0], numbers[1], numbers[2] };
}

bool Finite(const double* numbers, int count)
{
  return std::all_of(numbers, numbers + count, [](double n) { return std::isfinite(n); });
}

std::string Millimetres(double value)
{
  return Text(std::round(value * 1e4) / 1e4) + " mm";
}

void CheckGeometry(const std::filesystem::path& folder, const DicomSlice& slice)
{
  const SliceRecord& r = slice.record;
  const auto fail = [&](const std::string& what)
  { ThrowFileError(folder, SliceName(slice) + " " + what); };
  if (!(r.flags & HasSpacing))
    fail("says no pixel spacing (0028,0030), and none is guessed" + std::string(ExportAgain));
  if (!Finite(r.spacing, 2) || !(r.spacing[0] > 0.0 && r.spacing[1] > 0.0))
    fail("has a pixel spacing of " + Text(r.spacing[0]) + " x " + Text(r.spacing[1]) +
         " mm, must be > 0" + ExportAgain);
  if (!(r.flags & HasPosition))
    fail("says no position (0020,0032)" + std::string(ExportAgain));
  if (!Finite(r.position, 3))
    fail("has a position (0020,0032) that is no finite number" + std::string(ExportAgain));
  if (!(r.flags & HasOrientation) || !Finite(r.orientation, 6))
    fail("says no usable orientation (0020,0037)" + std::string(ExportAgain));
  const glm::dvec3 row = Vector(r.orientation), column = Vector(r.orientation + 3);
  // Direction cosines are written with six decimals or so: 1e-3 forgives that and no real shear.
  if (std::abs(glm::length(row) - 1.0) > 1e-3 || std::abs(glm::length(column) - 1.0) > 1e-3 ||
      std::abs(glm::dot(row, column)) > 1e-3)
    fail("has an orientation (0020,0037) that is not two unit vectors at right angles" +
         std::string(ExportAgain));
  if (!std::isfinite(r.slope) || !std::isfinite(r.intercept) || r.slope == 0.0)
    fail("rescales by " + Text(r.slope) + " x + " + Text(r.intercept) +
         "; the slope must not be 0 and both must be finite" + ExportAgain);
}

/// How a slice differs from another in what all of a series must share; empty if it does not.
std::string Difference(const DicomSlice& slice, const DicomSlice& reference)
{
  const SliceRecord &a = reference.record, &b = slice.record;
  if (a.rows != b.rows || a.columns != b.columns)
    return "has " + std::to_string(b.columns) + " x " + std::to_string(b.rows) + " pixels, not " +
           std::to_string(a.columns) + " x " + std::to_string(a.rows) + " as";
  // A hundredth of a percent over 512 pixels is a twentieth of a pixel.
  for (int n = 0; n < 2; ++n)
    if (std::abs(a.spacing[n] - b.spacing[n]) > 1e-4 * a.spacing[n])
      return "has a pixel spacing of " + Millimetres(b.spacing[n]) + ", not " +
             Millimetres(a.spacing[n]) + " as";
  for (int n = 0; n < 6; ++n)
    if (std::abs(a.orientation[n] - b.orientation[n]) > 1e-3)
      return "is turned against";
  return std::strcmp(a.frame, b.frame) != 0 ? "has another frame of reference than" : "";
}

/// Missing or uneven, named with numbers.
[[noreturn]] void ThrowGap(const std::filesystem::path& folder, const DicomSlice& before,
  const DicomSlice& after, double gap, double usual)
{
  const std::string between = " between " + SliceName(before) + " and " + SliceName(after);
  const double ratio = gap / usual;
  const long missing = std::lround(ratio) - 1;
  if (missing >= 1 && std::abs(ratio - std::round(ratio)) < 0.05)
    ThrowFileError(folder, std::to_string(missing) + (missing == 1 ? " slice is" : " slices are") +
                             " missing" + between + ": they are " + Millimetres(gap) +
                             " apart, the others " + Millimetres(usual) +
                             ". Add what is missing, or export the series again");
  ThrowFileError(folder, "the slices are uneven: " + Millimetres(gap) + between + ", elsewhere " +
                           Millimetres(usual) + ". Resample the series to even slices first");
}

void CheckTilt(const std::filesystem::path& folder, const std::vector<DicomSlice>& slices,
  const glm::dvec3& normal)
{
  const SliceRecord& first = slices.front().record;
  const double allowed = 0.1 * std::min(first.spacing[0], first.spacing[1]);
  for (const DicomSlice& slice : slices)
  {
    const glm::dvec3 way = Vector(slice.record.position) - Vector(first.position);
    const double along = glm::dot(way, normal), aside = glm::length(way - along * normal);
    if (aside > allowed)
      ThrowFileError(
        folder, "the stack is tilted: " + SliceName(slice) + " lies " + Millimetres(aside) +
                  " beside the axis of " + SliceName(slices.front()) + ", " +
                  Text(std::round(10.0 * glm::degrees(std::atan2(aside, along))) / 10.0) +
                  " degrees (gantry tilt?). Straighten the series first");
  }
}

} // namespace

void CheckSlice(const std::filesystem::path& folder, const DicomSlice& slice)
{
  const SliceRecord& r = slice.record;
  const auto fail = [&](const std::string& what)
  { ThrowFileError(folder, SliceName(slice) + " " + what); };
  if (r.status == static_cast<std::uint32_t>(SliceStatus::Undecodable))
    fail("is compressed as \"" + std::string(r.transferSyntax) +
         "\", for which there is no decoder; " + RemedyFor(r.transferSyntax));
  if (r.frames != 1)
    fail("holds " + std::to_string(r.frames) +
         " frames; export the series as one file per slice (\"classic\", not \"enhanced\")");
  if (r.samplesPerPixel != 1 || !(r.flags & (Monochrome1 | Monochrome2)))
    fail("is a colour picture; choose a series of a scan");
  if ((r.bitsAllocated != 8 && r.bitsAllocated != 16) || r.bitsStored < 1 ||
      r.bitsStored > r.bitsAllocated || r.highBit >= r.bitsAllocated ||
      r.highBit + 1 < r.bitsStored || r.isSigned > 1)
    fail("has " + std::to_string(r.bitsStored) + " bits stored in " +
         std::to_string(r.bitsAllocated) + "; 8 and 16 are read");
  const std::uint64_t pixelBytes = std::uint64_t(r.rows) * r.columns * (r.bitsAllocated / 8);
  if (!(r.flags & Packed) && pixelBytes > slice.fileBytes)
    fail("declares " + std::to_string(r.columns) + " x " + std::to_string(r.rows) + " pixels, " +
         std::to_string(pixelBytes) + " bytes; the file has only " +
         std::to_string(slice.fileBytes) + ": it is cut off. Copy it again");
  CheckGeometry(folder, slice);
}

void CheckAlike(const std::filesystem::path& folder, const std::vector<DicomSlice>& slices)
{
  // The odd one is to be named: if most differ from the first slice, the first is the odd one.
  const auto differs = [](const DicomSlice& reference)
  { return [&](const DicomSlice& slice) { return !Difference(slice, reference).empty(); }; };
  const DicomSlice* usual = &slices.front();
  if (std::size_t(std::count_if(slices.begin(), slices.end(), differs(*usual))) > slices.size() / 2)
    usual = &*std::find_if(slices.begin(), slices.end(), differs(*usual));
  for (const DicomSlice& slice : slices)
    if (const std::string what = Difference(slice, *usual); !what.empty())
      ThrowFileError(folder, SliceName(slice) + " " + what + " " + SliceName(*usual) +
                               "; keep only slices of one scan in the folder");
}

GridGeometry SortAndMeasure(
  const std::filesystem::path& folder, std::vector<DicomSlice>& slices, double& gapDeviationMm)
{
  if (slices.size() < 2)
    ThrowFileError(folder, "the series has a single slice, a volume needs at least two");
  GridGeometry g;
  const SliceRecord& any = slices.front().record;
  const glm::dvec3 row = glm::normalize(Vector(any.orientation));
  const glm::dvec3 second = Vector(any.orientation + 3);
  const glm::dvec3 column = glm::normalize(second - glm::dot(second, row) * row);
  const glm::dvec3 normal = glm::cross(row, column);
  const auto height = [&](const DicomSlice& s)
  { return glm::dot(Vector(s.record.position), normal); };
  std::stable_sort(slices.begin(), slices.end(),
    [&](const DicomSlice& a, const DicomSlice& b) { return height(a) < height(b); });
  std::vector<double> gaps;
  for (std::size_t n = 1; n < slices.size(); ++n)
  {
    gaps.push_back(height(slices[n]) - height(slices[n - 1]));
    if (gaps.back() < 1e-3) // thinner than any slice
      ThrowFileError(folder, SliceName(slices[n - 1]) + " and " + SliceName(slices[n]) +
                               " lie at the same place; take one of them out of the folder");
  }
  std::vector<double> sorted = gaps;
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  const double usual = sorted[sorted.size() / 2];
  const auto uneven = [&](double gap)
  { return std::abs(gap - usual) > std::max(0.02, 0.01 * usual); };
  for (std::size_t n = 0; n < gaps.size(); ++n)
    if (uneven(gaps[n]))
      ThrowGap(folder, slices[n], slices[n + 1], gaps[n], usual);
  CheckTilt(folder, slices, normal);
  const double mean = (height(slices.back()) - height(slices.front())) / double(gaps.size());
  gapDeviationMm = 0.0;
  for (const double gap : gaps)
    gapDeviationMm = std::max(gapDeviationMm, std::abs(gap - mean));
  const SliceRecord& first = slices.front().record;
  g.dims = { int(first.columns), int(first.rows), int(slices.size()) };
  g.spacing = { first.spacing[1], first.spacing[0], mean };
  g.origin = Vector(first.position);
  g.direction = glm::dmat3(row, column, normal);
  return g;
}

} // namespace hasp
