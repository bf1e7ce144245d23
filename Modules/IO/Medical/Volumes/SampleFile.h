#pragma once
#include "Volumes/VolumeFormat.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

/// Samples in a file: raw or zipped, at an offset, of any number type and byte order. What the
/// header says is held against the file's size and the memory limit before memory is taken.
namespace hasp
{

enum class StoredType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

struct SampleFile
{
  std::filesystem::path header; ///< named in errors
  std::filesystem::path data;   ///< the same file, or one beside it
  std::uint64_t offset = 0;     ///< of the first byte in the file
  bool last = false;            ///< instead: the last bytes of the file; raw only
  std::uint64_t skip = 0;       ///< bytes to leave out after unzipping
  bool zipped = false;          ///< zlib or gzip
  bool bigEndian = false;
  StoredType type = StoredType::Int16;
  std::int64_t size[3] = {};   ///< as the header says, x fastest
  std::int64_t components = 1; ///< samples at each point, next to each other
  double slope = 1.0, intercept = 0.0;
};

std::size_t BytesOf(StoredType type);

/// VTK's type where kernels read the samples as they are stored; VTK_VOID where they are to be
/// converted.
int DirectType(const SampleFile& file);

/// The whole path of a file beside the header, by a name out of it. Throws unless the name is that
/// of one regular file in the same folder ("./" may stand before it); `key` is our word for where
/// the name stood.
std::filesystem::path FileBeside(
  const std::filesystem::path& header, const std::string& name, const char* key);

/// Throws ThrowFileError unless sizes are in [1, INT_MAX], the image fits the limit, and the file
/// holds exactly as many raw bytes, or zipped ones that can hold as many. Sets an offset from the
/// end. What the passport then says of type and conversion is put there.
void CheckSamples(SampleFile& file, const VolumeReadSettings& settings, Passport& passport);

/// short, unsigned short, unsigned char and float as they are. Of other types, or with slope and
/// intercept: short if every value is whole and fits, else unsigned short, else float. Throws if
/// samples are missing or left over, and for whole numbers that float32 does not hold.
vtkSmartPointer<vtkImageData> LoadSamples(
  const SampleFile& file, const GridGeometry& geometry, const ProgressFunction& progress);

/// The bytes of samples, unzipped, in pieces, as they stand in the file.
class SampleStream
{
public:
  explicit SampleStream(const SampleFile& file);
  ~SampleStream();
  SampleStream(const SampleStream&) = delete;
  SampleStream& operator=(const SampleStream&) = delete;

  /// The next `size` bytes. Throws if the file ends or is damaged before.
  void Read(char* into, std::size_t size);
  /// Throws if a zipped file holds more.
  void ExpectEnd();

private:
  std::size_t Unzip(char* into, std::size_t size);
  [[noreturn]] void Fail(const std::string& what) const;

  struct Unzipper;
  SampleFile File;
  std::ifstream Stream;
  std::unique_ptr<Unzipper> Zip; ///< absent: raw
};

/// Turns big-endian samples into the machine's order, in place.
void SwapBytes(char* data, std::size_t bytes, std::size_t sampleBytes);

} // namespace hasp
