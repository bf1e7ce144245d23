#include "Files/FileBytes.h"
#include "Files/FileError.h"
#include "Files/Words.h"
#include "Surfaces/SurfaceFormat.h"

#include <algorithm>
#include <limits>

namespace hasp
{
namespace
{

/// What says nothing about where a surface lies.
constexpr std::string_view Ignored[] = { "vt", "vn", "vp", "p", "l", "g", "o", "s", "mg", "usemtl",
  "mtllib", "usemap", "maplib", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj" };

class ObjReader
{
public:
  ObjReader(FileBytes& bytes, SurfaceBuilder& builder) : Bytes(bytes), Builder(builder) {}

  LoadedSurface Read()
  {
    std::string_view line;
    while (this->WholeLine(line))
    {
      this->Take(line);
      this->FirstLine = this->Bytes.LineNumber() + 1;
    }
    if (this->Bytes.LastLineHadNoEnd())
      this->Builder.Warn("the last line has no end: the file may be cut off");
    return this->Builder.Finish("OBJ", "text", this->Notes);
  }

private:
  Place Here() const { return { "line", this->FirstLine }; }
  [[noreturn]] void Throw(const std::string& what) const
  {
    ThrowAt(this->Bytes.File(), this->Here(), what);
  }

  /// A line that ends in a backslash goes on in the next.
  bool WholeLine(std::string_view& line)
  {
    if (!this->Bytes.Line(line))
      return false;
    if (!line.ends_with('\\'))
      return true;
    this->Joined.clear();
    for (;;)
    {
      const bool more = line.ends_with('\\');
      this->Joined.append(line.substr(0, line.size() - more)).push_back(' ');
      if (this->Joined.size() > FileBytes::Piece)
        this->Throw("goes on for more than 1048576 bytes; this is no text of a surface");
      if (!more || !this->Bytes.Line(line))
        break;
    }
    line = this->Joined;
    return true;
  }

  void Take(std::string_view line)
  {
    Words words(line);
    const std::string_view first = words.Next();
    if (first == "v")
      this->TakePoint(words);
    else if (first == "f")
      this->TakeFace(words);
    else if (first.starts_with('#'))
      this->Notes.Look(line);
    else if (!first.empty() &&
             std::find(std::begin(Ignored), std::end(Ignored), first) == std::end(Ignored))
      this->Throw("begins with no word of an OBJ surface (v, f, a comment …): the file is damaged, "
                  "or holds free-form curves. Export it as a mesh");
  }

  /// After x, y and z come a weight or colours, or nothing.
  void TakePoint(Words& words)
  {
    glm::dvec3 point;
    for (int a = 0; a < 3; ++a)
      if (!ToNumber(words.Next(), point[a]))
        this->Throw("number " + std::to_string(a + 1) + " of 3 is missing or no number");
    this->Builder.AddPoint(point, this->Here());
  }

  /// "7", "7/1", "7//2", "7/1/2": the point alone counts. From 1; below 0 from the last one back.
  std::uint32_t Corner(std::string_view word) const
  {
    std::int64_t number = 0;
    const std::size_t slash = std::min(word.find('/'), word.size());
    bool good = ToInteger(word.substr(0, slash), number) && number != 0;
    for (std::string_view rest = word.substr(slash); !rest.empty();)
    {
      rest.remove_prefix(1);
      const std::size_t next = std::min(rest.find('/'), rest.size());
      std::int64_t other = 1;
      good = good && (next == 0 || ToInteger(rest.substr(0, next), other)) && other != 0;
      rest.remove_prefix(next);
    }
    if (!good || std::count(word.begin(), word.end(), '/') > 2)
      this->Throw("a corner of a face is no index");
    const std::int64_t points = static_cast<std::int64_t>(this->Builder.PointCount());
    const std::int64_t from0 = number > 0 ? number - 1 : points + number;
    if (number < -points || from0 >= std::numeric_limits<std::int32_t>::max())
      this->Throw("a face names point " + std::to_string(number) + ", there are " +
                  std::to_string(points) + " up to here");
    return static_cast<std::uint32_t>(from0);
  }

  void TakeFace(Words& words)
  {
    this->Corners.clear();
    for (std::string_view word = words.Next(); !word.empty(); word = words.Next())
    {
      if (word.starts_with('#'))
        break;
      this->Corners.push_back(this->Corner(word));
    }
    this->Builder.AddFace(this->Corners, this->Here());
  }

  FileBytes& Bytes;
  SurfaceBuilder& Builder;
  SurfaceNotes Notes;
  std::uint64_t FirstLine = 1;
  std::string Joined;
  std::vector<std::uint32_t> Corners;
};

} // namespace

LoadedSurface ReadObj(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress)
{
  FileBytes bytes(file, progress);
  SurfaceBuilder builder(file, settings);
  return ObjReader(bytes, builder).Read();
}

} // namespace hasp
