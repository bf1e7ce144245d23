#include "Volumes/SampleFile.h"

#include "vtkImageData.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace hasp
{
namespace
{

const char* NameOf(StoredType type)
{
  constexpr const char* names[] = { "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64",
    "uint64", "float32", "float64" };
  return names[static_cast<int>(type)];
}

template <typename Function>
decltype(auto) WithType(StoredType type, const Function& function)
{
  switch (type)
  {
    case StoredType::Int8:
      return function(std::int8_t());
    case StoredType::UInt8:
      return function(std::uint8_t());
    case StoredType::Int16:
      return function(std::int16_t());
    case StoredType::UInt16:
      return function(std::uint16_t());
    case StoredType::Int32:
      return function(std::int32_t());
    case StoredType::UInt32:
      return function(std::uint32_t());
    case StoredType::Int64:
      return function(std::int64_t());
    case StoredType::UInt64:
      return function(std::uint64_t());
    case StoredType::Float32:
      return function(float());
    default:
      return function(double());
  }
}

/// One value as the kernels' type; false if that cannot hold it.
template <typename To, typename From>
bool Convert(From from, double slope, double intercept, To& to)
{
  const bool scaled = slope != 1.0 || intercept != 0.0;
  const double value = scaled ? double(from) * slope + intercept : double(from);
  if constexpr (std::is_same_v<To, float>)
  {
    to = static_cast<float>(value);
    // A measured number may lose digits; a whole one is a count or a label and may not.
    return scaled || std::is_floating_point_v<From> ||
           (double(to) == value && (sizeof(From) < 8 || std::abs(value) <= 1 << 24));
  }
  else
  {
    if (!(value >= std::numeric_limits<To>::min() && value <= std::numeric_limits<To>::max()))
      return false;
    to = static_cast<To>(value);
    return double(to) == value;
  }
}

constexpr std::size_t Piece = 1 << 20; ///< bytes between two reports of progress

/// nullptr if a value does not fit.
template <typename To, typename From>
vtkSmartPointer<vtkImageData> LoadAs(const SampleFile& file, const GridGeometry& geometry,
  int vtkType, const ProgressFunction& progress)
{
  SampleStream stream(file);
  auto image = NewImage(geometry, vtkType);
  auto* into = static_cast<To*>(image->GetScalarPointer());
  std::vector<From> piece(Piece / sizeof(From));
  for (std::size_t done = 0; done < geometry.Size();)
  {
    const std::size_t count = std::min(piece.size(), geometry.Size() - done);
    auto* bytes = reinterpret_cast<char*>(piece.data());
    stream.Read(bytes, count * sizeof(From));
    if (file.bigEndian)
      SwapBytes(bytes, count * sizeof(From), sizeof(From));
    for (std::size_t n = 0; n < count; ++n)
      if (!Convert(piece[n], file.slope, file.intercept, into[done + n]))
        return nullptr;
    done += count;
    ReportProgress(progress, double(done) / double(geometry.Size()));
  }
  stream.ExpectEnd();
  return image;
}

vtkSmartPointer<vtkImageData> LoadConverted(
  const SampleFile& file, const GridGeometry& geometry, const ProgressFunction& progress)
{
  return WithType(file.type,
    [&](auto from)
    {
      using From = decltype(from);
      auto image = LoadAs<std::int16_t, From>(file, geometry, VTK_SHORT, progress);
      if (!image)
        image = LoadAs<std::uint16_t, From>(file, geometry, VTK_UNSIGNED_SHORT, progress);
      if (!image)
        image = LoadAs<float, From>(file, geometry, VTK_FLOAT, progress);
      if (!image)
        ThrowFileError(file.header, std::string("holds ") + NameOf(file.type) +
                                      " samples that neither int16, uint16 nor float32 holds "
                                      "exactly; rescale them");
      return image;
    });
}

} // namespace

int DirectType(const SampleFile& file)
{
  if (file.slope != 1.0 || file.intercept != 0.0)
    return VTK_VOID;
  switch (file.type)
  {
    case StoredType::Int16:
      return VTK_SHORT;
    case StoredType::UInt16:
      return VTK_UNSIGNED_SHORT;
    case StoredType::UInt8:
      return VTK_UNSIGNED_CHAR;
    case StoredType::Float32:
      return VTK_FLOAT;
    default:
      return VTK_VOID;
  }
}

std::size_t BytesOf(StoredType type)
{
  return WithType(type, [](auto sample) { return sizeof(sample); });
}

void SwapBytes(char* data, std::size_t bytes, std::size_t sampleBytes)
{
  if (sampleBytes > 1)
    for (std::size_t n = 0; n + sampleBytes <= bytes; n += sampleBytes)
      std::reverse(data + n, data + n + sampleBytes);
}

std::filesystem::path FileBeside(
  const std::filesystem::path& header, const std::string& name, const char* key)
{
  const std::filesystem::path asked =
    std::filesystem::u8path(name.starts_with("./") ? name.substr(2) : name);
  if (name.empty() || name.find('%') != name.npos || name.find('\0') != name.npos ||
      asked.filename() != asked)
    ThrowFileError(header, std::string(key) + " must be the name of one file beside it");
  const std::filesystem::path data = header.parent_path() / asked;
  std::error_code error;
  if (!std::filesystem::is_regular_file(data, error))
    ThrowFileError(header, std::string("the file beside it that ") + key + " names is not there");
  return data;
}

void CheckSamples(SampleFile& file, const VolumeReadSettings& settings, Passport& passport)
{
  const int direct = DirectType(file);
  const std::size_t stored = BytesOf(file.type);
  // What is converted may become float32.
  const std::size_t inMemory = direct == VTK_VOID ? sizeof(float) : stored;
  CheckSampleBytes(
    file.header, file.size[0], file.size[1], file.size[2], inMemory, settings.memoryLimitBytes);
  const std::uint64_t points = std::uint64_t(file.size[0]) * file.size[1] * file.size[2];
  const std::uint64_t most = std::numeric_limits<std::int64_t>::max();
  if (file.components < 1 || std::uint64_t(file.components) > most / stored / points)
    ThrowFileError(file.header, "declares more samples than a file can hold");
  const std::uint64_t total = points * stored * std::uint64_t(file.components);

  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file.data, error);
  if (error)
    ThrowFileError(file.header, "cannot be opened");
  if (file.last && !file.zipped)
    file.offset = size > total ? size - total : 0;
  const std::uint64_t there = size > file.offset ? size - file.offset : 0;
  const std::string declares = "declares " + std::to_string(total) + " bytes of samples, ";
  if (!file.zipped && there < total)
    ThrowFileError(file.header, declares + "only " + std::to_string(there) +
                                  " are there: the file is cut off or its header wrong");
  if (!file.zipped && there > total)
    ThrowFileError(file.header, declares + std::to_string(there) +
                                  " are there, more than the header declares: its header is wrong");
  if (file.zipped && (double(total) + double(file.skip)) > 1040.0 * double(there) + 1024.0)
    // zlib cannot pack better than 1032:1
    ThrowFileError(file.header, declares + std::to_string(there) +
                                  " compressed bytes cannot hold them: the file is cut off or its "
                                  "header wrong");
  passport.sampleType = direct == VTK_VOID ? "int16, uint16 or float32" : SampleTypeName(direct);
  if (direct == VTK_VOID && (file.slope != 1.0 || file.intercept != 0.0))
    passport.warnings.push_back("Samples are rescaled by the file's slope " + Text(file.slope) +
                                " and intercept " + Text(file.intercept) + ".");
  else if (direct == VTK_VOID)
    passport.warnings.push_back(
      std::string("Samples are stored as ") + NameOf(file.type) +
      " and converted to the first of int16, uint16 and float32 that holds them all.");
}

vtkSmartPointer<vtkImageData> LoadSamples(
  const SampleFile& file, const GridGeometry& geometry, const ProgressFunction& progress)
{
  const int type = DirectType(file);
  if (type == VTK_VOID)
    return LoadConverted(file, geometry, progress);
  SampleStream stream(file);
  auto image = NewImage(geometry, type);
  auto* into = static_cast<char*>(image->GetScalarPointer());
  const std::size_t sampleBytes = BytesOf(file.type), total = geometry.Size() * sampleBytes;
  for (std::size_t done = 0; done < total;)
  {
    const std::size_t bytes = std::min<std::size_t>(total - done, 16 * Piece);
    stream.Read(into + done, bytes);
    if (file.bigEndian)
      SwapBytes(into + done, bytes, sampleBytes);
    done += bytes;
    ReportProgress(progress, double(done) / double(total));
  }
  stream.ExpectEnd();
  return image;
}

} // namespace hasp
