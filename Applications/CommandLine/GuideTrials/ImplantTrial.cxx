#include "ImplantTrial.h"

#include "RandomImplants.h"

#include "Evaluation/MeshCheck.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <glm/vec3.hpp>

#include <exception>
#include <map>

namespace hasp
{
namespace
{

/// What is wrong with a mesh, or "".
std::string FaultOf(TriangleMesh mesh)
{
  for (glm::dvec3& p : mesh.points)
    p = glm::dvec3(glm::vec3(p));
  const MeshCheck check = CheckMesh(mesh);
  if (!check.Sound())
    return "is not sound";
  if (check.pieces != 1)
    return "is in " + std::to_string(check.pieces) + " pieces";
#if HASP_WITH_CGAL
  if (!FindSelfIntersections(mesh).empty())
    return "meets itself";
#endif
  return {};
}

/// Makes one, and counts it; says what went otherwise.
std::string TryOne(const RandomImplant& random, const ImplantSkull& skull,
  const MakeImplantFunction& make, ImplantTrial& trial)
{
  try
  {
    const std::string fault = FaultOf(make(skull.View(), random.recipe));
    if (!fault.empty())
      return fault;
    if (!random.says.empty())
      return "was made, must be refused: " + random.says;
    ++trial.made;
  }
  catch (const std::exception& error)
  {
    if (random.says.empty() || std::string(error.what()).find(random.says) == std::string::npos)
      return std::string("said: ") + error.what();
    ++trial.refused;
  }
  return {};
}
} // namespace

ImplantTrial TryImplants(
  std::uint32_t firstSeed, std::size_t count, std::uint32_t step, const MakeImplantFunction& make)
{
  ImplantTrial trial;
  std::map<std::uint32_t, ImplantSkull> skulls;
  for (std::size_t n = 0; n < count; ++n)
  {
    const auto seed = std::uint32_t(firstSeed + n * step);
    ImplantSkull& skull = skulls[seed % ImplantSkulls];
    if (skull.grey.empty())
      skull = MakeImplantSkull(seed);
    const RandomImplant random = RandomImplantRecipe(seed, skull);
    ++trial.recipes;
    const std::string wrong = TryOne(random, skull, make, trial);
    if (!wrong.empty())
      trial.wrong.push_back("seed " + std::to_string(seed) + ", " +
                            ImplantNonsenseName(random.nonsense) + ": " + wrong);
  }
  return trial;
}

} // namespace hasp
