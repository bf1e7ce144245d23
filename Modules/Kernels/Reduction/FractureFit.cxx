#include "Reduction/FractureFit.h"

#include "Grid/FinitePose.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double LongestStepMm = 1.0;
constexpr double SettledMm = 1e-3;
constexpr double NearlyMm = 0.02; // a stage before the last need not settle any better
constexpr double NarrowMm = 2.0;  // from here on all points count
constexpr double Narrower = 0.65; // a stage's capture, of that of the one before
constexpr double LastCoarseMm = 1.4;

void Check(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
    throw std::invalid_argument("fracture fit: " + std::string(name) + " is " +
                                std::to_string(value) + ", must be in [" + std::to_string(low) +
                                ", " + std::to_string(high) + "]");
}

/// A group before its scene, and the damped steps.
class Descent
{
public:
  Descent(std::span<const GroupBody> moved, const RigidPose& start, const FitScene& scene,
    const FitSettings& settings)
    : Moved(moved),
      Scene(scene),
      Settings(settings)
  {
    this->Fit.groupInWorld = start;
    for (const GroupBody& body : moved)
      this->RadiusMm =
        std::max(this->RadiusMm, glm::length(body.bodyInGroup.position) + body.body->RadiusMm());
  }

  FitSums SumsAt(const RigidPose& pose, const FitLaw& law, int points) const
  {
    std::vector<PlacedBody> placed;
    for (const GroupBody& body : this->Moved)
      placed.push_back({ body.body, pose * body.bodyInGroup });
    return SumFit(placed, pose.position, this->Scene, law, std::size_t(points));
  }

  /// Until steps become small, or there have been enough.
  void Settle(const FitLaw& law, int points, double smallMm = SettledMm)
  {
    FractureFit& fit = this->Fit;
    fit.settled = false;
    fit.sums = this->SumsAt(fit.groupInWorld, law, points);
    double damping = 1e-3;
    for (int n = 0; n < this->Settings.steps && !fit.settled; ++n)
    {
      Step step;
      if (!this->Solve(fit.sums, damping, step))
        break;
      ++fit.steps;
      const RigidPose next{ fit.groupInWorld.position + step.shift,
        glm::normalize(TurnBy(step.turn) * fit.groupInWorld.orientation) };
      const FitSums sums = this->SumsAt(next, law, points);
      if (sums.energy <= fit.sums.energy)
      {
        fit.groupInWorld = next;
        fit.sums = sums;
        damping = std::max(1e-6, 0.3 * damping);
      }
      else
        damping *= 5.0;
      fit.settled = step.mm < smallMm;
    }
    fit.touches = fit.sums.facesMm2 + fit.sums.contactMm2 > 0.0;
  }

  /// Stages from captureMm down to LastCoarseMm.
  void SettleCoarsely()
  {
    FitLaw law = this->Settings.law;
    law.attraction = std::max(1.0, law.attraction);
    law.penetrationMm = std::max(2.0, law.penetrationMm);
    const double finest = law.continuityMm;
    for (double capture = this->Settings.captureMm; capture > LastCoarseMm; capture *= Narrower)
    {
      law.captureMm = capture;
      law.continuityMm = std::max(0.5 * capture, finest);
      this->Settle(
        law, capture > NarrowMm ? this->Settings.coarsePoints : this->Settings.points, NearlyMm);
    }
  }

  FractureFit Fit;

private:
  struct Step
  {
    glm::dvec3 shift, turn;
    double mm;
  };

  bool Solve(const FitSums& sums, double damping, Step& step) const
  {
    Symmetric6 matrix = sums.matrix;
    const double mean =
      (matrix[UpperIndex(0, 0)] + matrix[UpperIndex(1, 1)] + matrix[UpperIndex(2, 2)]) / 3.0;
    if (!(mean > 0.0))
      return false;
    const double arm2 = 0.3 * this->RadiusMm * this->RadiusMm;
    for (std::size_t k = 0; k < 6; ++k)
      matrix[UpperIndex(k, k)] += damping * mean * (k < 3 ? 1.0 : arm2);
    Vector6 x;
    if (!Solve6(matrix, sums.pull, this->RadiusMm, x))
      return false;
    step.shift = { x[0], x[1], x[2] };
    step.turn = { x[3], x[4], x[5] };
    step.mm = glm::length(step.shift) + this->RadiusMm * glm::length(step.turn);
    if (step.mm > LongestStepMm)
    {
      step.shift *= LongestStepMm / step.mm;
      step.turn *= LongestStepMm / step.mm;
    }
    return true;
  }

