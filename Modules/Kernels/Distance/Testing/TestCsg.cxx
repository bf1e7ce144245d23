#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"
#include "Testing/RandomSolid.h"
#include "Testing/SolidPromises.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <string>

namespace
{

const glm::dmat3 One(1);

hasp::SolidPointer Box(const glm::dvec3& center, const glm::dvec3& half)
{
  return hasp::MakeBox(center, One, half);
}

hasp::SolidPointer Ball(const glm::dvec3& center, double radius)
{
  return hasp::MakeCapsule(center, center, radius);
}

/// The same values everywhere, to the last bit.
void ExpectSame(const hasp::SolidPointer& a, const hasp::SolidPointer& b)
{
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 8))
    ASSERT_EQ(a->At(x), b->At(x));
}

TEST(Csg, RefusesWhatIsNoTree)
{
  const auto ball = Ball({}, 1);
  EXPECT_THROW(hasp::MakeUnion({}), std::invalid_argument);
  EXPECT_THROW(hasp::MakeUnion({ ball, nullptr }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeIntersection({}), std::invalid_argument);
  EXPECT_THROW(hasp::MakeIntersection({ nullptr }), std::invalid_argument);
  EXPECT_THROW(hasp::MakeDifference(ball, nullptr), std::invalid_argument);
  EXPECT_THROW(hasp::MakeDifference(nullptr, ball), std::invalid_argument);
  EXPECT_THROW(hasp::MakeOffset(nullptr, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeOffset(ball, std::nan("")), std::invalid_argument);
  EXPECT_THROW(hasp::MakeShell(nullptr, 0, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeShell(ball, 1, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeShell(ball, 0, std::nan("")), std::invalid_argument);
  EXPECT_THROW(hasp::MakeSmoothUnion(ball, nullptr, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeSmoothUnion(ball, ball, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeSmoothIntersection(nullptr, ball, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeSmoothIntersection(ball, ball, -1), std::invalid_argument);
  // Pairs of faces multiply: refused before their numbers run out.
  hasp::SolidPointer many = Box({}, { 1, 1, 1 });
  EXPECT_THROW(
    for (int n = 0; n < 8; ++n) many = hasp::MakeSmoothUnion(many, Box({}, { 1, 1, 1 }), 0.1),
    std::invalid_argument);
}

TEST(Csg, KeepsThePromisesOfASolid)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto solid = hasp::RandomSolid(seed, 3);
    const auto places = hasp::RandomPlaces(400, 9);
    hasp::ExpectSamplesAgree(*solid, places);
    hasp::ExpectNoSteeperThanPromised(*solid, places);
  }
}

TEST(Csg, IsLeastMostAndTurnedRound)
{
  const auto a = Box({ 1, 0, 0 }, { 2, 3, 1 }), b = Ball({ 3, 1, 0 }, 2), c = Ball({ -2, 0, 1 }, 1);
  const auto all = hasp::MakeUnion({ a, b, c }), common = hasp::MakeIntersection({ a, b, c });
  const auto rest = hasp::MakeDifference(a, b), grown = hasp::MakeOffset(a, 0.7);
  const auto wall = hasp::MakeShell(a, -0.2, 0.5);
  for (const glm::dvec3& x : hasp::RandomPlaces(5000, 8))
  {
    const double va = a->At(x), vb = b->At(x), vc = c->At(x);
    ASSERT_EQ(all->At(x), std::min({ va, vb, vc }));
    ASSERT_EQ(common->At(x), std::max({ va, vb, vc }));
    ASSERT_EQ(rest->At(x), std::max(va, -vb));
    ASSERT_EQ(grown->At(x), va - 0.7);
    ASSERT_EQ(wall->At(x), std::max(va - 0.5, -0.2 - va));
  }
}

TEST(Csg, HoldsTheIdentitiesOfSets)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto a = hasp::RandomSolid(3 * seed, 1), b = hasp::RandomSolid(3 * seed + 1, 2);
    const auto c = hasp::RandomSolid(3 * seed + 2, 1);
    const auto nothing = hasp::MakeDifference(a, a);
    for (const glm::dvec3& x : hasp::RandomPlaces(1000, 8))
      ASSERT_GE(nothing->At(x), 0.0);
    ExpectSame(hasp::MakeUnion({ a, nothing }), a);
    ExpectSame(hasp::MakeUnion({ a, a }), a);
    ExpectSame(hasp::MakeIntersection({ a, a }), a);
    ExpectSame(hasp::MakeUnion({ a, b }), hasp::MakeUnion({ b, a }));
    ExpectSame(hasp::MakeUnion({ hasp::MakeUnion({ a, b }), c }), hasp::MakeUnion({ a, b, c }));
    ExpectSame(hasp::MakeIntersection({ hasp::MakeIntersection({ a, b }), c }),
      hasp::MakeIntersection({ a, b, c }));
    ExpectSame(hasp::MakeUnion({ a, hasp::MakeIntersection({ b, c }) }),
      hasp::MakeIntersection({ hasp::MakeUnion({ a, b }), hasp::MakeUnion({ a, c }) }));
    // De Morgan, with a for everything.
    ExpectSame(hasp::MakeDifference(a, hasp::MakeUnion({ b, c })),
      hasp::MakeIntersection({ hasp::MakeDifference(a, b), hasp::MakeDifference(a, c) }));
    ExpectSame(hasp::MakeDifference(a, hasp::MakeIntersection({ b, c })),
      hasp::MakeUnion({ hasp::MakeDifference(a, b), hasp::MakeDifference(a, c) }));
    ExpectSame(hasp::MakeDifference(hasp::MakeDifference(a, b), c),
      hasp::MakeDifference(a, hasp::MakeUnion({ b, c })));
  }
}

TEST(Csg, GradientsPointOutOfWhatIsLeft)
{
  // Out of a ball's hole in a box means towards its middle.
  const auto left = hasp::MakeDifference(Box({}, { 4, 4, 4 }), Ball({}, 2));
  for (const glm::dvec3& x : hasp::RandomPlaces(200, 1))
  {
    const glm::dvec3 out = glm::normalize(x);
    const auto s = left->SampleAt(2.0 * out);
    EXPECT_NEAR(s.value, 0.0, 1e-12);
    EXPECT_LT(glm::distance(s.gradient, -out), 1e-9);
    EXPECT_EQ(s.face, 26u);
  }
  const auto wall = hasp::MakeShell(Ball({}, 2), -0.5, 0.5);
  EXPECT_EQ(wall->SampleAt({ 2.5, 0, 0 }).gradient, glm::dvec3(1, 0, 0));
  EXPECT_EQ(wall->SampleAt({ 1.5, 0, 0 }).gradient, glm::dvec3(-1, 0, 0));
  EXPECT_EQ(wall->SampleAt({ 2.5, 0, 0 }).face, 0u);
  EXPECT_EQ(wall->SampleAt({ 1.5, 0, 0 }).face, 1u);
}

TEST(Csg, GradientsOfAllFacesFollowTheirValues)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto solid = hasp::RandomSolid(seed, 2);
    auto faces = hasp::AllFaces(*solid);
    std::shuffle(faces.begin(), faces.end(), std::mt19937(seed));
    faces.resize(std::min<std::size_t>(faces.size(), 60));
    hasp::ExpectGradientsOfFaces(*solid, hasp::RandomPlaces(10, 9), faces, 1e-4);
  }
}

TEST(Csg, FacesOfPartsFollowEachOther)
{
  const auto box = Box({}, { 2, 2, 2 }), ball = Ball({ 6, 0, 0 }, 1);
  const auto both = hasp::MakeUnion({ ball, box, ball });
  EXPECT_EQ(both->Faces(), 28u);
  EXPECT_EQ(both->SampleAt({ 7, 0, 0 }).face, 0u);
  EXPECT_EQ(both->SampleAt({ 0, 2, 0 }).face, 1u + box->SampleAt({ 0, 2, 0 }).face);
  EXPECT_EQ(both->FaceAt(27, { 9, 0, 0 }).value, 2.0);
  EXPECT_EQ(both->FaceAt(27, { 9, 0, 0 }).face, 27u);
}

TEST(Csg, AnOffsetOfAShapeHasRoundEdgesWithFacesOfTheirOwn)
{
  const auto grown = hasp::MakeOffset(Box({}, { 1, 1, 1 }), 0.5);
  const double diagonal = 0.5 * std::sqrt(0.5);
  const auto edge = grown->SampleAt({ 1 + diagonal, 1 + diagonal, 0 });
  EXPECT_NEAR(edge.value, 0.0, 1e-12);
  EXPECT_LT(glm::distance(edge.gradient, glm::dvec3(std::sqrt(0.5), std::sqrt(0.5), 0)), 1e-12);
  EXPECT_NEAR(grown->FaceAt(edge.face, { 1.5, 1, 8 }).value, 0.0, 1e-12);
  // Smooth where they meet: the plane face's normal is the edge's there.
  EXPECT_EQ(grown->FaceAt(edge.face, { 1.5, 1, 0 }).gradient, glm::dvec3(1, 0, 0));
  const auto rim = hasp::MakeOffset(hasp::MakeCylinder({}, { 0, 0, 2 }, 3), 1);
  EXPECT_NEAR(rim->SampleAt({ 3 + std::sqrt(0.5), 0, 2 + std::sqrt(0.5) }).value, 0.0, 1e-12);
}

TEST(Csg, OffsetsAddUpAndEndBeyondThePart)
{
  const auto part = hasp::RandomSolid(4, 2);
  const auto once = hasp::MakeOffset(part, 0.75);
  ExpectSame(hasp::MakeOffset(hasp::MakeOffset(part, 0.5), 0.25), once);
  const auto gone = hasp::MakeOffset(Box({}, { 1, 2, 3 }), -1.001);
  const auto thin = hasp::MakeShell(Box({}, { 1, 2, 3 }), -5, -1.001);
  for (const glm::dvec3& x : hasp::RandomPlaces(1000, 4))
  {
    ASSERT_GT(gone->At(x), 0.0);
    ASSERT_GT(thin->At(x), 0.0);
  }
  hasp::ExpectSamplesAgree(*gone, hasp::RandomPlaces(500, 4));
  // Bounds may be empty, low above high: they still tell what is far.
  EXPECT_GT(gone->Bounds().low.x, gone->Bounds().high.x);
  EXPECT_EQ(hasp::MakeUnion({ gone, Ball({}, 1) })->At({ 1, 0, 0 }), 0.0);
}

TEST(Csg, TiesOfCoplanarFacesNameThePartThatComesFirst)
{
  // Three boxes side by side whose tops are one plane, turned so that last digits differ.
  const glm::dmat3 axes(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(1, 2, 3)));
  const auto turned = [&](const glm::dvec3& center, const glm::dvec3& half)
  { return hasp::MakeBox(axes * center, axes, half); };
  std::vector<hasp::SolidPointer> row;
  for (int n = 0; n < 3; ++n)
    row.push_back(turned({ 0.3 * n, 0, 0.7 - 0.1 * (n + 3) }, { 1, 1, 0.1 * (n + 3) }));
  // In whatever order they are given and visited, the first of them is named.
  std::sort(row.begin(), row.end());
  do
  {
    const auto all = hasp::MakeUnion(row), common = hasp::MakeIntersection(row);
    const auto shorter = hasp::MakeDifference(row[0],
      hasp::MakeDifference(turned({ 0, 0, 0.7 + 0.1 }, { 5, 5, 0.1 }), Ball({ 9, 9, 9 }, 1)));
    for (const glm::dvec3& p : hasp::RandomPlaces(200, 0.3))
    {
      const glm::dvec3 x = axes * glm::dvec3(p.x, p.y, 0.7);
      ASSERT_LT(std::abs(all->At(x)), 1e-12);
      ASSERT_LT(all->SampleAt(x).face, 26u);
      ASSERT_LT(common->SampleAt(x).face, 26u);
      ASSERT_LT(shorter->SampleAt(x).face, 26u);
    }
  } while (std::next_permutation(row.begin(), row.end()));
}

