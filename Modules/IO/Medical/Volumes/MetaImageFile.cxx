#include "Volumes/VolumeFormat.h"

#include "vtkImageData.h"
#include "vtkType.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <new>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <vector>

// MetaImage: "Key = value" lines, the last of them ElementDataFile, then the samples, here or in
// the file it names. Positions are LPS. The numbers of TransformMatrix are the directions of the
// index axes, one after the other (as ITK reads and writes them).
namespace hasp
{
namespace
{

constexpr std::size_t HeaderLimit = 1 << 16;

struct MetaImage
{
  std::filesystem::path dataFile;
  std::uint64_t dataOffset = 0; ///< of the first byte of samples
  std::size_t sampleBytes = 0;  ///< per sample
  std::size_t totalBytes = 0;
  bool compressed = false;
  bool bigEndian = false;
  int vtkType = VTK_VOID;
  GridGeometry geometry;
};

using Keys = std::map<std::string, std::string>;

std::string Trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == text.npos ? std::string()
                            : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// All keys up to ElementDataFile; leaves the stream at the first byte after that line.
Keys ReadKeys(const std::filesystem::path& file, std::istream& stream)
{
  Keys keys;
  std::string line;
  std::size_t read = 0;
  while (!keys.count("ElementDataFile"))
  {
    line.clear();
    for (int c; (c = stream.get()) != '\n';)
    {
      if (c == std::istream::traits_type::eof() || ++read > HeaderLimit)
        ThrowFileError(file, "has no ElementDataFile line: it is no MetaImage or is cut off");
      line.push_back(static_cast<char>(c));
    }
    const std::size_t equals = line.find('=');
    if (equals == line.npos)
      ThrowFileError(file, "has a header line without \"=\": it is no MetaImage");
    if (!keys.emplace(Trimmed(line.substr(0, equals)), Trimmed(line.substr(equals + 1))).second)
      ThrowFileError(file, "says " + Trimmed(line.substr(0, equals)) + " twice");
  }
  return keys;
}

/// The numbers of the first of these keys that is there; nothing if none is.
std::vector<double> Numbers(const std::filesystem::path& file, const Keys& keys,
  std::initializer_list<const char*> names, std::size_t count)
{
  for (const char* name : names)
  {
    const auto found = keys.find(name);
    if (found == keys.end())
      continue;
    std::istringstream text(found->second);
    text.imbue(std::locale::classic());
    std::vector<double> numbers;
    for (double number; text >> number;)
      numbers.push_back(number);
    if (numbers.size() != count || !text.eof() ||
        !std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); }))
      ThrowFileError(
        file, std::string(name) + " must be " + std::to_string(count) + " finite numbers");
    return numbers;
  }
  return {};
}

/// True, TRUE, t, 1 and their opposites, as MetaIO takes them. What is neither is refused: a switch
/// that is misread turns samples into others.
bool IsTrue(const std::filesystem::path& file, const Keys& keys, const char* name, bool otherwise)
{
  const auto found = keys.find(name);
  if (found == keys.end())
    return otherwise;
  const char first = found->second.empty() ? '\0' : found->second.front();
  if (!std::strchr("TtFf01", first) || first == '\0')
    ThrowFileError(file, std::string(name) + " must be True or False");
  return std::strchr("Tt1", first) != nullptr;
}

std::string Value(const Keys& keys, const char* name)
{
  const auto found = keys.find(name);
  return found == keys.end() ? std::string() : found->second;
}

void ParseType(const std::filesystem::path& file, const Keys& keys, MetaImage& meta)
{
  const std::string type = Value(keys, "ElementType");
  const std::map<std::string, std::pair<int, std::size_t>> types{ { "MET_SHORT", { VTK_SHORT, 2 } },
    { "MET_USHORT", { VTK_UNSIGNED_SHORT, 2 } }, { "MET_UCHAR", { VTK_UNSIGNED_CHAR, 1 } },
    { "MET_FLOAT", { VTK_FLOAT, 4 } } };
  const auto found = types.find(type);
  if (found == types.end())
    ThrowFileError(file, "ElementType is \"" + type +
                           "\"; MET_SHORT, MET_USHORT, MET_UCHAR and MET_FLOAT are read: cast it");
  std::tie(meta.vtkType, meta.sampleBytes) = found->second;
  if (const auto channels = Numbers(file, keys, { "ElementNumberOfChannels" }, 1);
      !channels.empty() && channels[0] != 1.0)
    ThrowFileError(file, "has " + Text(channels[0]) + " channels, must have 1");
  meta.bigEndian = IsTrue(file, keys, "BinaryDataByteOrderMSB", false) ||
                   IsTrue(file, keys, "ElementByteOrderMSB", false);
  meta.compressed = IsTrue(file, keys, "CompressedData", false);
  if (!IsTrue(file, keys, "BinaryData", true))
    ThrowFileError(file, "its samples are text; only binary samples are read");
}

