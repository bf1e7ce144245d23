#include "Dicom/DicomChecks.h"
#include "Dicom/DicomTerms.h"
#include "Volumes/VolumeFormat.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

namespace hasp
{
namespace
{

const char* const ExportAgain = "; export the series again from its source";

/// What is wrong with a slice. Slices with the same `kind` and `key` make one fault.
struct Wrong
{
  FaultKind kind;
  std::string key;
  std::string what;   ///< a sentence without its subject, the slice
  std::string remedy; ///< the end of the sentence
};
using Found = std::optional<Wrong>;

bool Finite(const double* numbers, int count)
{
  return std::all_of(numbers, numbers + count, [](double n) { return std::isfinite(n); });
}

Found WrongFormat(const DicomSlice& slice)
{
  const SliceRecord& r = slice.record;
  const auto unsupported = [](const std::string& key, const std::string& what,
                             const std::string& remedy) {
    return Wrong{ FaultKind::Unsupported, key, what, remedy };
  };
  if (r.status == static_cast<std::uint32_t>(SliceStatus::Undecodable))
    return unsupported("compression",
      "is compressed as \"" + std::string(r.transferSyntax) + "\", for which there is no decoder",
      "; " + std::string(RemedyFor(r.transferSyntax)));
  if (r.frames != 1)
    return unsupported("frames", "holds " + std::to_string(r.frames) + " frames",
      "; export the series as one file per slice (\"classic\", not \"enhanced\")");
  if (r.samplesPerPixel != 1 || !(r.flags & (Monochrome1 | Monochrome2)))
    return unsupported("colour", "is a colour picture", "; choose a series of a scan");
  if ((r.bitsAllocated != 8 && r.bitsAllocated != 16) || r.bitsStored < 1 ||
      r.bitsStored > r.bitsAllocated || r.highBit >= r.bitsAllocated ||
      r.highBit + 1 < r.bitsStored || r.isSigned > 1)
    return unsupported("bits",
      "has " + std::to_string(r.bitsStored) + " bits stored in " + std::to_string(r.bitsAllocated),
      "; 8 and 16 are read");
  const std::uint64_t pixelBytes = std::uint64_t(r.rows) * r.columns * (r.bitsAllocated / 8);
  if (!(r.flags & Packed) && pixelBytes > slice.fileBytes)
    return Wrong{ FaultKind::Damaged, "short",
      "declares " + std::to_string(r.columns) + " x " + std::to_string(r.rows) + " pixels, " +
        std::to_string(pixelBytes) + " bytes; the file has only " +
        std::to_string(slice.fileBytes) + ": it is cut off",
      ". Copy it again" };
  return {};
}

Found WrongGeometry(const DicomSlice& slice)
{
  const SliceRecord& r = slice.record;
  const auto wrong = [](const std::string& key, const std::string& what = {}) {
    return Wrong{ FaultKind::NoGeometry, key, what.empty() ? key : what, ExportAgain };
  };
  if (!(r.flags & HasSpacing))
    return wrong("says no pixel spacing (0028,0030), and none is guessed");
  if (!Finite(r.spacing, 2) || !(r.spacing[0] > 0.0 && r.spacing[1] > 0.0))
    return wrong("spacing", "has a pixel spacing of " + Text(r.spacing[0]) + " x " +
                              Text(r.spacing[1]) + " mm, must be > 0");
  if (!(r.flags & HasPosition))
    return wrong("says no position (0020,0032)");
  if (!Finite(r.position, 3))
    return wrong("has a position (0020,0032) that is no finite number");
  if (!(r.flags & HasOrientation) || !Finite(r.orientation, 6))
    return wrong("says no usable orientation (0020,0037)");
  const glm::dvec3 row = Vector(r.orientation), column = Vector(r.orientation + 3);
  // Direction cosines are written with six decimals or so: 1e-3 forgives that and no real shear.
  if (std::abs(glm::length(row) - 1.0) > 1e-3 || std::abs(glm::length(column) - 1.0) > 1e-3 ||
      std::abs(glm::dot(row, column)) > 1e-3)
    return wrong("has an orientation (0020,0037) that is not two unit vectors at right angles");
  return {};
}

Found WrongRescale(const DicomSlice& slice)
{
  const SliceRecord& r = slice.record;
  if (std::isfinite(r.slope) && std::isfinite(r.intercept) && r.slope != 0.0)
    return {};
  return Wrong{ FaultKind::BadRescale, "rescale",
    "rescales by " + Text(r.slope) + " x + " + Text(r.intercept) +
      "; the slope must not be 0 and both must be finite",
    ExportAgain };
}

/// How a slice differs from another in what all of a series must share.
Found Difference(const DicomSlice& slice, const DicomSlice& reference)
{
  const SliceRecord &a = reference.record, &b = slice.record;
  const std::string asIn = " as " + SliceName(reference);
  const char* const remedy = "; keep only slices of one scan in the folder";
  if (a.rows != b.rows || a.columns != b.columns)
    return Wrong{ FaultKind::MixedSizes, "pixels",
      "has " + std::to_string(b.columns) + " x " + std::to_string(b.rows) + " pixels, not " +
        std::to_string(a.columns) + " x " + std::to_string(a.rows) + asIn,
      remedy };
  // A hundredth of a percent over 512 pixels is a twentieth of a pixel.
  for (int n = 0; n < 2; ++n)
    if (std::abs(a.spacing[n] - b.spacing[n]) > 1e-4 * a.spacing[n])
      return Wrong{ FaultKind::MixedSizes, "spacing",
        "has a pixel spacing of " + Millimetres(b.spacing[n]) + ", not " +
          Millimetres(a.spacing[n]) + asIn,
        remedy };
  for (int n = 0; n < 6; ++n)
    if (std::abs(a.orientation[n] - b.orientation[n]) > 1e-3)
      return Wrong{ FaultKind::MixedOrientations, "turned",
        "is turned against " + SliceName(reference), remedy };
  if (std::strcmp(a.frame, b.frame) != 0)
    return Wrong{ FaultKind::MixedFrames, "frame",
      "has another frame of reference than " + SliceName(reference), remedy };
  return {};
}

/// Gathers slices with the same wrong; the first gives the sentence.
class Gathering
{
public:
  void Add(const DicomSlice& slice, const Found& found)
  {
    if (!found)
      return;
    auto [at, isNew] = this->Places.try_emplace({ found->kind, found->key }, this->Groups.size());
    if (isNew)
      this->Groups.push_back({ *found, SliceName(slice), {} });
    this->Groups[at->second].files.push_back(slice.number);
  }

