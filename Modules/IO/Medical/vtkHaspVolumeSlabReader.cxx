#include "vtkHaspVolumeSlabReader.h"
#include "Files/FileError.h"
#include "Volumes/SampleFile.h"
#include "vtkHaspVolumeFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

constexpr std::size_t MostBytes = std::size_t(1) << 46; ///< of a volume: products fit 64 bits

/// Formats whose samples may lie in one stream, slice after slice.
bool MayStream(const std::string& path)
{
  const std::string ending = LowerExtension(std::filesystem::u8path(path));
  const std::string endings[] = { ".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz" };
  return std::find(std::begin(endings), std::end(endings), ending) != std::end(endings);
}

bool Streams(const OpenedVolume& opened)
{
  return opened.samples && opened.samples->components == 1 &&
         DirectType(*opened.samples) != VTK_VOID;
}

OpenedVolume Open(
  const std::string& path, VolumeReadSettings settings, const ProgressFunction& progress)
{
  settings.hash = false;
  if (MayStream(path))
  {
    VolumeReadSettings unlimited = settings;
    unlimited.memoryLimitBytes = MostBytes; // the limit is for slabs, then
    OpenedVolume opened = OpenVolume(path, unlimited, progress);
    if (Streams(opened))
      return opened;
  }
  return OpenVolume(path, settings, progress);
}

template <typename T>
AnyGridView ViewBytes(const std::vector<char>& bytes, const GridGeometry& geometry)
{
  return GridView<const T>{ reinterpret_cast<const T*>(bytes.data()), geometry };
}

} // namespace

struct VolumeSlabReader::Internals
{
  OpenedVolume opened;
  LoadedVolume loaded;                  ///< or
  std::unique_ptr<SampleStream> stream; ///< the slices from `next` on
  std::vector<char> buffer;             ///< and here those before
  int firstHeld = 0, next = 0;
  bool broken = false; ///< reading has failed: the stream stands nobody knows where
  std::size_t sliceBytes = 0, limitBytes = 0;

  /// Slices up to `end` into the buffer, behind those that it has from `first` on.
  void Fill(int first, int end)
  {
    const std::size_t kept = (this->next - first) * this->sliceBytes;
    std::copy_n(this->buffer.data() + (first - this->firstHeld) * this->sliceBytes, kept,
      this->buffer.data());
    this->firstHeld = first;
    if (end <= this->next)
      return;
    const std::size_t whole = (end - first) * this->sliceBytes;
    if (this->buffer.size() < whole)
      this->Resize(whole, kept);
    const SampleFile& file = *this->opened.samples;
    this->broken = true; // unless what follows ends well
    this->stream->Read(this->buffer.data() + kept, whole - kept);
    if (file.bigEndian)
      SwapBytes(this->buffer.data() + kept, whole - kept, hasp::BytesOf(file.type));
    if (file.type == StoredType::Float32)
      this->RequireFinite(kept, whole);
    this->next = end;
    if (end == this->opened.passport.geometry.dims.z)
      this->stream->ExpectEnd();
    this->broken = false;
  }

  /// To just so many bytes: the slab is what a cap was set for.
  void Resize(std::size_t bytes, std::size_t kept)
  {
    if (bytes > this->limitBytes)
      ThrowFileError(std::filesystem::u8path(this->opened.file),
        "slices of " + std::to_string(bytes) + " bytes are asked for, the limit is " +
          std::to_string(this->limitBytes) + "; raise it or crop the scan");
    if (kept == 0)
      this->buffer = {};
    std::vector<char> larger(bytes);
    std::copy_n(this->buffer.data(), kept, larger.data());
    this->buffer.swap(larger);
  }