void ParseGeometry(const std::filesystem::path& file, const Keys& keys,
  const VolumeReadSettings& settings, MetaImage& meta, Passport& passport)
{
  if (Value(keys, "NDims") != "3")
    ThrowFileError(file, "NDims is \"" + Value(keys, "NDims") + "\", must be 3");
  const auto dims = Numbers(file, keys, { "DimSize" }, 3);
  const auto spacing = Numbers(file, keys, { "ElementSpacing" }, 3);
  const auto origin = Numbers(file, keys, { "Offset", "Position", "Origin" }, 3);
  const auto matrix = Numbers(file, keys, { "TransformMatrix", "Rotation", "Orientation" }, 9);
  if (dims.empty() || spacing.empty())
    ThrowFileError(file, "lacks DimSize or ElementSpacing; a size or spacing is never guessed");
  for (const double n : dims)
    if (n != std::floor(n) || n < 1.0 || n > 1e9)
      ThrowFileError(file, "DimSize holds " + Text(n) + ", must be whole numbers >= 1");
  meta.totalBytes = CheckSampleBytes(file, std::int64_t(dims[0]), std::int64_t(dims[1]),
    std::int64_t(dims[2]), meta.sampleBytes, settings.memoryLimitBytes);
  GridGeometry& g = meta.geometry;
  for (int a = 0; a < 3; ++a)
  {
    g.dims[a] = static_cast<int>(dims[a]);
    g.spacing[a] = spacing[a];
    g.origin[a] = origin.empty() ? 0.0 : origin[a];
    for (int row = 0; row < 3 && !matrix.empty(); ++row)
      g.direction[a][row] = matrix[3 * a + row];
  }
  if (origin.empty())
    passport.warnings.push_back(
      "The file says no position: the first sample is put at the origin.");
  try
  {
    g.Validate();
  }
  catch (const std::invalid_argument& error)
  {
    ThrowFileError(file, error.what());
  }
}

void FindData(
  const std::filesystem::path& file, const Keys& keys, std::istream& header, MetaImage& meta)
{
  const std::string name = Value(keys, "ElementDataFile");
  const bool local = name == "LOCAL";
  if (!local && (name.empty() || name == "LIST" || name.find('%') != name.npos ||
                  std::filesystem::path(name).filename() != std::filesystem::path(name)))
    ThrowFileError(file, "ElementDataFile must be LOCAL or the name of one file beside it");
  meta.dataFile = local ? file : file.parent_path() / name;
  meta.dataOffset = local ? static_cast<std::uint64_t>(header.tellg()) : 0;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(meta.dataFile, error);
  if (error)
    ThrowFileError(file, "the file beside it that ElementDataFile names is not there");
  if (const auto skip = Numbers(file, keys, { "HeaderSize" }, 1); !skip.empty() && skip[0] != 0.0)
  {
    const bool fromEnd = skip[0] == -1.0 && !meta.compressed && size >= meta.totalBytes;
    if (!fromEnd && !(skip[0] > 0.0 && skip[0] < 1e15))
      ThrowFileError(
        file, "HeaderSize is " + Text(skip[0]) + ", must be >= 0, or -1 with raw data");
    meta.dataOffset = fromEnd ? size - meta.totalBytes : static_cast<std::uint64_t>(skip[0]);
  }
  const std::uintmax_t there = size > meta.dataOffset ? size - meta.dataOffset : 0;
  if (!meta.compressed && there < meta.totalBytes)
    ThrowFileError(file, "declares " + std::to_string(meta.totalBytes) +
                           " bytes of samples, only " + std::to_string(there) +
                           " are there: the file is cut off or its header wrong");
  if (meta.compressed && double(meta.totalBytes) > 1040.0 * double(there) + 1024.0)
    // zlib cannot pack better than 1032:1
    ThrowFileError(file, "declares " + std::to_string(meta.totalBytes) + " bytes of samples, " +
                           std::to_string(there) + " compressed bytes cannot hold them");
}

