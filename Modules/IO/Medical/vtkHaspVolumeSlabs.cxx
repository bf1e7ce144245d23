#include "vtkHaspVolumeSlabs.h"
#include "Files/AtomicFile.h"
#include "Files/FileError.h"
#include "Volumes/EncodeHeader.h"
#include "Volumes/GzipOutput.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

VolumeHeader HeaderFor(
  const std::filesystem::path& file, const GridGeometry& geometry, SampleType type, bool compress)
{
  const std::string extension = LowerExtension(file);
  if (extension == ".nrrd")
    return EncodeNrrd(geometry, type, compress);
  if (extension == ".nii.gz")
    return EncodeNifti(geometry, type);
  if (compress && (extension == ".mha" || extension == ".nii"))
    ThrowFileError(
      file, "is written raw; for a compressed volume give the name the ending .nrrd or .nii.gz");
  if (extension == ".mha")
    return EncodeMetaImage(geometry, type);
  if (extension == ".nii")
    return EncodeNifti(geometry, type);
  ThrowFileError(file, "volumes are written as .mha, .nrrd, .nii, .nii.gz or .vti (.vti: not in "
                       "slabs); give the name one of these endings");
}

/// Before the first byte: a disk that fills up after minutes of writing is no answer.
void CheckRoom(const std::filesystem::path& file, std::uint64_t bytes)
{
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::error_code error;
  const auto room = std::filesystem::space(folder, error);
  if (!error && room.available < bytes) // with an error the folder is not there: AtomicFile says so
    ThrowFileError(file, "needs " + Text(double(bytes) / (1 << 20)) + " MiB, the disk has " +
                           Text(double(room.available) / (1 << 20)) +
                           " MiB left; free some or write to another disk");
}

template <typename T>
constexpr SampleType TypeOf()
{
  if constexpr (std::is_same_v<T, std::int16_t>)
    return SampleType::Int16;
  else if constexpr (std::is_same_v<T, std::uint16_t>)
    return SampleType::UInt16;
  else if constexpr (std::is_same_v<T, std::uint8_t>)
    return SampleType::UInt8;
  else
    return SampleType::Float32;
}

} // namespace

struct VolumeSlabWriter::Internals
{
  std::filesystem::path file;
  GridGeometry geometry;
  SampleType type = SampleType::Int16;
  VolumeHeader header;
  int slicesLeft = 0;
  std::unique_ptr<AtomicFile> output; ///< gone after Commit and after a failed write
  std::unique_ptr<GzipOutput> gzip;
  std::vector<char> turned; ///< one slice

  void Write(const void* bytes, std::size_t size)
  {
    if (this->gzip)
      this->gzip->Write(bytes, size);
    else
      this->output->Write(bytes, size);
  }

  template <typename T>
  void Append(std::span<const T> samples)
  {
    const std::size_t inSlice = std::size_t(this->geometry.dims.x) * this->geometry.dims.y;
    const std::size_t slices = samples.size() / inSlice;
    if (!this->output)
      throw std::invalid_argument("the volume is written or has failed; nothing can be appended");
    if (TypeOf<T>() != this->type)
      throw std::invalid_argument("samples are not of the type the volume was begun with");
    if (samples.size() % inSlice != 0 || slices > std::size_t(this->slicesLeft))
      throw std::invalid_argument(std::to_string(samples.size()) + " samples appended, must be " +
                                  std::to_string(inSlice) + " for each of at most " +
                                  std::to_string(this->slicesLeft) + " slices");
    try
    {
      if (this->header.flipX || this->header.flipY)
        for (std::size_t k = 0; k < slices; ++k)
          this->WriteTurned(samples.data() + k * inSlice);
      else
        this->Write(samples.data(), samples.size_bytes());
    }
    catch (...)
    {
      this->gzip.reset();
      this->output.reset();
      throw;
    }
    this->slicesLeft -= static_cast<int>(slices);
  }

  template <typename T>
  void WriteTurned(const T* slice)
  {
    const std::size_t columns = this->geometry.dims.x, rows = this->geometry.dims.y;
    this->turned.resize(columns * rows * sizeof(T));
    T* to = reinterpret_cast<T*>(this->turned.data());
    for (std::size_t j = 0; j < rows; ++j, to += columns)
    {
      const T* row = slice + (this->header.flipY ? rows - 1 - j : j) * columns;
      if (this->header.flipX)
        std::reverse_copy(row, row + columns, to);
      else
        std::copy(row, row + columns, to);
    }
    this->Write(this->turned.data(), this->turned.size());
  }
};

VolumeSlabWriter::VolumeSlabWriter(
  const std::string& path, const GridGeometry& geometry, SampleType type, bool compress)
  : Inside(std::make_unique<Internals>())
{
  Internals& in = *this->Inside;
  geometry.Validate();
  in.file = std::filesystem::u8path(path);
  in.geometry = geometry;
  in.type = type;
  in.header = HeaderFor(in.file, geometry, type, compress);
  in.slicesLeft = geometry.dims.z;
  const bool zipped = compress || LowerExtension(in.file) == ".nii.gz";
  if (!zipped)
    CheckRoom(in.file, in.header.bytes.size() + geometry.Size() * BytesOf(type));
  in.output = std::make_unique<AtomicFile>(in.file);
  const bool headerZipped = zipped && !compress;
  if (!headerZipped)
    in.output->Write(in.header.bytes.data(), in.header.bytes.size());
  if (zipped)
    in.gzip = std::make_unique<GzipOutput>(*in.output);
  if (headerZipped)
    in.Write(in.header.bytes.data(), in.header.bytes.size());
}

VolumeSlabWriter::~VolumeSlabWriter() = default;

void VolumeSlabWriter::Append(std::span<const std::int16_t> samples)
{
  this->Inside->Append(samples);
}

void VolumeSlabWriter::Append(std::span<const std::uint16_t> samples)
{
  this->Inside->Append(samples);
}

void VolumeSlabWriter::Append(std::span<const std::uint8_t> samples)
{
  this->Inside->Append(samples);
}

void VolumeSlabWriter::Append(std::span<const float> samples)
{
  this->Inside->Append(samples);
}

int VolumeSlabWriter::SlicesLeft() const
{
  return this->Inside->slicesLeft;
}

void VolumeSlabWriter::Commit()
{
  Internals& in = *this->Inside;
  if (!in.output)
    throw std::invalid_argument("the volume is written already or has failed");
  if (in.slicesLeft > 0)
    throw std::invalid_argument(
      std::to_string(in.slicesLeft) + " slices are missing; append them before Commit");
  const auto output = std::move(in.output); // whatever fails, there is no second try
  if (const auto gzip = std::move(in.gzip))
    gzip->Finish();
  output->Commit();
}

} // namespace hasp