  std::span<const GroupBody> Moved;
  const FitScene& Scene;
  const FitSettings& Settings;
  double RadiusMm = 0.0;
};

Descent BeginFit(std::span<const GroupBody> moved, const RigidPose& start, const FitScene& scene,
  const FitSettings& settings)
{
  CheckFitSettings(settings);
  if (moved.empty() || moved.size() > 1000)
    throw std::invalid_argument(
      "fracture fit: " + std::to_string(moved.size()) + " bodies are moved, must be 1 to 1000");
  bool good = IsFinite(start);
  for (const GroupBody& body : moved)
    good = good && body.body != nullptr && IsFinite(body.bodyInGroup);
  for (const auto* bodies : { &scene.partners, &scene.obstacles })
    for (const PlacedBody& body : *bodies)
      good = good && body.body != nullptr && IsFinite(body.bodyInWorld);
  if (!good)
    throw std::invalid_argument("fracture fit: a body is none, or a pose is not finite");
  return Descent(moved, start, scene, settings);
}
} // namespace

double FractureFit::FaceRmsMm() const
{
  return this->sums.facesMm2 > 0.0 ? std::sqrt(this->sums.faceSquares / this->sums.facesMm2) : 0.0;
}

double FractureFit::StepRmsMm() const
{
  return this->sums.continuedMm2 > 0.0
           ? std::sqrt(this->sums.continuedSquares / this->sums.continuedMm2)
           : 0.0;
}

void CheckFitSettings(const FitSettings& s)
{
  Check("captureMm", s.captureMm, 0.5, 20.0);
  Check("coarsePoints", s.coarsePoints, 64, 1e6);
  Check("points", s.points, 64, 1e6);
  Check("steps", s.steps, 1, 1000);
  Check("law.captureMm", s.law.captureMm, 1e-3, 20.0);
  Check("law.attraction", s.law.attraction, 1e-6, 1e3);
  Check("law.penetrationMm", s.law.penetrationMm, 1e-3, 20.0);
  Check("law.continuity", s.law.continuity, 0.0, 1e3);
  Check("law.continuityMm", s.law.continuityMm, 1e-3, 20.0);
  Check("law.reachMm", s.law.reachMm, 1e-3, 50.0);
}

FractureFit FitCoarsely(std::span<const GroupBody> moved, const RigidPose& start,
  const FitScene& scene, const FitSettings& settings)
{
  Descent descent = BeginFit(moved, start, scene, settings);
  descent.SettleCoarsely();
  return descent.Fit;
}

FractureFit RefineFit(std::span<const GroupBody> moved, const FractureFit& coarse,
  const FitScene& scene, const FitSettings& settings)
{
  Descent descent = BeginFit(moved, coarse.groupInWorld, scene, settings);
  descent.Fit.steps = coarse.steps;
  // Half way first: faces that were just caught are not lost again.
  FitLaw law = settings.law;
  law.captureMm = std::max(1.5, law.captureMm);
  law.penetrationMm = std::max(1.0, law.penetrationMm);
  descent.Settle(law, settings.points, NearlyMm);
  descent.Settle(settings.law, settings.points);
  return descent.Fit;
}

FractureFit FitFracture(std::span<const GroupBody> moved, const RigidPose& start,
  const FitScene& scene, const FitSettings& settings)
{
  return RefineFit(moved, FitCoarsely(moved, start, scene, settings), scene, settings);
}

double RmsWay(std::span<const GroupBody> moved, const RigidPose& from, const RigidPose& to)
{
  double squares = 0.0, area = 0.0;
  for (const GroupBody& body : moved)
  {
    const RigidPose a = from * body.bodyInGroup, b = to * body.bodyInGroup;
    const glm::dvec3 middle = a.Place(body.body->Centroid()) - b.Place(body.body->Centroid());
    const glm::dmat3 difference = glm::mat3_cast(a.orientation) - glm::mat3_cast(b.orientation);
    // The mean of |m + D (p - c)|^2 over the surface: the mixed term is 0 about the centroid.
    const glm::dmat3 turned = difference * body.body->Spread() * glm::transpose(difference);
    const double mean = glm::dot(middle, middle) + turned[0][0] + turned[1][1] + turned[2][2];
    squares += body.body->SurfaceArea() * mean;
    area += body.body->SurfaceArea();
  }
  return area > 0.0 ? std::sqrt(std::max(0.0, squares) / area) : 0.0;
}

} // namespace hasp