void Inflate(
  const MetaImage& meta, std::istream& stream, char* into, const ProgressFunction& progress)
{
  const auto fail = [&](const std::string& what)
  { ThrowFileError(meta.dataFile, "its compressed samples are " + what + "; copy it again"); };
  std::vector<char> packed(1 << 18);
  z_stream z{};
  if (inflateInit2(&z, 15 + 32) != Z_OK) // zlib or gzip header
    throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(
    &z, [](z_stream* s) { return inflateEnd(s); });
  std::size_t done = 0;
  for (int result = Z_OK; result != Z_STREAM_END;)
  {
    if (z.avail_in == 0)
    {
      stream.read(packed.data(), static_cast<std::streamsize>(packed.size()));
      z.next_in = reinterpret_cast<Bytef*>(packed.data());
      z.avail_in = static_cast<uInt>(stream.gcount());
      if (z.avail_in == 0)
        fail("cut off");
    }
    char beyond = 0;
    const std::size_t room = std::min<std::size_t>(meta.totalBytes - done, 1U << 24);
    z.next_out = reinterpret_cast<Bytef*>(room > 0 ? into + done : &beyond);
    z.avail_out = static_cast<uInt>(room > 0 ? room : 1);
    const uInt before = z.avail_out;
    result = inflate(&z, Z_NO_FLUSH);
    if (result != Z_OK && result != Z_STREAM_END)
      fail("damaged");
    const std::size_t made = before - z.avail_out;
    if (room == 0 && made > 0)
      fail("more than the header declares");
    done += made;
    ReportProgress(progress, double(done) / double(meta.totalBytes));
  }
  if (done != meta.totalBytes)
    fail("fewer than the header declares");
}

void SwapBytes(char* data, std::size_t bytes, std::size_t sampleBytes)
{
  for (std::size_t n = 0; n + sampleBytes <= bytes; n += sampleBytes)
    std::reverse(data + n, data + n + sampleBytes);
}

vtkSmartPointer<vtkImageData> Load(const MetaImage& meta, const ProgressFunction& progress)
{
  std::ifstream stream(meta.dataFile, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(meta.dataOffset));
  if (!stream)
    ThrowFileError(meta.dataFile, "cannot be opened");
  auto image = NewImage(meta.geometry, meta.vtkType);
  auto* into = static_cast<char*>(image->GetScalarPointer());
  if (meta.compressed)
    Inflate(meta, stream, into, progress);
  else
    for (std::size_t done = 0; done < meta.totalBytes;)
    {
      const std::size_t piece = std::min<std::size_t>(meta.totalBytes - done, 1 << 24);
      if (!stream.read(into + done, static_cast<std::streamsize>(piece)))
        ThrowFileError(meta.dataFile, "cannot be read to its end");
      done += piece;
      ReportProgress(progress, double(done) / double(meta.totalBytes));
    }
  if (meta.bigEndian)
    SwapBytes(into, meta.totalBytes, meta.sampleBytes);
  return image;
}

} // namespace

OpenedVolume OpenMetaImage(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    ThrowFileError(file, "cannot be opened");
  OpenedVolume opened;
  MetaImage meta;
  const Keys keys = ReadKeys(file, stream);
  ParseType(file, keys, meta);
  ParseGeometry(file, keys, settings, meta, opened.passport);
  FindData(file, keys, stream, meta);
  opened.passport.format = "MetaImage";
  opened.passport.geometry = meta.geometry;
  opened.passport.sampleType = SampleTypeName(meta.vtkType);
  opened.passport.compression = meta.compressed ? "zlib" : "";
  if (const std::string modality = Value(keys, "Modality"); modality.rfind("MET_MOD_", 0) == 0)
    opened.passport.modality =
      modality.substr(8) == "UNKNOWN" ? "" : SafeText(modality.substr(8, 16));
  opened.load = [meta](const ProgressFunction& progress) { return Load(meta, progress); };
  return opened;
}

} // namespace hasp
