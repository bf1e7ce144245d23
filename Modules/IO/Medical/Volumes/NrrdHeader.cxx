#include "Volumes/NrrdHeader.h"
#include "Volumes/HeaderText.h"

#include <cmath>
#include <fstream>
#include <limits>

namespace hasp
{
namespace
{

constexpr std::size_t HeaderLimit = 1 << 22; ///< a segmentation has hundreds of lines of its own

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

const std::string& Field(const NrrdHeader& header, const char* name)
{
  static const std::string none;
  const auto found = header.fields.find(name);
  return found == header.fields.end() ? none : found->second;
}

std::int64_t WholeNumber(
  const std::filesystem::path& file, const NrrdHeader& header, const char* name, std::int64_t least)
{
  const std::string& text = Field(header, name);
  if (text.empty())
    return 0;
  const auto number = FiniteNumbers(text, 1);
  if (!number || number->front() != std::floor(number->front()) ||
      number->front() < double(least) || number->front() > 1e15)
    ThrowFileError(
      file, std::string(name) + " must be a whole number from " + std::to_string(least) + " on");
  return static_cast<std::int64_t>(number->front());
}

std::vector<std::string> Words(const std::string& text)
{
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t", at)) != text.npos;)
  {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

/// "(1,0,0) none (0,1,0)" as one entry an axis. Blanks may stand anywhere.
std::vector<std::optional<glm::dvec3>> Vectors(
  const std::filesystem::path& file, const std::string& text, const char* name)
{
  std::vector<std::optional<glm::dvec3>> vectors;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t", at)) != text.npos;)
  {
    if (LowerCase(text.substr(at, 4)) == "none")
    {
      vectors.emplace_back();
      at += 4;
      continue;
    }
    const std::size_t end = text.find(')', at);
    std::string inside =
      text[at] == '(' && end != text.npos ? text.substr(at + 1, end - at - 1) : "";
    for (char& c : inside)
      c = c == ',' ? ' ' : c;
    const auto numbers = FiniteNumbers(inside, 3);
    if (!numbers)
      ThrowFileError(file, std::string(name) + " must be vectors of 3 finite numbers, as (1,0,0)");
    vectors.emplace_back(glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]));
    at = end + 1;
  }
  return vectors;
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

/// Signs that turn the file's axes into L, P and S.
glm::dvec3 SpaceSigns(
  const std::filesystem::path& file, const std::string& space, Passport& passport)
{
  const std::string name = LowerCase(space);
  if (name == "left-posterior-superior" || name == "lps")
    return { 1, 1, 1 };
  if (name == "right-anterior-superior" || name == "ras")
    return { -1, -1, 1 };
  if (name == "left-anterior-superior" || name == "las")
    return { 1, -1, 1 };
  if (name == "3d-left-handed")
    ThrowFileError(file, "space is left-handed and does not say how it lies in the patient: left "
                         "and right would be a guess. Save it with space left-posterior-superior");
  if (!name.empty() && name != "3d-right-handed" && name != "scanner-xyz")
    ThrowFileError(file, "space is none that is read: left-posterior-superior, "
                         "right-anterior-superior or left-anterior-superior");
  passport.warnings.push_back(
    "The file does not say how its space lies in the patient; it is taken "
    "as left-posterior-superior. Check left and right.");
  return { 1, 1, 1 };
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
      if (++header.bytes > HeaderLimit)
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

std::vector<NrrdAxis> NrrdAxes(const std::filesystem::path& file, const NrrdHeader& header)
{
  const std::int64_t dimension = WholeNumber(file, header, "dimension", 1);
  if (dimension != 3 && dimension != 4)
    ThrowFileError(
      file, "dimension is " + std::to_string(dimension) + ", must be 3, or 4 with one component");
  std::vector<NrrdAxis> axes(static_cast<std::size_t>(dimension));
  const auto sizes = FiniteNumbers(Field(header, "sizes"), axes.size());
  if (!sizes)
    ThrowFileError(file, "sizes must be one whole number for each dimension");
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    const double size = (*sizes)[a];
    if (size != std::floor(size) || size < 1.0 || size > 1e15)
      ThrowFileError(file, "sizes hold " + Text(size) + ", must be whole numbers >= 1");
    axes[a].size = static_cast<std::int64_t>(size);
  }
  if (const auto kinds = Words(LowerCase(Field(header, "kinds"))); kinds.size() == axes.size())
    for (std::size_t a = 0; a < axes.size(); ++a)
      axes[a].kind = kinds[a];
  else if (!kinds.empty())
    ThrowFileError(file, "kinds must be one word for each dimension");
  if (const auto steps = Vectors(file, Field(header, "space directions"), "space directions");
      steps.size() == axes.size())
    for (std::size_t a = 0; a < axes.size(); ++a)
      axes[a].step = steps[a];
  else if (!steps.empty())
    ThrowFileError(file, "space directions must be one vector for each dimension");
  return axes;
}

SampleFile NrrdSamples(const std::filesystem::path& file, const NrrdHeader& header)
{
  SampleFile samples;
  samples.header = samples.data = file;
  samples.type = TypeOf(file, Field(header, "type"));
  const std::string encoding = LowerCase(Field(header, "encoding"));
  samples.zipped = encoding == "gzip" || encoding == "gz";
  if (!samples.zipped && encoding != "raw")
    ThrowFileError(file, "encoding must be raw or gzip; text, hex and bzip2 are not read. Save it "
                         "again with gzip");
  const std::string endian = LowerCase(Field(header, "endian"));
  if (endian != "little" && endian != "big" && !(endian.empty() && BytesOf(samples.type) == 1))
    ThrowFileError(file, "endian must be little or big: without it samples are a guess");
  samples.bigEndian = endian == "big";
  if (const std::string& name = Field(header, "data file"); !name.empty())
    samples.data = FileBeside(file, name == "LIST" ? "" : name, "data file");
  else if (LowerExtension(file) == ".nhdr")
    ThrowFileError(file, "has no data file line that says where its samples are");
  else
    samples.offset = header.bytes;
  samples.offset = LinesEnd(samples, WholeNumber(file, header, "line skip", 0));
  const std::int64_t skip = WholeNumber(file, header, "byte skip", -1);
  if (skip == -1 && samples.zipped)
    ThrowFileError(file, "byte skip is -1, which only raw samples may have");
  samples.last = skip == -1;
  if (skip > 0)
    (samples.zipped ? samples.skip : samples.offset) += static_cast<std::uint64_t>(skip);
  return samples;
}

void SetNrrdGeometry(const std::filesystem::path& file, const NrrdHeader& header,
  const std::vector<NrrdAxis>& spatial, Passport& passport)
{
  GridGeometry& g = passport.geometry;
  for (const std::string& unit : Words(Field(header, "space units")))
    if (unit != "\"mm\"" && unit != "\"\"")
      ThrowFileError(file, "space units must be mm; save it in millimetres");
  glm::dmat3 steps(1.0);
  const bool directed = spatial[0].step && spatial[1].step && spatial[2].step;
  if (!directed)
  {
    // Without directions only distances are known.
    const auto words = Words(Field(header, "spacings"));
    std::string spacings;
    for (const std::string& word : words)
      if (words.size() == 3 || LowerCase(word) != "nan") // the fourth axis has none
        spacings += word + " ";
    const auto numbers = FiniteNumbers(spacings, 3);
    if (!numbers)
      ThrowFileError(file, "lacks space directions or three spacings; a spacing is never guessed");
    for (int a = 0; a < 3; ++a)
    {
      steps[a][a] = (*numbers)[a];
      if (!(steps[a][a] > 0.0)) // two of them would else be a half turn
        ThrowFileError(file, "spacings must be > 0");
    }
  }
  for (int a = 0; a < 3; ++a)
  {
    g.dims[a] = static_cast<int>(spatial[a].size);
    steps[a] = directed ? *spatial[a].step : steps[a];
  }
  const glm::dvec3 signs = SpaceSigns(file, Field(header, "space"), passport);
  const auto origin = Vectors(file, Field(header, "space origin"), "space origin");
  if (origin.size() > 1 || (origin.size() == 1 && !origin[0]))
    ThrowFileError(file, "space origin must be one vector");
  if (origin.empty())
    passport.warnings.push_back(
      "The file says no position: the first sample is put at the origin.");
  for (int a = 0; a < 3; ++a)
    steps[a] *= signs;
  g.origin = origin.empty() ? glm::dvec3(0.0) : *origin[0] * signs;
  SetIndexSteps(file, steps, g);
}

} // namespace hasp
