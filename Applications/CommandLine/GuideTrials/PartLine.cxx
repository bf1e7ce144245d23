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

PartOutcome OfError(const TriedPart& part)
{
  if (part.error.find(part.owner) == std::string::npos)
    return PartOutcome::FellBack;
  const bool expected =
    part.refusal.empty() ? part.mayBeRefused : part.error.find(part.refusal) != std::string::npos;
  return expected && part.mesh.triangles.empty() ? PartOutcome::Refused : PartOutcome::Wrong;
}

PartOutcome OfMesh(const TriedPart& part)
{
  if (!part.refusal.empty())
    return PartOutcome::Wrong;
  if (part.mesh.triangles.empty())
    return PartOutcome::Empty;
  const MeshCheck check = CheckMesh(part.mesh);
  if (!check.Sound() || check.pieces != 1)
    return PartOutcome::Open;
#if HASP_WITH_CGAL
  if (CountSelfIntersections(part.mesh) > 0)
    return PartOutcome::Crossed;
#endif
  return PartOutcome::Sound;
}

} // namespace

const char* PartOutcomeName(PartOutcome outcome)
{
  switch (outcome)
  {
    case PartOutcome::Sound:
      return "sound";
    case PartOutcome::Refused:
      return "refused";
    case PartOutcome::Open:
      return "not one closed 2-manifold piece, outward";
    case PartOutcome::Crossed:
      return "meets itself";
    case PartOutcome::Empty:
      return "no part and no error";
    case PartOutcome::Wrong:
      return "made against, or refused for other than, what is expected";
    case PartOutcome::FellBack:
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
    static_cast<int>(line.outcome), line.figure, line.second, line.triangles, line.seconds);
  std::string words = line.text;
  std::replace(words.begin(), words.end(), '\n', ' ');
  return text + words + " .\n"; // whatever was cut off lacks the end
}

std::optional<PartLine> ParsePartLine(const std::string& text)
{
  PartLine line;
  int outcome = -1, words = 0;
  if (std::sscanf(text.c_str(), "%u %d %lf %lf %zu %lf %n", &line.seed, &outcome, &line.figure,
        &line.second, &line.triangles, &line.seconds, &words) != 6 ||
      outcome < 0 || outcome > static_cast<int>(PartOutcome::FellBack) || !text.ends_with(" ."))
    return std::nullopt;
  line.outcome = static_cast<PartOutcome>(outcome);
  line.text = text.substr(std::size_t(words), text.size() - std::size_t(words) - 2);
  return line;
}

PartLine JudgePart(const TriedPart& part)
{
  PartLine line;
  line.outcome = part.error.empty() ? OfMesh(part) : OfError(part);
  line.triangles = part.mesh.triangles.size();
  line.text = part.kind + (part.error.empty() ? "" : ": " + part.error);
  return line;
}

} // namespace hasp