  void Into(std::vector<ImportFault>& faults)
  {
    for (Group& group : this->Groups)
    {
      const std::size_t more = group.files.size() - 1;
      const std::string others = more == 0 ? "" : " (and so " + std::to_string(more) + " more)";
      faults.emplace_back(
        group.wrong.kind, group.first + " " + group.wrong.what + others + group.wrong.remedy);
      faults.back().files = std::move(group.files);
    }
  }

private:
  struct Group
  {
    Wrong wrong;
    std::string first;
    std::vector<int> files;
  };
  std::map<std::pair<FaultKind, std::string>, std::size_t> Places;
  std::vector<Group> Groups; ///< in the order they were found
};

} // namespace

glm::dvec3 Vector(const double* numbers)
{
  return { numbers[0], numbers[1], numbers[2] };
}

std::string Millimetres(double value)
{
  return Text(std::round(value * 1e4) / 1e4) + " mm";
}

bool HasGeometry(const DicomSlice& slice)
{
  return !WrongGeometry(slice);
}

void CheckEach(const std::vector<DicomSlice>& slices, std::vector<ImportFault>& faults)
{
  for (const auto check : { WrongFormat, WrongGeometry, WrongRescale })
  {
    Gathering gathering;
    for (const DicomSlice& slice : slices)
      if (slice.record.rows > 0 || check == WrongFormat) // no rows: its header could not be read
        gathering.Add(slice, check(slice));
    gathering.Into(faults);
  }
}

void CheckAlike(const std::vector<DicomSlice>& all, std::vector<ImportFault>& faults)
{
  std::vector<const DicomSlice*> slices;
  for (const DicomSlice& slice : all)
    if (HasGeometry(slice))
      slices.push_back(&slice);
  if (slices.empty())
    return;
  // The odd one is to be named: if most differ from the first slice, the first is the odd one.
  const auto differs = [](const DicomSlice& reference)
  { return [&](const DicomSlice* slice) { return Difference(*slice, reference).has_value(); }; };
  const DicomSlice* usual = slices.front();
  if (std::size_t(std::count_if(slices.begin(), slices.end(), differs(*usual))) > slices.size() / 2)
    usual = *std::find_if(slices.begin(), slices.end(), differs(*usual));
  Gathering gathering;
  for (const DicomSlice* slice : slices)
    gathering.Add(*slice, Difference(*slice, *usual));
  gathering.Into(faults);
}

} // namespace hasp
