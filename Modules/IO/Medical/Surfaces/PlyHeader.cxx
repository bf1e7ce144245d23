#include "Surfaces/PlyHeader.h"
#include "Files/FileBytes.h"
#include "Files/FileError.h"
#include "Files/Words.h"

#include <algorithm>
#include <array>

namespace hasp
{
namespace
{

constexpr std::size_t MostLines = 4096, MostProperties = 256;

class HeaderReader
{
public:
  explicit HeaderReader(FileBytes& bytes) : Bytes(bytes) {}

  PlyHeader Read()
  {
    std::string_view line;
    if (!this->Bytes.Line(line) || line != "ply")
      ThrowFileError(this->Bytes.File(), "does not begin with the line \"ply\"; it is no PLY file");
    for (;;)
    {
      if (!this->Bytes.Line(line) || this->Bytes.LineNumber() > MostLines)
        ThrowFileError(
          this->Bytes.File(), "has no end_header: it is cut off or no PLY. Copy it again");
      Words words(line);
      const std::string_view first = words.Next();
      if (first == "end_header" && words.Next().empty())
        break;
      this->Take(first, words, line);
    }
    this->CheckElements();
    return std::move(this->Header);
  }

private:
  [[noreturn]] void Throw(const std::string& what) const
  {
    ThrowAt(this->Bytes.File(), { "line", this->Bytes.LineNumber() }, what);
  }

  void Take(std::string_view first, Words& words, std::string_view line)
  {
    if (first == "comment" || first == "obj_info")
      this->Header.notes.Look(line);
    else if (first == "format")
      this->TakeFormat(words);
    else if (first == "element")
      this->TakeElement(words);
    else if (first == "property")
      this->TakeProperty(words);
    else if (!first.empty())
      this->Throw("begins with no word of a PLY header; the file is damaged. Copy it again");
  }

  void TakeFormat(Words& words)
  {
    const std::string_view name = words.Next(), version = words.Next();
    if (this->Formats++ > 0 || version != "1.0")
      this->Throw("there must be one format line, of version 1.0");
    if (name == "ascii")
      this->Header.encoding = PlyEncoding::Text;
    else if (name == "binary_little_endian")
      this->Header.encoding = PlyEncoding::LittleEndian;
    else if (name == "binary_big_endian")
      this->Header.encoding = PlyEncoding::BigEndian;
    else
      this->Throw("the format is none of ascii, binary_little_endian and binary_big_endian");
  }

  void TakeElement(Words& words)
  {
    const std::string_view name = words.Next();
    std::int64_t count = 0;
    if (!ToInteger(words.Next(), count) || count < 0)
      this->Throw("the count of an element must be a number from 0 to 9223372036854775807");
    this->Header.elements.push_back({ name == "vertex" ? PlyElement::Vertex
                                      : name == "face" ? PlyElement::Face
                                                       : PlyElement::Other,
      static_cast<std::uint64_t>(count), {} });
  }

  PlyType Type(std::string_view word) const
  {
    static constexpr std::array<std::array<std::string_view, 2>, 8> names{ { { "char", "int8" },
      { "uchar", "uint8" }, { "short", "int16" }, { "ushort", "uint16" }, { "int", "int32" },
      { "uint", "uint32" }, { "float", "float32" }, { "double", "float64" } } };
    for (std::size_t n = 0; n < names.size(); ++n)
      if (word == names[n][0] || word == names[n][1])
        return static_cast<PlyType>(n);
    this->Throw("a property is of none of PLY's types");
  }

  void TakeProperty(Words& words)
  {
    if (this->Header.elements.empty())
      this->Throw("a property stands before the first element");
    PlyElement& element = this->Header.elements.back();
    std::string_view word = words.Next();
    PlyProperty property{ PlyRole::Other, {}, word == "list", {} };
    if (property.list)
    {
      property.countType = this->Type(words.Next());
      if (property.countType >= PlyType::Float32)
        this->Throw("the count of a list must be an integer");
      word = words.Next();
    }
    property.type = this->Type(word);
    const std::string_view name = words.Next();
    if (element.kind == PlyElement::Vertex && !property.list && name.size() == 1 &&
        name[0] >= 'x' && name[0] <= 'z')
      property.role = static_cast<PlyRole>(int(PlyRole::X) + name[0] - 'x');
    if (element.kind == PlyElement::Face && property.list &&
        (name == "vertex_indices" || name == "vertex_index"))
      property.role = PlyRole::Corners;
    for (const PlyProperty& other : element.properties)
      if (property.role != PlyRole::Other && other.role == property.role)
        this->Throw("a property is declared twice");
    if (element.properties.size() == MostProperties)
      this->Throw("an element has more than 256 properties");
    element.properties.push_back(property);
  }

  std::size_t Count(PlyElement::Kind kind) const
  {
    return std::count_if(this->Header.elements.begin(), this->Header.elements.end(),
      [&](const PlyElement& element) { return element.kind == kind; });
  }

  void CheckElements() const
  {
    const std::filesystem::path& file = this->Bytes.File();
    if (this->Formats == 0)
      ThrowFileError(file, "its header names no format; the file is damaged. Copy it again");
    if (this->Count(PlyElement::Vertex) != 1 || this->Count(PlyElement::Face) != 1)
      ThrowFileError(
        file, "must have one vertex and one face element; export it as a triangle mesh");
    for (const PlyElement& element : this->Header.elements)
    {
      std::size_t roles = 0, least = 0;
      for (const PlyProperty& property : element.properties)
      {
        roles += property.role != PlyRole::Other;
        least += this->Header.encoding == PlyEncoding::Text ? 2 // a digit and what ends it
                 : property.list                            ? PlyBytes(property.countType)
                                                            : PlyBytes(property.type);
      }
      if (element.kind == PlyElement::Vertex && roles != 3)
        ThrowFileError(file, "its points have no x, y or z; export it as a triangle mesh");
      if (element.kind == PlyElement::Face && roles != 1)
        ThrowFileError(file, "its faces have no vertex_indices; export it as a triangle mesh");
      // The last line of a text may lack its end.
      if (least > 0 && element.count > (this->Bytes.Left() + 1) / least)
        ThrowFileError(
          file, "declares " + std::to_string(element.count) + " elements of at least " +
                  std::to_string(least) + " bytes, " + std::to_string(this->Bytes.Left()) +
                  " bytes follow its header: too short. It is cut off or damaged; copy "
                  "it again");
    }
  }

  FileBytes& Bytes;
  PlyHeader Header;
  int Formats = 0;
};

} // namespace

std::size_t PlyBytes(PlyType type)
{
  static constexpr std::size_t bytes[] = { 1, 1, 2, 2, 4, 4, 4, 8 };
  return bytes[static_cast<int>(type)];
}

PlyHeader ReadPlyHeader(FileBytes& bytes)
{
  return HeaderReader(bytes).Read();
}

} // namespace hasp
