#include "Files/Words.h"
#include "Volumes/SampleFile.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <vector>

// MetaImage: "Key = value" lines, the last of them ElementDataFile, then the samples, here or in
// the file it names. Positions are LPS. The numbers of TransformMatrix are the directions of the
// index axes, one after the other (as ITK reads and writes them).
namespace hasp
{
namespace
{

constexpr std::size_t HeaderLimit = 1 << 16;

using Keys = std::map<std::string, std::string>;

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
      ThrowFileError(file, "says the same key twice");
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
    const auto numbers = FiniteNumbers(found->second, count);
    if (!numbers)
      ThrowFileError(
        file, std::string(name) + " must be " + std::to_string(count) + " finite numbers");
    return *numbers;
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

void ParseType(const std::filesystem::path& file, const Keys& keys, SampleFile& samples)
{
  const std::map<std::string, StoredType> types{ { "MET_CHAR", StoredType::Int8 },
    { "MET_UCHAR", StoredType::UInt8 }, { "MET_SHORT", StoredType::Int16 },
    { "MET_USHORT", StoredType::UInt16 }, { "MET_INT", StoredType::Int32 },
    { "MET_UINT", StoredType::UInt32 }, { "MET_LONG_LONG", StoredType::Int64 },
    { "MET_ULONG_LONG", StoredType::UInt64 }, { "MET_FLOAT", StoredType::Float32 },
    { "MET_DOUBLE", StoredType::Float64 } };
  const auto found = types.find(Value(keys, "ElementType"));
  if (found == types.end())
    ThrowFileError(file, "ElementType is none that is read: MET_SHORT, MET_USHORT, MET_UCHAR, "
                         "MET_FLOAT, MET_CHAR, MET_INT, MET_UINT, MET_DOUBLE; cast it to one");
  samples.type = found->second;
  if (const auto channels = Numbers(file, keys, { "ElementNumberOfChannels" }, 1);
      !channels.empty() && channels[0] != 1.0)
    ThrowFileError(file, "has " + Text(channels[0]) + " channels, must have 1");
  samples.bigEndian = IsTrue(file, keys, "BinaryDataByteOrderMSB", false) ||
                      IsTrue(file, keys, "ElementByteOrderMSB", false);
  samples.zipped = IsTrue(file, keys, "CompressedData", false);
  if (!IsTrue(file, keys, "BinaryData", true))
    ThrowFileError(file, "its samples are text; only binary samples are read");
}

void ParseGeometry(
  const std::filesystem::path& file, const Keys& keys, SampleFile& samples, Passport& passport)
{
  if (Value(keys, "NDims") != "3")
    ThrowFileError(file, "NDims must be 3");
  const auto dims = Numbers(file, keys, { "DimSize" }, 3);
  const auto spacing = Numbers(file, keys, { "ElementSpacing" }, 3);
  const auto origin = Numbers(file, keys, { "Offset", "Position", "Origin" }, 3);
  const auto matrix = Numbers(file, keys, { "TransformMatrix", "Rotation", "Orientation" }, 9);
  if (dims.empty() || spacing.empty())
    ThrowFileError(file, "lacks DimSize or ElementSpacing; a size or spacing is never guessed");
  GridGeometry& g = passport.geometry;
  for (int a = 0; a < 3; ++a)
  {
    if (dims[a] != std::floor(dims[a]) || dims[a] < 1.0 || dims[a] > 1e9)
      ThrowFileError(file, "DimSize holds " + Text(dims[a]) + ", must be whole numbers >= 1");
    g.dims[a] = static_cast<int>(dims[a]);
    samples.size[a] = g.dims[a];
    g.spacing[a] = spacing[a];
    g.origin[a] = origin.empty() ? 0.0 : origin[a];
    for (int row = 0; row < 3 && !matrix.empty(); ++row)
      g.direction[a][row] = matrix[3 * a + row];
  }
  if (origin.empty())
    passport.warnings.push_back(
      "The file says no position: the first sample is put at the origin.");
}

void FindData(
  const std::filesystem::path& file, const Keys& keys, std::istream& header, SampleFile& samples)
{
  const std::string name = Value(keys, "ElementDataFile");
  const bool local = name == "LOCAL";
  if (name == "LIST")
    ThrowFileError(file, "ElementDataFile must be LOCAL or the name of one file beside it");
  samples.header = file;
  samples.data = local ? file : FileBeside(file, name, "ElementDataFile");
  samples.offset = local ? static_cast<std::uint64_t>(header.tellg()) : 0;
  const auto skip = Numbers(file, keys, { "HeaderSize" }, 1);
  if (skip.empty() || skip[0] == 0.0)
    return;
  samples.last = skip[0] == -1.0 && !samples.zipped;
  if (!samples.last && !(skip[0] > 0.0 && skip[0] < 1e15))
    ThrowFileError(file, "HeaderSize is " + Text(skip[0]) + ", must be >= 0, or -1 with raw data");
  if (!samples.last)
    samples.offset = static_cast<std::uint64_t>(skip[0]);
}

/// MetaIO's names of modalities.
std::string ModalityOf(const std::string& text)
{
  return text.rfind("MET_MOD_", 0) == 0 ? KnownModality(text.substr(8)) : "";
}

} // namespace

OpenedVolume OpenMetaImage(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    ThrowFileError(file, "cannot be opened");
  OpenedVolume opened;
  SampleFile samples;
  const Keys keys = ReadKeys(file, stream);
  ParseType(file, keys, samples);
  ParseGeometry(file, keys, samples, opened.passport);
  FindData(file, keys, stream, samples);
  CheckSamples(samples, settings, opened.passport);
  try
  {
    opened.passport.geometry.Validate();
  }
  catch (const std::invalid_argument& error)
  {
    ThrowFileError(file, error.what());
  }
  opened.passport.format = "MetaImage";
  opened.passport.compression = samples.zipped ? "zlib" : "";
  opened.passport.modality = ModalityOf(Value(keys, "Modality"));
  opened.samples = std::make_shared<const SampleFile>(samples);
  opened.load = [samples, geometry = opened.passport.geometry](const ProgressFunction& progress,
                  Passport&) { return LoadSamples(samples, geometry, progress); };
  return opened;
}

} // namespace hasp