TEST(Csg, PartsThatTouchLeaveNoGap)
{
  // Eight boxes of 0.1 + 0.2 mm (not 0.3 in binary) around a corner, none along the axes.
  const glm::dvec3 corner(0.7, -1.3, 2.1), size(0.3, 0.1 + 0.2, 3.0 * 0.1);
  const glm::dmat3 axes(glm::rotate(glm::dmat4(1), 0.3, glm::dvec3(1, 2, 3)));
  std::vector<hasp::SolidPointer> boxes;
  for (int n = 0; n < 8; ++n)
  {
    const glm::dvec3 way(n & 1 ? 1 : -1, n & 2 ? 1 : -1, n & 4 ? 1 : -1);
    boxes.push_back(hasp::MakeBox(corner + axes * (0.5 * way * size), axes, 0.5 * size));
  }
  const auto all = hasp::MakeUnion(boxes);
  hasp::SolidPointer chain = boxes[0];
  for (int n = 1; n < 8; ++n)
    chain = hasp::MakeUnion({ chain, boxes[n] });
  for (const glm::dvec3& p : hasp::RandomPlaces(300, 0.29))
    for (const glm::dvec3& on : { glm::dvec3(0, p.y, p.z), glm::dvec3(p.x, 0, p.z),
           glm::dvec3(p.x, p.y, 0), glm::dvec3(p.x, 0, 0), glm::dvec3(0, 0, p.z), glm::dvec3(0) })
    {
      ASSERT_EQ(all->At(corner + axes * on), -1e-5);
      ASSERT_LT(chain->At(corner + axes * on), -0.9e-5);
      ASSERT_EQ(all->SampleAt(corner + axes * on).value, -1e-5);
    }
  // A pin in its hole.
  const auto pin = hasp::MakeCylinder({ 0, 0, -3 }, { 0.3, 0.2, 3 }, 1);
  const auto plate = Box({}, { 4, 4, 1 });
  const auto filled = hasp::MakeUnion({ hasp::MakeDifference(plate, pin), pin });
  for (const glm::dvec3& p : hasp::RandomPlaces(300, 0.9))
  {
    glm::dvec3 x = p;
    for (int n = 0; n < 3; ++n) // down to the last digits of the pin's side
    {
      const auto side = pin->FaceAt(0, x);
      x -= side.value * side.gradient;
    }
    ASSERT_EQ(filled->At(x), -1e-5);
  }
}

