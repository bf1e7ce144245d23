#include "Reduction/FitTerms.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr double LeastAlike = 0.8; // cosine between normals of one surface that goes on
constexpr double NoFacing = 0.2, FullFacing = 0.6;
constexpr double FullShare = 3.0; // neighbours' weights from which on a point counts in full

/// Adds residuals of a pair of bodies to the sums.
class Adder
{
public:
  Adder(FitSums& sums, std::vector<FitResidual>* residuals, const glm::dvec3& origin)
    : Sums(sums),
      Residuals(residuals),
      Origin(origin)
  {
  }

  /// slope of `mm` by a shift is `direction`, all in world axes.
  void Add(
    const glm::dvec3& place, const glm::dvec3& direction, double mm, double weight, bool face)
  {
    const glm::dvec3 turn = glm::cross(place - this->Origin, direction);
    const Vector6 j{ direction.x, direction.y, direction.z, turn.x, turn.y, turn.z };
    std::size_t entry = 0;
    for (std::size_t row = 0; row < 6; ++row)
    {
      this->Sums.pull[row] -= weight * mm * j[row];
      for (std::size_t column = row; column < 6; ++column)
        this->Sums.matrix[entry++] += weight * j[row] * j[column];
    }
    if (this->Residuals != nullptr)
      this->Residuals->push_back({ j, weight, mm, place, face });
  }

  /// All that one place sees, at once: residuals of one place share their arm.
  /// squares: sum of weight direction direction^T; pull: sum of weight mm direction; world axes.
  void AddOfOnePlace(const glm::dvec3& place, const glm::dmat3& squares, const glm::dvec3& pull)
  {
    const glm::dvec3 arm = place - this->Origin;
    const glm::dmat3 cross(0.0, arm.z, -arm.y, -arm.z, 0.0, arm.x, arm.y, -arm.x, 0.0);
    const glm::dmat3 turned = cross * squares, both = turned * glm::transpose(cross);
    const glm::dvec3 turn = glm::cross(arm, pull);
    for (int row = 0; row < 3; ++row)
    {
      this->Sums.pull[row] -= pull[row];
      this->Sums.pull[row + 3] -= turn[row];
      for (int column = 0; column < 3; ++column)
      {
        this->Sums.matrix[UpperIndex(row, column + 3)] += turned[row][column];
        if (column < row)
          continue;
        this->Sums.matrix[UpperIndex(row, column)] += squares[column][row];
        this->Sums.matrix[UpperIndex(row + 3, column + 3)] += both[column][row];
      }
    }
  }

  /// What was summed by AddOfOnePlace, one by one, for who wants it.
  bool KeepsResiduals() const { return this->Residuals != nullptr; }
  void Keep(const glm::dvec3& place, const glm::dvec3& direction, double mm, double weight)
  {
    const glm::dvec3 turn = glm::cross(place - this->Origin, direction);
    this->Residuals->push_back({ { direction.x, direction.y, direction.z, turn.x, turn.y, turn.z },
      weight, mm, place, false });
  }

  FitSums& Sums;

private:
  std::vector<FitResidual>* Residuals;
  glm::dvec3 Origin;
};

/// How far two surfaces look at each other, by the cosine between one's normal and the other's
/// turned round. All or nothing for most, so that it hardly changes as a body moves.
double Facing(double cosine)
{
  const double u = std::clamp((cosine - NoFacing) / (FullFacing - NoFacing), 0.0, 1.0);
  return u * u * (3.0 - 2.0 * u);
}

/// The weight that a face's point pulls with, and its share of the sums.
/// faces: the part of its area that looks at the other surface.
double FaceWeight(const FitLaw& law, double mm, double area, double faces, FitSums& sums)
{
  const double deepest = law.attraction * law.captureMm * law.captureMm / 6.0;
  if (mm < 0.0)
  {
    const double u = mm / law.penetrationMm;
    sums.energy +=
      0.5 * area * law.penetrationMm * law.penetrationMm * std::log1p(u * u) - faces * deepest;
    sums.contactMm2 += area;
    sums.deepestMm = std::min(sums.deepestMm, mm);
    return area / (1.0 + u * u);
  }
  const double u = mm / law.captureMm, well = 1.0 - u * u;
  const double share = faces * well * well;
  sums.energy -= share * well * deepest;
  sums.facesMm2 += share;
  sums.faceSquares += share * mm * mm;
  return law.attraction * share;
}

