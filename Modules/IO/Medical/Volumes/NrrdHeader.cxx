#include "Volumes/NrrdHeader.h"
#include "Files/Words.h"

#include <cmath>
#include <fstream>

namespace hasp
{
namespace
{

/// Fields that may be spelt in two ways, by the way they are kept.
std::string FieldName(std::string_view text)
{
  const std::string name = LowerCase(Trimmed(text));
  static const std::map<std::string, std::string> others{ { "byteskip", "byte skip" },
    { "lineskip", "line skip" }, { "datafile", "data file" }, { "centers", "centerings" } };
  const auto found = others.find(name);
  return found == others.end() ? name : found->second;
}

/// "\n" and "\\" of a key or a value.
std::string Unescaped(std::string_view text)
{
  std::string plain;
  for (std::size_t n = 0; n < text.size(); ++n)
  {
    const bool escape = text[n] == '\\' && n + 1 < text.size();
    if (escape)
      ++n;
    plain.push_back(escape && text[n] == 'n' ? '\n' : text[n]);
  }
  return plain;
}

void TakeLine(const std::filesystem::path& file, std::string_view line, NrrdHeader& header)
{
  if (line.front() == '#')
    return;
  const std::size_t colon = line.find(':');
  if (colon == line.npos)
    ThrowFileError(file, "has a header line without \":\": it is no NRRD file or is damaged");
  const bool pair = colon + 1 < line.size() && line[colon + 1] == '=';
  if (!pair && colon + 1 < line.size() && line[colon + 1] != ' ')
    ThrowFileError(file, "has a header line without a blank after \":\"; it is damaged");
  const bool first =
    pair ? header.pairs.emplace(Unescaped(line.substr(0, colon)), Unescaped(line.substr(colon + 2)))
             .second
         : header.fields.emplace(FieldName(line.substr(0, colon)), Trimmed(line.substr(colon + 1)))
             .second;
  if (!first)
    ThrowFileError(file, "says one field twice");
}

/// All names of the specification.
StoredType TypeOf(const std::filesystem::path& file, const std::string& name)
{
  static const std::map<std::string, StoredType> types{ { "signed char", StoredType::Int8 },
    { "int8", StoredType::Int8 }, { "int8_t", StoredType::Int8 }, { "uchar", StoredType::UInt8 },
    { "unsigned char", StoredType::UInt8 }, { "uint8", StoredType::UInt8 },
    { "uint8_t", StoredType::UInt8 }, { "short", StoredType::Int16 },
    { "short int", StoredType::Int16 }, { "signed short", StoredType::Int16 },
    { "signed short int", StoredType::Int16 }, { "int16", StoredType::Int16 },
    { "int16_t", StoredType::Int16 }, { "ushort", StoredType::UInt16 },
    { "unsigned short", StoredType::UInt16 }, { "unsigned short int", StoredType::UInt16 },
    { "uint16", StoredType::UInt16 }, { "uint16_t", StoredType::UInt16 },
    { "int", StoredType::Int32 }, { "signed int", StoredType::Int32 },
    { "int32", StoredType::Int32 }, { "int32_t", StoredType::Int32 },
    { "uint", StoredType::UInt32 }, { "unsigned int", StoredType::UInt32 },
    { "uint32", StoredType::UInt32 }, { "uint32_t", StoredType::UInt32 },
    { "longlong", StoredType::Int64 }, { "long long", StoredType::Int64 },
    { "long long int", StoredType::Int64 }, { "signed long long", StoredType::Int64 },
    { "signed long long int", StoredType::Int64 }, { "int64", StoredType::Int64 },
    { "int64_t", StoredType::Int64 }, { "ulonglong", StoredType::UInt64 },
    { "unsigned long long", StoredType::UInt64 }, { "unsigned long long int", StoredType::UInt64 },
    { "uint64", StoredType::UInt64 }, { "uint64_t", StoredType::UInt64 },
    { "float", StoredType::Float32 }, { "double", StoredType::Float64 } };
  const auto found = types.find(LowerCase(name));
  if (found == types.end())
    ThrowFileError(file, "type is none that is read: a whole number of 8 to 64 bits, float or "
                         "double; convert it to one");
  return found->second;
}

/// Bytes of the first `lines` lines.
std::uint64_t LinesEnd(const SampleFile& samples, std::int64_t lines)
{
  std::ifstream stream(samples.data, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(samples.offset));
  std::uint64_t at = samples.offset;
  std::vector<char> piece(1 << 16);
  while (lines > 0)
  {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const std::streamsize there = stream.gcount();
    if (there == 0)
      ThrowFileError(samples.header, "has fewer lines than line skip says");
    std::streamsize n = 0;
    while (n < there && lines > 0)
      lines -= piece[n++] == '\n';
    at += static_cast<std::uint64_t>(n);
  }
  return at;
}

} // namespace

NrrdHeader ReadNrrdHeader(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    ThrowFileError(file, "cannot be opened");
  NrrdHeader header;
  std::string line;
  for (bool first = true;; first = false)
  {
    line.clear();
    int c = stream.get();
    for (; c != '\n' && c != std::istream::traits_type::eof(); c = stream.get())
    {
      if (++header.bytes > NrrdHeaderLimit)
        ThrowFileError(file, "has no blank line at the end of its header: it is no NRRD file");
      line.push_back(static_cast<char>(c));
    }
    ++header.bytes; // the line's end
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    if (first &&
        (line.size() != 8 || line.compare(0, 7, "NRRD000") != 0 || line[7] < '1' || line[7] > '5'))
      ThrowFileError(file, "does not begin with NRRD0001 to NRRD0005: it is no NRRD file");
    if (!first && !line.empty())
      TakeLine(file, line, header);
    if (line.empty() || c == std::istream::traits_type::eof())
      return header;
  }
}

const std::string& NrrdHeader::Field(const char* name) const
{
  static const std::string none;
  const auto found = this->fields.find(name);
  return found == this->fields.end() ? none : found->second;
}

std::int64_t NrrdHeader::WholeNumber(
  const std::filesystem::path& file, const char* name, std::int64_t least) const
{
  const std::string& text = this->Field(name);
  if (text.empty())
    return 0;
  const auto number = FiniteNumbers(text, 1);
  if (!number || number->front() != std::floor(number->front()) ||
      number->front() < double(least) || number->front() > 1e15)
    ThrowFileError(
      file, std::string(name) + " must be a whole number from " + std::to_string(least) + " on");
  return static_cast<std::int64_t>(number->front());
}

SampleFile NrrdSamples(const std::filesystem::path& file, const NrrdHeader& header)
{
  SampleFile samples;
  samples.header = samples.data = file;
  samples.type = TypeOf(file, header.Field("type"));
  const std::string encoding = LowerCase(header.Field("encoding"));
  samples.zipped = encoding == "gzip" || encoding == "gz";
  if (!samples.zipped && encoding != "raw")
    ThrowFileError(file, "encoding must be raw or gzip; text, hex and bzip2 are not read. Save it "
                         "again with gzip");
  const std::string endian = LowerCase(header.Field("endian"));
  if (endian != "little" && endian != "big" && !(endian.empty() && BytesOf(samples.type) == 1))
    ThrowFileError(file, "endian must be little or big: without it samples are a guess");
  samples.bigEndian = endian == "big";
  if (const std::string& name = header.Field("data file"); !name.empty())
    samples.data = FileBeside(file, name == "LIST" ? "" : name, "data file");
  else if (LowerExtension(file) == ".nhdr")
    ThrowFileError(file, "has no data file line that says where its samples are");
  else
    samples.offset = header.bytes;
  samples.offset = LinesEnd(samples, header.WholeNumber(file, "line skip", 0));
  const std::int64_t skip = header.WholeNumber(file, "byte skip", -1);
  if (skip == -1 && samples.zipped)
    ThrowFileError(file, "byte skip is -1, which only raw samples may have");
  samples.last = skip == -1;
  if (skip > 0)
    (samples.zipped ? samples.skip : samples.offset) += static_cast<std::uint64_t>(skip);
  return samples;
}

} // namespace hasp
