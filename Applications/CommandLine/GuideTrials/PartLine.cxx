#include "PartLine.h"

#include "Evaluation/MeshCheck.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdio>

namespace hasp
{
namespace
{

PartVerdict OfError(const TriedPart& part)
{
  if (part.error.find(part.owner) == std::string::npos)
    return PartVerdict::FellBack;
  const bool expected =
    part.refusal.empty() ? part.mayBeRefused : part.error.find(part.refusal) != std::string::npos;
  return expected && part.mesh.triangles.empty() ? PartVerdict::Refused : PartVerdict::Wrong;
}

PartVerdict OfMesh(const TriedPart& part)
{
  if (!part.refusal.empty())
    return PartVerdict::Wrong;
  if (part.mesh.triangles.empty())
    return PartVerdict::Empty;
  const MeshCheck check = CheckMesh(part.mesh);
  if (!check.Sound() || check.pieces != 1)
    return PartVerdict::Open;
#if HASP_WITH_CGAL
  if (CountSelfIntersections(part.mesh) > 0)
    return PartVerdict::Crossed;
#endif
  return PartVerdict::Sound;
}

} // namespace

const char* PartVerdictName(PartVerdict verdict)
{
  switch (verdict)
  {
    case PartVerdict::Sound:
      return "sound";
    case PartVerdict::Refused:
      return "refused";
    case PartVerdict::Open:
      return "not one closed 2-manifold piece, outward";
    case PartVerdict::Crossed:
      return "meets itself";
    case PartVerdict::Empty:
      return "no part and no error";
    case PartVerdict::Wrong:
      return "made against, or refused for other than, what is expected";
    case PartVerdict::FellBack:
      return "an error of something below";
  }
  return "";
}

TriangleMesh AsWritten(TriangleMesh mesh)
{
  for (glm::dvec3& p : mesh.points)
    p = glm::dvec3(glm::vec3(p));
  return WeldPoints(mesh);
}

std::string FormatPartLine(const PartLine& line)
{
  char text[160];
  std::snprintf(text, sizeof text, "%u %d %.9g %.9g %zu %.6g ", line.seed,
    static_cast<int>(line.verdict), line.figure, line.second, line.triangles, line.seconds);
  std::string words = line.text;
  std::replace(words.begin(), words.end(), '\n', ' ');
  return text + words + " .\n"; // whatever was cut off lacks the end
}

std::optional<PartLine> ParsePartLine(const std::string& text)
{
  PartLine line;
  int verdict = -1, words = 0;
  if (std::sscanf(text.c_str(), "%u %d %lf %lf %zu %lf %n", &line.seed, &verdict, &line.figure,
        &line.second, &line.triangles, &line.seconds, &words) != 6 ||
      verdict < 0 || verdict > static_cast<int>(PartVerdict::FellBack) || !text.ends_with(" ."))
    return std::nullopt;
  line.verdict = static_cast<PartVerdict>(verdict);
  line.text = text.substr(std::size_t(words), text.size() - std::size_t(words) - 2);
  return line;
}

PartLine JudgePart(const TriedPart& part)
{
  PartLine line;
  line.verdict = part.error.empty() ? OfMesh(part) : OfError(part);
  line.triangles = part.mesh.triangles.size();
  line.text = part.kind + (part.error.empty() ? "" : ": " + part.error);
  return line;
}

} // namespace hasp