/// Points of one body before another's distances: those that can be within reach of the other.
/// count: as many of them are used. sign: 1 if the points' body is the moved one, -1 if the other
/// one is.
void AddFaces(Adder& adder, const PlacedBody& pointed, const PlacedBody& other, const FitLaw& law,
  std::size_t count, double sign, bool attracts)
{
  const double area = 0.5 * pointed.body->SurfaceArea() / double(count); // of two directions
  const double reach = attracts ? law.captureMm : 0.0;
  const RigidPose toOther = other.bodyInWorld.Inverse() * pointed.bodyInWorld;
  pointed.body->ForPointsNear(count, toOther.Inverse().position, other.body->RadiusMm() + reach,
    [&](const OrientedPoint& p)
    {
      const std::optional<FitBody::Foot> foot = other.body->FootOf(toOther.Place(p.place));
      if (!foot || foot->mm >= reach)
        return;
      const double faces =
        attracts ? area * Facing(-glm::dot(toOther.Turn(p.normal), foot->outward)) : 0.0;
      const double weight = FaceWeight(law, foot->mm, area, faces, adder.Sums);
      if (weight > 0.0)
        adder.Add(pointed.bodyInWorld.Place(p.place), sign * other.bodyInWorld.Turn(foot->outward),
          foot->mm, weight, true);
    });
}

/// Both directions; the standing body's points are as dense as the moved one's.
void AddBothFaces(Adder& adder, const PlacedBody& moved, const PlacedBody& standing,
  const FitLaw& law, std::size_t most, bool attracts)
{
  const std::size_t count = moved.body->Points(most).size();
  const double dense = double(count) / moved.body->SurfaceArea();
  const std::size_t theirs =
    standing.body->Points(std::size_t(1.5 * dense * standing.body->SurfaceArea())).size();
  AddFaces(adder, moved, standing, law, count, 1.0, attracts);
  AddFaces(adder, standing, moved, law, theirs, -1.0, attracts);
}

/// What a smooth point of the moved body sees of a standing body's surface, one place of it.
struct Continuation
{
  glm::dvec3 direction;
  double mm, weight;
};

/// Sums over all that one smooth point sees, in the partner's axes.
struct SeenSurface
{
  double shares = 0.0, energy = 0.0, area = 0.0, areaMm2 = 0.0; ///< of weights share, near, near^2
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
  glm::dvec3 pull{ 0.0 };

  /// Returns its weight.
  double Add(const glm::dvec3& d, double mm, double share, double scale2)
  {
    const double near = 1.0 / (1.0 + mm * mm / scale2), weight = share * near * near;
    this->shares += share;
    this->energy += share * near;
    this->area += weight;
    this->areaMm2 += weight * mm * mm;
    this->pull += weight * mm * d;
    this->xx += weight * d.x * d.x;
    this->xy += weight * d.x * d.y;
    this->xz += weight * d.x * d.z;
    this->yy += weight * d.y * d.y;
    this->yz += weight * d.y * d.z;
    this->zz += weight * d.z * d.z;
    return weight;
  }
  glm::dmat3 Squares() const
  {
    return { this->xx, this->xy, this->xz, this->xy, this->yy, this->yz, this->xz, this->yz,
      this->zz };
  }
};

