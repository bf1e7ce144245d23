// Random plates, printed: BenchRandomPlates [plates, 110] [first seed]
// Of each kind, how many were made, refused and wrong, and how many of those made hold their
// recipe.
#include "Evaluation/FitCertificate.h"
#include "MadePlate.h"
#include "PlateClaims.h"
#include "RandomPlates.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <cstdlib>
#include <map>

namespace
{

struct Count
{
  int made = 0, refused = 0, wrong = 0, holds = 0;
};

/// Why it does not hold; empty if it does.
std::string Fault(
  vtkImageData* head, const hasp::PlateRecipe& recipe, const hasp::TriangleMesh& mesh)
{
  hasp::FindSelfIntersectionsFunction find;
#if HASP_WITH_CGAL
  find = hasp::FindSelfIntersections;
#endif
  const auto scan = hasp::ViewImage(head);
  const auto claims = hasp::ClaimsOf(recipe, hasp::FindScrewAxes(scan, recipe));
  const auto certificate = hasp::CertifyFit(mesh, scan, claims, find);
  return certificate.Holds() ? "" : certificate.faults.front().text;
}

} // namespace

int main(int argc, char** argv)
{
  const auto plates = std::uint32_t(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 110);
  const auto first = std::uint32_t(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0);
  const auto head = platetest::Head();
  std::map<std::string, Count> kinds;
  int wrong = 0;
  for (std::uint32_t seed = first; seed < first + plates; ++seed)
  {
    const auto plate = hasp::RandomPlateRecipe(seed);
    const platetest::Made answer(head, plate.recipe);
    Count& count = kinds[plate.kind];
    (answer.mesh.triangles.empty() ? count.refused : count.made) += 1;
    const std::string fault = hasp::WrongWithPlate(plate, answer.error, answer.mesh);
    if (!fault.empty())
      std::printf("seed %u, %s\n", seed, fault.c_str());
    count.wrong += !fault.empty();
    wrong += !fault.empty();
    if (answer.mesh.triangles.empty())
      continue;
    const std::string red = Fault(head, plate.recipe, answer.mesh);
    count.holds += red.empty();
    if (!red.empty())
      std::printf("seed %u, %s does not hold: %s\n", seed, plate.kind, red.c_str());
  }
  for (const auto& [kind, count] : kinds)
    std::printf("%-32s made %4d, of which hold %4d; refused %4d; wrong %4d\n", kind.c_str(),
      count.made, count.holds, count.refused, count.wrong);
  std::printf("%u plates, wrong %d\n", plates, wrong);
  return wrong == 0 ? 0 : 1;
}
