// Trees are asked millions of times, from every thread: without memory of their own.
#include "Distance/GridSolid.h"
#include "Distance/SolidSweeps.h"
#include "Grid/Testing/CountNew.h"
#include "Testing/RandomSolid.h"
#include "Testing/SolidPromises.h"

namespace
{

TEST(SolidMemory, AskingTakesNone)
{
  std::vector<hasp::SolidPointer> solids;
  for (unsigned seed = 0; seed < 40; ++seed)
    solids.push_back(hasp::RandomSolid(seed, 3));
  solids.push_back(hasp::MakeText("HASP 0:7", {}, { 1, 0, 0 }, { 0, 1, 0 }, 3, 0.3));
  const hasp::GridGeometry g{ { 9, 9, 9 }, { -4, -4, -4 }, glm::dvec3(1), glm::dmat3(1) };
  solids.push_back(hasp::MakeGridSolid(std::make_shared<std::vector<float>>(g.Size(), -1.0F), g));
  // On lattices, where faces tie and films are looked for, too.
  auto places = hasp::RandomPlaces(500, 6);
  for (std::size_t n = 0; n < 250; ++n)
    places[n] = 0.5 * glm::round(2.0 * places[n]);
  double sum = 0.0;
  const std::size_t before = hasp::test::NewCount();
  for (const auto& solid : solids)
    for (const glm::dvec3& x : places)
    {
      const auto s = solid->SampleAt(x);
      sum += solid->At(x) + s.value + solid->FaceAt(s.face, x).value + solid->Bounds().low.x;
    }
  EXPECT_EQ(hasp::test::NewCount(), before);
  EXPECT_NE(sum, 0.0);
}

} // namespace
