#include "Files/FileBytes.h"
#include "Files/FileError.h"
#include "Files/Words.h"
#include "Surfaces/PlyHeader.h"
#include "Surfaces/SurfaceFormat.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace hasp
{
namespace
{

/// The values of the body one after the other, whatever the encoding. A text has a row a line.
class PlyValues
{
public:
  PlyValues(FileBytes& bytes, PlyEncoding encoding) : Bytes(bytes), Encoding(encoding) {}

  void StartRow()
  {
    if (this->Encoding != PlyEncoding::Text)
      return;
    std::string_view line;
    do
      if (!this->Bytes.Line(line))
        ThrowFileError(this->Bytes.File(), "ends after line " +
                                             std::to_string(this->Bytes.LineNumber()) +
                                             ", before the last of the elements it declares: it is "
                                             "cut off. Copy it again");
    while (Words(line).Next().empty());
    this->Row = Words(line);
  }
  void EndRow()
  {
    if (this->Encoding == PlyEncoding::Text && !this->Row.Next().empty())
      this->Throw("has more values than its header declares");
  }
  /// Every type of PLY fits a double.
  double Value(PlyType type)
  {
    return this->Encoding == PlyEncoding::Text ? this->TextValue(type) : this->BinaryValue(type);
  }
  std::uint64_t Count(PlyType type, PlyType itemType)
  {
    const double count = this->Value(type);
    if (!(count >= 0.0))
      this->Throw("a list has the length " + Text(count) + ", it must be 0 or more");
    const std::size_t least = this->Encoding == PlyEncoding::Text ? 1 : PlyBytes(itemType);
    if (count * double(least) > double(this->Bytes.Size()))
      this->Throw("a list has the length " + Text(count) +
                  ", the file is too short for it: it is cut off or damaged. Copy it again");
    return static_cast<std::uint64_t>(count);
  }
  void SkipItems(std::uint64_t count, PlyType type)
  {
    if (this->Encoding != PlyEncoding::Text)
      this->Bytes.Skip(count * PlyBytes(type));
    else
      for (; count > 0; --count)
        this->Value(type); // throws where the line ends
  }
  Place Here() const
  {
    return this->Encoding == PlyEncoding::Text ? Place{ "line", this->Bytes.LineNumber() }
                                               : Place{ "byte", this->Bytes.Offset() };
  }
  [[noreturn]] void Throw(const std::string& what) const
  {
    ThrowAt(this->Bytes.File(), this->Here(), what);
  }

private:
  double TextValue(PlyType type)
  {
    double value = 0.0;
    if (!ToNumber(this->Row.Next(), value))
      this->Throw("a value is missing or no number");
    if (type == PlyType::Float32)
      return static_cast<float>(value);
    if (type < PlyType::Float32 && !(value == std::floor(value)))
      this->Throw("a value must be an integer and is " + Text(value));
    return value;
  }

  template <typename T>
  double As()
  {
    std::array<char, sizeof(T)> raw;
    this->Bytes.Read(raw.data(), raw.size());
    if (this->Encoding == PlyEncoding::BigEndian) // this machine is little-endian
      std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<T>(raw));
  }
  double BinaryValue(PlyType type)
  {
    switch (type)
    {
      case PlyType::Int8:
        return this->As<std::int8_t>();
      case PlyType::Uint8:
        return this->As<std::uint8_t>();
      case PlyType::Int16:
        return this->As<std::int16_t>();
      case PlyType::Uint16:
        return this->As<std::uint16_t>();
      case PlyType::Int32:
        return this->As<std::int32_t>();
      case PlyType::Uint32:
        return this->As<std::uint32_t>();
      case PlyType::Float32:
        return this->As<float>();
      default:
        return this->As<double>();
    }
  }

  FileBytes& Bytes;
  const PlyEncoding Encoding;
  Words Row{ {} };
};

class BodyReader
{
public:
  BodyReader(FileBytes& bytes, const PlyHeader& header, SurfaceBuilder& builder)
    : Bytes(bytes),
      Header(header),
      Builder(builder),
      Values(bytes, header.encoding)
  {
  }

  void Read()
  {
    std::uint64_t faces = 0;
    for (const PlyElement& element : this->Header.elements)
      if (element.kind != PlyElement::Other)
        (element.kind == PlyElement::Vertex ? this->Points : faces) = element.count;
    this->Builder.Expect(this->Points, faces);
    for (const PlyElement& element : this->Header.elements)
      if (!element.properties.empty())
        for (std::uint64_t n = 0; n < element.count; ++n)
          this->ReadRow(element);
    this->RequireEnd();
  }

private:
  void ReadRow(const PlyElement& element)
  {
    this->Values.StartRow();
    glm::dvec3 point;
    for (const PlyProperty& property : element.properties)
      if (property.role == PlyRole::Corners)
        this->ReadCorners(property);
      else if (property.list)
        this->Values.SkipItems(
          this->Values.Count(property.countType, property.type), property.type);
      else if (const double value = this->Values.Value(property.type);
               property.role != PlyRole::Other)
        point[static_cast<int>(property.role) - static_cast<int>(PlyRole::X)] = value;
    if (element.kind == PlyElement::Vertex)
      this->Builder.AddPoint(point, this->Values.Here());
    this->Values.EndRow();
  }

  void ReadCorners(const PlyProperty& property)
  {
    const std::uint64_t count = this->Values.Count(property.countType, property.type);
    this->Corners.clear(); // grows with what is there: a count in a text is not to be trusted
    for (std::uint64_t n = 0; n < count; ++n)
    {
      const double corner = this->Values.Value(property.type);
      if (!(corner >= 0.0 && corner < double(this->Points) && corner == std::floor(corner)))
        this->Values.Throw("a face names point " + Text(corner) +
                           " (counted from 0), the header declares " +
                           std::to_string(this->Points));
      this->Corners.push_back(static_cast<std::uint32_t>(corner));
    }
    this->Builder.AddFace(this->Corners, this->Values.Here());
  }

  void RequireEnd()
  {
    if (this->Header.encoding != PlyEncoding::Text)
    {
      if (this->Bytes.Left() > 0)
        this->Values.Throw(std::to_string(this->Bytes.Left()) +
                           " bytes follow the last element, too long for its header: the file is "
                           "damaged. Write it again");
      return;
    }
    if (this->Bytes.LastLineHadNoEnd())
      this->Builder.Warn("the last line has no end: the file may be cut off");
    std::string_view line;
    while (this->Bytes.Line(line))
      if (!Words(line).Next().empty())
        this->Values.Throw("stands after the last element, too long for its header: the file is "
                           "damaged. Write it again");
  }

  FileBytes& Bytes;
  const PlyHeader& Header;
  SurfaceBuilder& Builder;
  PlyValues Values;
  std::uint64_t Points = 0;
  std::vector<std::uint32_t> Corners;
};

} // namespace

LoadedSurface ReadPly(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress)
{
  FileBytes bytes(file, progress);
  SurfaceBuilder builder(file, settings);
  const PlyHeader header = ReadPlyHeader(bytes);
  BodyReader(bytes, header, builder).Read();
  static constexpr const char* encodings[] = { "text", "binary", "binary, big endian" };
  return builder.Finish("PLY", encodings[static_cast<int>(header.encoding)], header.notes);
}

} // namespace hasp