  void RequireFinite(std::size_t from, std::size_t to) const
  {
    const auto* samples = reinterpret_cast<const float*>(this->buffer.data());
    const auto bad = std::find_if(samples + from / sizeof(float), samples + to / sizeof(float),
      [](float sample) { return !std::isfinite(sample); });
    if (bad == samples + to / sizeof(float))
      return;
    const std::size_t row = this->opened.passport.geometry.dims.x;
    const std::size_t n = bad - samples, inSlice = n % (this->sliceBytes / sizeof(float));
    ThrowFileError(std::filesystem::u8path(this->opened.file),
      "holds samples that are NaN or infinite, the first at index (" +
        std::to_string(inSlice % row) + ", " + std::to_string(inSlice / row) + ", " +
        std::to_string(this->firstHeld + n / (this->sliceBytes / sizeof(float))) +
        "); replace them by numbers before opening it");
  }

  AnyGridView View(int first, int count) const
  {
    GridGeometry geometry = this->opened.passport.geometry;
    geometry.origin = geometry.IndexToWorld({ 0, 0, first });
    geometry.dims.z = count;
    switch (this->opened.samples->type)
    {
      case StoredType::Int16:
        return ViewBytes<std::int16_t>(this->buffer, geometry);
      case StoredType::UInt16:
        return ViewBytes<std::uint16_t>(this->buffer, geometry);
      case StoredType::UInt8:
        return ViewBytes<std::uint8_t>(this->buffer, geometry);
      default:
        return ViewBytes<float>(this->buffer, geometry);
    }
  }
};

VolumeSlabReader::VolumeSlabReader(
  const std::string& path, const VolumeReadSettings& settings, const ProgressFunction& progress)
  : Inside(std::make_unique<Internals>())
{
  Internals& in = *this->Inside;
  in.opened = Open(path, settings, progress);
  if (!hasp::Streams(in.opened))
  {
    in.loaded = LoadVolume(in.opened, progress);
    return;
  }
  const glm::ivec3& dims = in.opened.passport.geometry.dims;
  in.sliceBytes = std::size_t(dims.x) * dims.y * hasp::BytesOf(in.opened.samples->type);
  in.limitBytes = settings.memoryLimitBytes;
  in.stream = std::make_unique<SampleStream>(*in.opened.samples);
}

VolumeSlabReader::~VolumeSlabReader() = default;

const Passport& VolumeSlabReader::GetPassport() const
{
  return this->Streams() ? this->Inside->opened.passport : this->Inside->loaded.passport;
}

bool VolumeSlabReader::Streams() const
{
  return this->Inside->stream != nullptr;
}

std::size_t VolumeSlabReader::BytesHeld() const
{
  const Internals& in = *this->Inside;
  if (this->Streams())
    return in.buffer.size();
  const AnyGridView grid = ViewImage(in.loaded.image);
  return std::visit(
    [](const auto& view) { return view.geometry.Size() * sizeof(*view.data); }, grid);
}

AnyGridView VolumeSlabReader::Read(int first, int count)
{
  Internals& in = *this->Inside;
  const int depth = this->GetPassport().geometry.dims.z;
  if (first < 0 || count < 1 || first > depth - count)
    throw std::invalid_argument("slices " + std::to_string(first) + " to " +
                                std::to_string(std::int64_t(first) + count - 1) +
                                " are asked for, there are " + std::to_string(depth));
  if (!this->Streams())
    return std::visit(
      [&](auto view) -> AnyGridView
      {
        view.data += view.Offset(0, 0, first);
        view.geometry.origin = view.geometry.IndexToWorld({ 0, 0, first });
        view.geometry.dims.z = count;
        return view;
      },
      ViewImage(in.loaded.image));
  if (first < in.firstHeld || first > in.next)
    throw std::invalid_argument("slices are read forward: slice " + std::to_string(first) +
                                " is asked for, must be from " + std::to_string(in.firstHeld) +
                                " to " + std::to_string(in.next));
  if (in.broken)
    ThrowFileError(
      std::filesystem::u8path(in.opened.file), "could not be read before; open it again");
  in.Fill(first, first + count);
  return in.View(first, count);
}

} // namespace hasp