TEST(Csg, ToolsThatTouchLeaveNoWall)
{
  const auto body = Box({ 0.7, 0, 0 }, { 3, 1, 1 });
  const auto left = Box({ 0.7 - 0.15, 0, 0 }, { 0.15, 2, 2 });
  const auto right = Box({ 0.7 + 0.05, 0, 0 }, { 0.05, 2, 2 });
  const hasp::SolidPointer slots[] = {
    hasp::MakeDifference(hasp::MakeDifference(body, left), right),
    hasp::MakeDifference(body, hasp::MakeUnion({ left, right })),
    hasp::MakeIntersection({ hasp::MakeDifference(body, left), hasp::MakeDifference(body, right) }),
  };
  const auto common = hasp::MakeIntersection({ left, right });
  // A box less one of the same measures, told in other digits.
  const auto nothing = hasp::MakeDifference(
    Box({ 0.7, 0, 0 }, { 0.3, 1, 1 }), Box({ 0.1 + 0.2 + 0.4, 0, 0 }, { 0.1 + 0.2, 1, 1 }));
  for (const glm::dvec3& p : hasp::RandomPlaces(300, 0.99))
  {
    const glm::dvec3 x(0.7, p.y, p.z);
    for (const auto& slot : slots)
      ASSERT_EQ(slot->At(x), 1e-5);
    ASSERT_EQ(common->At(x), 1e-5);
    ASSERT_EQ(nothing->At(x + glm::dvec3(0.3, 0, 0)), 1e-5);
  }
}