/// The moved body's smooth points before a partner's.
void AddContinuity(Adder& adder, const PlacedBody& moved, const PlacedBody& partner,
  const FitLaw& law, std::size_t most)
{
  const SmoothPoints& theirs = partner.body->Smooth();
  const RigidPose toPartner = partner.bodyInWorld.Inverse() * moved.bodyInWorld;
  const glm::dmat3 turn = glm::mat3_cast(partner.bodyInWorld.orientation);
  const double reach2 = law.reachMm * law.reachMm, scale2 = law.continuityMm * law.continuityMm;
  std::vector<Continuation> kept;
  const std::span<const OrientedPoint> points = moved.body->Smooth().Points();
  const std::size_t step = points.size() / most + 1; // evenly: so are they
  for (std::size_t point = 0; point < points.size(); point += step)
  {
    const OrientedPoint& p = points[point];
    const glm::dvec3 place = toPartner.Place(p.place);
    const std::optional<FitBody::Foot> foot = partner.body->FootOf(place);
    if (!foot || foot->mm > law.reachMm)
      continue;
    const glm::dvec3 normal = toPartner.Turn(p.normal);
    kept.clear();
    SeenSurface seen;
    theirs.NearTo(place, law.reachMm,
      [&](std::uint32_t n)
      {
        const OrientedPoint& q = theirs.Points()[n];
        const glm::dvec3 way = place - q.place;
        const double share = 1.0 - glm::dot(way, way) / reach2;
        if (share <= 0.0 || glm::dot(q.normal, normal) < LeastAlike)
          return;
        const glm::dvec3 middle = glm::normalize(q.normal + normal);
        const double mm = glm::dot(way, middle), weight = seen.Add(middle, mm, share, scale2);
        if (adder.KeepsResiduals())
          kept.push_back({ middle, mm, weight });
      });
    if (!(seen.shares > 0.0))
      continue;
    const double area = double(step) * moved.body->Smooth().AreaOfPoint() *
                        std::min(1.0, seen.shares / FullShare) / std::max(seen.shares, 1e-12);
    const glm::dvec3 world = moved.bodyInWorld.Place(p.place);
    adder.Sums.energy -= 0.5 * law.continuity * area * scale2 * seen.energy;
    adder.Sums.continuedMm2 += area * seen.area;
    adder.Sums.continuedSquares += area * seen.areaMm2;
    const double pulled = law.continuity * area;
    adder.AddOfOnePlace(
      world, pulled * (turn * seen.Squares() * glm::transpose(turn)), pulled * (turn * seen.pull));
    for (const Continuation& c : kept)
      adder.Keep(world, turn * c.direction, c.mm, pulled * c.weight);
  }
}

/// Whether anything of the one can be within `mm` of the other.
bool MayMeet(const PlacedBody& a, const PlacedBody& b, double mm)
{
  return glm::length(a.bodyInWorld.position - b.bodyInWorld.position) <=
         a.body->RadiusMm() + b.body->RadiusMm() + mm;
}
} // namespace

FitSums& FitSums::operator+=(const FitSums& other) noexcept
{
  for (std::size_t n = 0; n < this->matrix.size(); ++n)
    this->matrix[n] += other.matrix[n];
  for (std::size_t n = 0; n < this->pull.size(); ++n)
    this->pull[n] += other.pull[n];
  this->energy += other.energy;
  this->facesMm2 += other.facesMm2;
  this->faceSquares += other.faceSquares;
  this->deepestMm = std::min(this->deepestMm, other.deepestMm);
  this->contactMm2 += other.contactMm2;
  this->continuedMm2 += other.continuedMm2;
  this->continuedSquares += other.continuedSquares;
  return *this;
}

FitSums SumFit(std::span<const PlacedBody> moved, const glm::dvec3& origin, const FitScene& scene,
  const FitLaw& law, std::size_t points, std::vector<FitResidual>* residuals)
{
  FitSums sums;
  Adder adder(sums, residuals, origin);
  for (const PlacedBody& body : moved)
  {
    for (const PlacedBody& other : scene.partners)
      if (MayMeet(body, other, std::max(law.captureMm, law.reachMm)))
      {
        AddBothFaces(adder, body, other, law, points, true);
        if (law.continuity > 0.0)
          AddContinuity(adder, body, other, law, points);
      }
    for (const PlacedBody& other : scene.obstacles)
      if (MayMeet(body, other, 0.0))
      {
        AddBothFaces(adder, body, other, law, points, false);
      }
  }
  return sums;
}

} // namespace hasp
