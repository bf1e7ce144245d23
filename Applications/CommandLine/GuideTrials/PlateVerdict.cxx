#include "RandomPlates.h"

#include "Evaluation/MeshCheck.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

namespace hasp
{

std::string WrongWithPlate(
  const RandomPlate& plate, const std::string& error, const TriangleMesh& mesh)
{
  const std::string name = std::string(plate.kind) + ": ";
  if (!error.empty())
  {
    if (!mesh.triangles.empty())
      return name + "there is an error and a mesh: " + error;
    if (plate.outcome == PlateOutcome::Sound)
      return name + "refused: " + error;
    const std::string& words = plate.outcome == PlateOutcome::Refused ? plate.words : "plate: ";
    return error.find(words) != std::string::npos ? "" : name + "another error: " + error;
  }
  if (plate.outcome == PlateOutcome::Refused)
    return name + "made, must be refused: " + plate.words;
  const MeshCheck check = CheckMesh(mesh);
  if (!check.Sound() || check.pieces != 1)
    return name + "not one closed 2-manifold piece, outward";
#if HASP_WITH_CGAL
  if (const std::size_t pairs = CountSelfIntersections(mesh); pairs > 0)
    return name + "meets itself, " + std::to_string(pairs) + " pairs of triangles";
#endif
  return {};
}

} // namespace hasp
