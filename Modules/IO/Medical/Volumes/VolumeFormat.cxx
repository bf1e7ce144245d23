#include "Volumes/VolumeFormat.h"

#include "vtkImageData.h"
#include "vtkType.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace hasp
{

std::string SafeText(const std::string& text)
{
  std::string safe = text;
  std::replace_if(
    safe.begin(), safe.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return safe;
}

std::string KnownModality(std::string_view text)
{
  for (const char* known : { "CT", "MR", "PT", "NM", "US", "CR", "DX", "XA", "OT" })
    if (text == known)
      return known;
  return {};
}

std::string TooManySamples(std::int64_t x, std::int64_t y, std::int64_t z,
  std::size_t bytesPerSample, std::size_t limitBytes)
{
  const std::string size =
    std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z) + " samples";
  for (const std::int64_t n : { x, y, z })
    if (n < 1 || n > std::numeric_limits<int>::max())
      return "declares " + size + "; each number must be in [1, 2147483647]";
  // In double precision first: the exact product may not fit 64 bits.
  const double bytes = double(x) * double(y) * double(z) * double(bytesPerSample);
  if (bytes > double(limitBytes))
    return "declares " + size + ", " + Text(bytes / (1 << 20)) + " MiB; the memory limit is " +
           Text(double(limitBytes) / (1 << 20)) +
           " MiB. Crop or resample the scan, or raise the limit";
  return {};
}

std::size_t CheckSampleBytes(const std::filesystem::path& file, std::int64_t x, std::int64_t y,
  std::int64_t z, std::size_t bytesPerSample, std::size_t limitBytes)
{
  Passport known;
  if (const std::string text = TooManySamples(x, y, z, bytesPerSample, limitBytes); !text.empty())
  {
    known.faults.emplace_back(FaultKind::TooLarge, text);
    throw ImportError(file, std::move(known));
  }
  return std::size_t(x) * std::size_t(y) * std::size_t(z) * bytesPerSample;
}

vtkSmartPointer<vtkImageData> NewImage(const GridGeometry& geometry, int vtkType)
{
  geometry.Validate();
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(&geometry.dims.x);
  image->SetOrigin(geometry.origin.x, geometry.origin.y, geometry.origin.z);
  image->SetSpacing(geometry.spacing.x, geometry.spacing.y, geometry.spacing.z);
  const glm::dmat3& d = geometry.direction; // column-major
  image->SetDirectionMatrix(
    d[0][0], d[1][0], d[2][0], d[0][1], d[1][1], d[2][1], d[0][2], d[1][2], d[2][2]);
  image->AllocateScalars(vtkType, 1);
  return image;
}

std::string SampleTypeName(int vtkType)
{
  switch (vtkType)
  {
    case VTK_SHORT:
      return "int16";
    case VTK_UNSIGNED_SHORT:
      return "uint16";
    case VTK_UNSIGNED_CHAR:
      return "uint8";
    case VTK_FLOAT:
      return "float32";
    default:
      return {};
  }
}

} // namespace hasp