TEST(Csg, WhatIsNoFilmIsMinAndMaxToTheLastBit)
{
  // Tops in one plane, a wall on a floor, the crease of a slot, boxes that touch along an edge.
  const auto a = Box({}, { 1, 1, 1 }), beside = Box({ 1.5, 0, 0.5 }, { 0.6, 1, 0.5 });
  const auto edge = Box({ -2, -2, 0 }, { 1, 1, 1 }), through = Box({}, { 0.25, 2, 2 });
  const auto all = hasp::MakeUnion({ a, beside, edge });
  const auto slot = hasp::MakeDifference(a, through);
  for (const glm::dvec3& p : hasp::RandomPlaces(300, 1.5))
    for (const glm::dvec3& x :
      { glm::dvec3(p.x, p.y, 1), glm::dvec3(-1, -1, p.z), glm::dvec3(0.25, p.y, 1),
        glm::dvec3(0.25, p.y, p.z), glm::dvec3(0.9, p.y, 0.0), glm::dvec3(1, p.y, -0.5) })
    {
      ASSERT_EQ(all->At(x), std::min({ a->At(x), beside->At(x), edge->At(x) }));
      ASSERT_EQ(slot->At(x), std::max(a->At(x), -through->At(x)));
    }
}

/// Counts how often it is asked.
class Counting : public hasp::ImplicitSolid
{
public:
  explicit Counting(hasp::SolidPointer part) : Part(std::move(part)) {}
  double At(const glm::dvec3& x) const noexcept override
  {
    ++this->Asked;
    return this->Part->At(x);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    ++this->Asked;
    return this->Part->SampleAt(x);
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return this->Part->FaceAt(face, x);
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override { return this->Part->Bounds(); }

  mutable int Asked = 0;

private:
  hasp::SolidPointer Part;
};

TEST(Csg, DoesNotAskWhatIsFar)
{
  // A plate with 400 holes: at a place a few of them matter.
  std::vector<std::shared_ptr<Counting>> holes;
  std::vector<hasp::SolidPointer> tools;
  for (int n = 0; n < 400; ++n)
  {
    const glm::dvec3 at(n % 20 * 5 - 47.5, n / 20 * 5 - 47.5, 0);
    holes.push_back(std::make_shared<Counting>(
      hasp::MakeCylinder(at - glm::dvec3(0, 0, 4), at + glm::dvec3(0, 0, 4), 1)));
    tools.push_back(holes.back());
  }
  const auto tool = std::make_shared<Counting>(hasp::MakeUnion(tools));
  const auto body = std::make_shared<Counting>(Box({}, { 50, 50, 3 }));
  const auto plate = hasp::MakeDifference(body, tool);
  const auto places = hasp::RandomPlaces(1000, 60);
  for (const glm::dvec3& x : places)
  {
    double least = 1e9;
    for (const auto& hole : holes)
      least = std::min(least, hole->At(x));
    ASSERT_EQ(plate->At(x), std::max(body->At(x), -least));
  }
  for (const auto& hole : holes)
    hole->Asked = 0;
  tool->Asked = body->Asked = 0;
  for (const glm::dvec3& x : places)
    (void)plate->At(x);
  int asked = 0;
  for (const auto& hole : holes)
    asked += hole->Asked;
  EXPECT_EQ(body->Asked, 1000);
  EXPECT_LT(tool->Asked, 150);       // most places lie above or below the plate, and out of holes
  EXPECT_LT(asked, 4 * tool->Asked); // of 400

  // A fillet asks the other part only where it may reach, whichever comes first.
  const auto left = std::make_shared<Counting>(Ball({ -20, 0, 0 }, 2));
  const auto right = std::make_shared<Counting>(Ball({ 20, 0, 0 }, 2));
  const auto joined = hasp::MakeSmoothUnion(left, right, 1);
  (void)joined->At({ -15, 0, 0 });
  (void)joined->SampleAt({ -15, 0, 0 });
  EXPECT_EQ(left->Asked, 2);
  EXPECT_EQ(right->Asked, 0);
  (void)joined->At({ 15, 0, 0 });
  (void)joined->SampleAt({ 15, 0, 0 });
  EXPECT_EQ(left->Asked, 2);
  EXPECT_EQ(right->Asked, 2);
}

// On the faces of the first cut those of all others tie, and each may be a film.
TEST(Csg, ACutThatIsMadeAgainAndAgainIsNotAskedMoreAndMore)
{
  const auto body = std::make_shared<Counting>(Box({}, { 10, 10, 10 }));
  hasp::SolidPointer cut = body;
  for (int n = 0; n < 12; ++n)
    cut = hasp::MakeDifference(cut, hasp::MakeSlab({}, { 0, 0, 1 }, 1));
  EXPECT_NEAR(cut->At({ 1, 1, 0.5 }), 0.0, 1e-12);
  EXPECT_NEAR(cut->SampleAt({ 1, 1, 0.5 }).value, 0.0, 1e-12);
  EXPECT_LT(body->Asked, 500);
}

TEST(Csg, PartsJoinedTwoAtATimeAreAskedAsIfJoinedAtOnce)
{
  const auto first = std::make_shared<Counting>(Box({ 0, 0, 10 }, { 10, 10, 10 }));
  hasp::SolidPointer sum = first, common = first;
  for (int n = 1; n < 14; ++n) // all on one plane
  {
    const auto next = Box({ 0.1 * n, 0, 10.0 + n }, { 10, 10, 10.0 + n });
    sum = hasp::MakeUnion({ sum, next });
    common = hasp::MakeIntersection({ common, next });
  }
  EXPECT_EQ(sum->Faces(), 14 * 26U);
  for (const auto& solid : { sum, common })
    EXPECT_NEAR(solid->SampleAt({ 1, 1, 0 }).value, 0.0, 1e-12);
  EXPECT_LT(first->Asked, 50);
}

TEST(Csg, APlaceThatIsNotFiniteHasAFace)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const auto solid = hasp::RandomSolid(seed, 3);
    for (const double bad :
      { std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300 })
      EXPECT_LT(solid->SampleAt({ 0, bad, 1 }).face, solid->Faces());
  }
}

} // namespace
