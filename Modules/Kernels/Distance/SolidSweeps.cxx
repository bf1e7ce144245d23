#include "Distance/SolidSweeps.h"

#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"
#include "RibbonDepth.h"
#include "SolidChecks.h"

#include <array>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace hasp
{

namespace
{
/// Strokes of a letter, apart by spaces: digits x y, x from 0 to 4, y from 0 (below) to 6.
struct Letter
{
  char name;
  const char* strokes;
};

constexpr std::array<Letter, 42> Alphabet{ {
  { 'A', "0004264440 0343" },
  { 'B', "00063645443303 3342413000" },
  { 'C', "4536160501103041" },
  { 'D', "00062644422000" },
  { 'E', "46060040 0333" },
  { 'F', "460600 0333" },
  { 'G', "45361605011030414323" },
  { 'H', "0006 4046 0343" },
  { 'I', "1030 2026 1636" },
  { 'J', "4641301001" },
  { 'K', "0006 460340" },
  { 'L', "060040" },
  { 'M', "0006234640" },
  { 'N', "00064046" },
  { 'O', "100105163645413010" },
  { 'P', "00063645443303" },
  { 'Q', "100105163645413010 2240" },
  { 'R', "00063645443303 2340" },
  { 'S', "453616050413334241301001" },
  { 'T', "0646 2026" },
  { 'U', "060110304146" },
  { 'V', "062046" },
  { 'W', "0610233046" },
  { 'X', "0046 0640" },
  { 'Y', "062346 2320" },
  { 'Z', "06460040" },
  { '0', "100105163645413010 0145" },
  { '1', "152620 1030" },
  { '2', "05163645440040" },
  { '3', "0516364544334241301001 2333" },
  { '4', "30360242" },
  { '5', "460604344341301001" },
  { '6', "4536160501103041423303" },
  { '7', "064610" },
  { '8', "13040516364544331302011030414233" },
  { '9', "0110304145361605041343" },
  { '.', "20" },
  { '-', "1333" },
  { '/', "0046" },
  { '+', "0343 2125" },
  { ':', "21 24" },
  { ' ', "" },
} };
constexpr double LetterHeight = 6.0, LetterWidth = 4.0, LetterPlace = 6.0; // of the digits' grid

const char* StrokesOf(char name, std::size_t place)
{
  for (const Letter& letter : Alphabet)
    if (letter.name == name)
      return letter.strokes;
  throw std::invalid_argument(
    "text: character " + std::to_string(place + 1) +
    " has no letter; capitals A to Z, 0 to 9, space and . - / + : have one");
}

/// The capsules of a line; of one point, a ball.
void AddCapsules(
  std::vector<SolidPointer>& parts, std::span<const glm::dvec3> line, bool closed, double radius)
{
  const std::size_t pieces = closed || line.size() == 1 ? line.size() : line.size() - 1;
  for (std::size_t n = 0; n < pieces; ++n)
    parts.push_back(MakeCapsule(line[n], line[(n + 1) % line.size()], radius));
}

/// A place of a line as messages tell it: " 3 at (1, 2.5, 0) mm".
std::string PlaceName(std::size_t place, const glm::dvec3& at)
{
  std::ostringstream text;
  text << " " << place << " at (" << at.x << ", " << at.y << ", " << at.z << ") mm";
  return text.str();
}

void RequireFiniteLine(const char* shape, std::span<const glm::dvec3> line)
{
  for (std::size_t n = 0; n < line.size(); ++n)
    RequireFinite(shape, ("place" + PlaceName(n, line[n])).c_str(), line[n]);
}

/// The surface's unit normal at a place of a path that must be on it.
glm::dvec3 NormalOn(const ImplicitSolid& surface, const glm::dvec3& at, double most,
  const char* what, std::size_t place)
{
  const ImplicitSolid::Sample s = surface.SampleAt(at);
  const std::string where = std::string("ribbon: ") + what + PlaceName(place, at);
  if (!(std::abs(s.value) <= most))
    throw std::invalid_argument(where + " is " + SolidNumber(s.value) +
                                " mm off the surface; at most a quarter of the width, " +
                                SolidNumber(most) + " mm: give places on the surface, and more");
  return RequireDirection(where.c_str(), "the surface's normal", s.gradient);
}
} // namespace

SolidPointer MakeTube(std::span<const glm::dvec3> line, bool closed, double radiusMm)
{
  if (line.empty())
    throw std::invalid_argument("tube: the line has no points; give one at least");
  RequireFiniteLine("tube", line);
  RequirePositive("tube", "radius", radiusMm);
  std::vector<SolidPointer> parts;
  AddCapsules(parts, line, closed, radiusMm);
  return MakeUnion(std::move(parts));
}

SolidPointer MakeRibbon(SolidPointer surface, std::span<const glm::dvec3> path, double widthMm,
  double fromMm, double toMm, std::span<const glm::dvec3> normals)
{
  if (path.size() < 2)
    throw std::invalid_argument(
      "ribbon: the path has " + std::to_string(path.size()) + " places; give two at least");
  RequirePositive("ribbon", "width", widthMm);
  RequireFiniteLine("ribbon", path);
  if (!normals.empty() && normals.size() + 1 != path.size())
    throw std::invalid_argument("ribbon: there are " + std::to_string(normals.size()) +
                                " normals for " + std::to_string(path.size() - 1) + " segments");
  const SolidPointer wall = MakeShell(surface, fromMm, toMm);
  const double off = 0.25 * widthMm;
  const RibbonBand band{ widthMm, std::min(fromMm, 0.0),
    std::max(std::abs(fromMm), std::abs(toMm)) + RibbonBendPerWidth * widthMm };
  std::vector<SolidPointer> parts;
  for (std::size_t n = 0; n + 1 < path.size(); ++n)
  {
    const glm::dvec3 a = path[n], b = path[n + 1], middle = 0.5 * (a + b);
    const std::string where = "ribbon: middle after place" + PlaceName(n, middle);
    glm::dvec3 normal = NormalOn(*surface, a, off, "place", n);
    normal += NormalOn(*surface, b, off, "place", n + 1);
    normal += NormalOn(*surface, middle, off, "middle after place", n);
    if (!normals.empty())
      normal = normals[n];
    const RibbonSegment segment(a, b, normal, where.c_str());
    const double depth =
      RibbonDepth(*surface, segment, band, n == 0, n + 2 == path.size(), where.c_str());
    const glm::dvec3 up = 0.5 * (band.reach - depth) * segment.normal;
    parts.push_back(MakeStadium(a + up, b + up, normal, 0.5 * widthMm, band.reach + depth));
  }
  return MakeIntersection({ wall, MakeUnion(std::move(parts)) });
}

SolidPointer MakeText(std::string_view text, const glm::dvec3& origin, const glm::dvec3& right,
  const glm::dvec3& up, double heightMm, double strokeMm)
{
  RequireFinite("text", "origin", origin);
  RequirePositive("text", "height", heightMm);
  RequirePositive("text", "stroke", strokeMm);
  const double unit = heightMm / LetterHeight;
  if (strokeMm > unit)
    throw std::invalid_argument("text: a stroke of " + SolidNumber(strokeMm) +
                                " mm fills letters of " + SolidNumber(heightMm) + " mm; at most " +
                                SolidNumber(unit) + " mm, a sixth of the height");
  const glm::dvec3 x = RequireDirection("text", "direction to the right", right);
  const glm::dvec3 y = RequireDirection("text", "direction up, upright on the right,",
    RequireDirection("text", "direction up", up) -
      glm::dot(RequireDirection("text", "direction up", up), x) * x);
  std::vector<SolidPointer> parts;
  for (std::size_t n = 0; n < text.size(); ++n)
  {
    const glm::dvec3 corner = origin + double(n) * LetterPlace * unit * x;
    std::vector<glm::dvec3> stroke;
    for (const char* digit = StrokesOf(text[n], n);; ++digit)
    {
      if (*digit >= '0')
      {
        stroke.push_back(corner + unit * (double(digit[0] - '0') * x + double(digit[1] - '0') * y));
        ++digit;
        continue;
      }
      if (!stroke.empty())
        AddCapsules(parts, stroke, false, 0.5 * strokeMm);
      stroke.clear();
      if (*digit == '\0')
        break;
    }
  }
  if (parts.empty())
    throw std::invalid_argument("text: it has no strokes; give a letter at least");
  return MakeUnion(std::move(parts));
}

double TextWidth(std::size_t letters, double heightMm)
{
  return letters == 0 ? 0.0
                      : (double(letters - 1) * LetterPlace + LetterWidth) * heightMm / LetterHeight;
}

} // namespace hasp
