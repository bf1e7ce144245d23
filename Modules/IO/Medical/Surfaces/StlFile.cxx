#include "Files/FileBytes.h"
#include "Files/FileError.h"
#include "Files/Words.h"
#include "Surfaces/SurfaceFormat.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace hasp
{
namespace
{

constexpr std::size_t HeaderBytes = 80, StartBytes = 84, TriangleBytes = 50;

/// Binary files may begin with "solid", too. Text has no zero bytes; a binary file has one in its
/// count or its first triangle.
bool IsText(FileBytes& bytes)
{
  std::string_view start = bytes.Peek(512);
  if (start.starts_with("\xEF\xBB\xBF"))
    start.remove_prefix(3);
  const std::string_view text =
    start.substr(std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  return IsWord(Words(text.substr(0, text.find('\n'))).Next(), "solid") &&
         start.find('\0') == start.npos;
}

LoadedSurface ReadBinary(FileBytes& bytes, SurfaceBuilder& builder)
{
  std::array<char, StartBytes> start;
  bytes.Read(start.data(), start.size());
  SurfaceNotes notes;
  notes.Look({ start.data(), HeaderBytes });
  std::uint32_t count = 0;
  std::memcpy(&count, start.data() + HeaderBytes, sizeof(count)); // the machine is little-endian
  const std::uint64_t needed = StartBytes + std::uint64_t(TriangleBytes) * count;
  if (needed != bytes.Size())
    ThrowFileError(bytes.File(), "declares " + std::to_string(count) + " triangles, which take " +
                                   std::to_string(needed) + " bytes, the file has " +
                                   std::to_string(bytes.Size()) +
                                   (needed > bytes.Size() ? ", too short" : ", too long") +
                                   ": it is cut off, damaged or no STL. Copy it again");
  builder.Expect(0, count);
  for (std::uint32_t n = 1; n <= count; ++n)
  {
    std::array<char, TriangleBytes> triangle;
    bytes.Read(triangle.data(), triangle.size());
    std::array<float, 9> corners; // after the normal, which is for the corners to say
    std::memcpy(corners.data(), triangle.data() + 3 * sizeof(float), sizeof(corners));
    std::array<std::uint32_t, 3> points;
    for (std::size_t c = 0; c < 3; ++c)
      points[c] =
        builder.Weld({ corners[3 * c], corners[3 * c + 1], corners[3 * c + 2] }, { "triangle", n });
    builder.AddFace(points, { "triangle", n });
  }
  return builder.Finish("STL", "binary", notes);
}

/// Holds the lines to the order solid, facet, outer loop, three vertices, endloop, endfacet,
/// endsolid.
class TextReader
{
public:
  TextReader(FileBytes& bytes, SurfaceBuilder& builder) : Bytes(bytes), Builder(builder) {}

  LoadedSurface Read()
  {
    std::string_view line;
    while (this->Bytes.Line(line))
    {
      Words words(line);
      if (const std::string_view first = words.Next(); !first.empty())
        this->Take(first, words, line);
    }
    if (this->Inside != State::Nothing)
      ThrowFileError(this->Bytes.File(), "ends at line " +
                                           std::to_string(this->Bytes.LineNumber()) +
                                           " without its endsolid: it is cut off. Copy it again");
    return this->Builder.Finish("STL", "text", this->Notes);
  }

private:
  enum class State
  {
    Nothing,
    Solid,
    Facet,
    Loop,
    Looped
  };

  Place Here() const { return { "line", this->Bytes.LineNumber() }; }
  [[noreturn]] void Throw(const char* expected) const
  {
    ThrowAt(this->Bytes.File(), this->Here(),
      std::string("is not what STL has here (") + expected +
        "): the file is damaged or no STL. Copy it again");
  }
  void Step(State from, State to, const char* expected)
  {
    if (this->Inside != from)
      this->Throw(expected);
    this->Inside = to;
  }

  void Take(std::string_view first, Words& words, std::string_view line)
  {
    static constexpr const char* expected[] = { "solid", "facet or endsolid", "outer loop",
      "vertex or endloop", "endfacet" };
    const char* const here = expected[static_cast<int>(this->Inside)];
    if (IsWord(first, "vertex"))
      this->TakeVertex(words, here);
    else if (IsWord(first, "facet"))
      this->Step(State::Solid, State::Facet, here); // its normal is for the corners to say
    else if (IsWord(first, "outer") && IsWord(words.Next(), "loop"))
    {
      this->Step(State::Facet, State::Loop, here);
      this->Corners = 0;
    }
    else if (IsWord(first, "endloop"))
    {
      this->Step(State::Loop, State::Looped, here);
      if (this->Corners != 3)
        ThrowAt(this->Bytes.File(), this->Here(),
          "a facet has " + std::to_string(this->Corners) + " corners, STL has 3");
      this->Builder.AddFace(this->Points, this->Here());
    }
    else if (IsWord(first, "endfacet"))
      this->Step(State::Looped, State::Solid, here);
    else if (IsWord(first, "solid"))
    {
      this->Step(State::Nothing, State::Solid, here);
      this->Notes.Look(line);
    }
    else if (IsWord(first, "endsolid"))
      this->Step(State::Solid, State::Nothing, here);
    else
      this->Throw(here);
  }

  void TakeVertex(Words& words, const char* expected)
  {
    this->Step(State::Loop, State::Loop, expected);
    glm::dvec3 point;
    for (int a = 0; a < 3; ++a)
      if (!ToNumber(words.Next(), point[a]))
        ThrowAt(this->Bytes.File(), this->Here(),
          "number " + std::to_string(a + 1) + " of 3 is missing or no number");
    if (!words.Next().empty())
      ThrowAt(this->Bytes.File(), this->Here(), "has more than three numbers");
    if (this->Corners < 3)
      this->Points[this->Corners] = this->Builder.Weld(point, this->Here());
    ++this->Corners;
  }

  FileBytes& Bytes;
  SurfaceBuilder& Builder;
  SurfaceNotes Notes;
  State Inside = State::Nothing;
  std::array<std::uint32_t, 3> Points{};
  std::size_t Corners = 0;
};

} // namespace

LoadedSurface ReadStl(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress)
{
  FileBytes bytes(file, progress);
  SurfaceBuilder builder(file, settings);
  return IsText(bytes) ? TextReader(bytes, builder).Read() : ReadBinary(bytes, builder);
}

} // namespace hasp
