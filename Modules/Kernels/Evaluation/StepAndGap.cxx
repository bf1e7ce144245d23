#include "Evaluation/StepAndGap.h"

#include "Evaluation/AreaShares.h"
#include "Grid/FinitePose.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

namespace
{

class Figures
{
public:
  void Add(double mm, double weight, const glm::dvec3& at)
  {
    this->Shares.Add(mm, weight);
    this->SizeShares.Add(std::abs(mm), weight);
    this->Sum += weight * mm;
    this->Sizes += weight * std::abs(mm);
    if (this->Made.samples++ == 0 || std::abs(mm) > this->Made.maxAbsMm)
    {
      this->Made.maxAbsMm = std::abs(mm);
      this->Made.maxAt = at;
    }
  }
  FractureFigures Result()
  {
    FractureFigures made = this->Made;
    if (this->Shares.Empty())
      return made;
    this->Shares.Sort();
    made.areaMm2 = this->Shares.Area();
    made.meanMm = this->Sum / made.areaMm2;
    made.meanAbsMm = this->Sizes / made.areaMm2;
    made.p5Mm = this->Shares.Below(0.05);
    made.p50Mm = this->Shares.Below(0.5);
    made.p95Mm = this->Shares.Below(0.95);
    this->SizeShares.Sort();
    made.p50AbsMm = this->SizeShares.Below(0.5);
    made.p95AbsMm = this->SizeShares.Below(0.95);
    return made;
  }

private:
  AreaShares Shares, SizeShares;
  FractureFigures Made;
  double Sum = 0.0, Sizes = 0.0;
};

void Validate(const StepAndGapSettings& s)
{
  const auto refuse = [](const char* name, double value, const char* range)
  {
    throw std::invalid_argument(std::string("step and gap: ") + name + " is " +
                                std::to_string(value) + ", must be in " + range);
  };
  if (!(s.reachMm > 0.0 && s.reachMm <= 50.0))
    refuse("reachMm", s.reachMm, "(0, 50]");
  if (!(s.rimMm > 0.0 && s.rimMm <= 20.0))
    refuse("rimMm", s.rimMm, "(0, 20]");
  if (!(s.facing > 0.0 && s.facing < 1.0))
    refuse("facing", s.facing, "(0, 1)");
}

/// The first fragment's samples against the second, both in the second's own place.
class Across
{
public:
  Across(const MeasuredSurface& first, const MeasuredSurface& second,
    const RigidPose& firstToSecond, const StepAndGapSettings& settings)
    : First(first),
      Second(second),
      Pose(firstToSecond),
      Settings(settings)
  {
  }

  std::vector<std::optional<double>> Gaps() const
  {
    return this->Each([this](std::size_t n) { return this->Gap(n); });
  }
  /// Of samples that have no gap.
  std::vector<std::optional<double>> Steps(const std::vector<std::optional<double>>& gaps) const
  {
    TriangleMesh faces; // each sample a triangle that is a point
    std::vector<std::size_t> samples;
    for (std::size_t n = 0; n < gaps.size(); ++n)
      if (gaps[n])
      {
        faces.triangles.emplace_back(std::uint32_t(samples.size()));
        faces.points.push_back(this->Pose.Place(this->First.Samples()[n].point));
        samples.push_back(n);
      }
    const TriangleTree tree(faces);
    return this->Each(
      [&](std::size_t n) -> std::optional<double>
      {
        const auto face = gaps[n] ? std::nullopt : tree.Nearest(this->At(n), this->Settings.rimMm);
        if (!face)
          return std::nullopt;
        const std::size_t of = samples[face->triangle];
        return this->Step(n, of, *gaps[of]);
      });
  }

private:
  glm::dvec3 At(std::size_t n) const { return this->Pose.Place(this->First.Samples()[n].point); }
  glm::dvec3 Normal(std::size_t n) const
  {
    return this->Pose.Turn(this->First.Samples()[n].normal);
  }

  template <typename Measure>
  std::vector<std::optional<double>> Each(const Measure& measure) const
  {
    std::vector<std::optional<double>> found(this->First.Samples().size());
    ParallelFor(0, std::int64_t(found.size()), 256,
      [&](std::int64_t from, std::int64_t to)
      {
        for (auto n = std::size_t(from); n < std::size_t(to); ++n)
          found[n] = measure(n);
      });
    return found;
  }

  std::optional<double> Gap(std::size_t n) const
  {
    const glm::dvec3 at = this->At(n), normal = this->Normal(n);
    const double reach = this->Settings.reachMm, least = -this->Settings.facing;
    const auto near = this->Second.Tree().Nearest(at, reach);
    if (!near || !(glm::dot(near->normal, normal) < least))
      return std::nullopt;
    // A closed solid is left through a face that looks along the ray, and entered against it: of
    // the two ways one alone meets the other face first. Faces that touch may be a rounding apart.
    constexpr double touching = 1e-6;
    for (const double way : { 1.0, -1.0 })
      if (const auto hit = this->Second.Tree().First(at, way * normal, -touching, reach);
          hit && glm::dot(hit->normal, normal) < least)
        return way * hit->t;
    return std::nullopt;
  }

  std::optional<double> Step(std::size_t n, std::size_t face, double gap) const
  {
    const glm::dvec3 at = this->At(n), outward = this->Normal(n), faced = this->Normal(face);
    const glm::dvec3 along = faced - glm::dot(faced, outward) * outward;
    if (!(glm::length(along) > this->Settings.facing)) // the surface turns into the face
      return std::nullopt;
    const glm::dvec3 across = glm::normalize(along);
    const double inset = glm::dot(this->At(face) - at, across);
    if (!(inset > 0.0)) // beyond the line
      return std::nullopt;
    const glm::dvec3 over = at + (2.0 * inset + gap) * across + this->Settings.reachMm * outward;
    const auto hit = this->Second.Tree().First(over, -outward, 0.0, 2.0 * this->Settings.reachMm);
    if (!hit || !(glm::dot(hit->normal, outward) > this->Settings.facing))
      return std::nullopt;
    const glm::dvec3 opposite = over - hit->t * outward;
    return glm::dot(opposite - at, glm::normalize(outward + hit->normal));
  }

  const MeasuredSurface &First, &Second;
  RigidPose Pose;
  StepAndGapSettings Settings;
};

bool IsUnit(const glm::dvec3& v)
{
  return std::abs(glm::length(v) - 1.0) <= 1e-6;
}

void Check(std::span<const FacePair> pairs)
{
  if (pairs.empty())
    throw std::invalid_argument("step and gap: there are no pairs; one at least is needed");
  for (const FacePair& p : pairs)
    if (!IsFinite(p.first) || !IsFinite(p.second) || !(p.weight > 0.0) ||
        !std::isfinite(p.weight) || !IsUnit(p.normal) ||
        !(IsUnit(p.outward) || p.outward == glm::dvec3(0.0)))
      throw std::invalid_argument(
        "step and gap: a pair's places must be finite, its weight (here " +
        std::to_string(p.weight) + ") above 0, its directions of length 1");
}

} // namespace

StepAndGap MeasureStepAndGap(const MeasuredSurface& first, const RigidPose& firstToWorld,
  const MeasuredSurface& second, const RigidPose& secondToWorld, const StepAndGapSettings& settings)
{
  Validate(settings);
  const RigidPose a = CheckedPose(firstToWorld, "firstToWorld"),
                  b = CheckedPose(secondToWorld, "secondToWorld");
  const Across across(first, second, b.Inverse() * a, settings);
  const auto gaps = across.Gaps(), steps = across.Steps(gaps);
  Figures gap, step;
  for (std::size_t n = 0; n < gaps.size(); ++n)
  {
    const MeshSample& sample = first.Samples()[n];
    if (gaps[n])
      gap.Add(*gaps[n], sample.areaMm2, a.Place(sample.point));
    if (steps[n])
      step.Add(*steps[n], sample.areaMm2, a.Place(sample.point));
  }
  return { gap.Result(), step.Result() };
}

TrueStepAndGap MeasureTrueStepAndGap(
  std::span<const FacePair> pairs, const RigidPose& firstToWorld, const RigidPose& secondToWorld)
{
  Check(pairs);
  const RigidPose a = CheckedPose(firstToWorld, "firstToWorld"),
                  b = CheckedPose(secondToWorld, "secondToWorld");
  Figures gap, step, slide;
  for (const FacePair& p : pairs)
  {
    const glm::dvec3 at = a.Place(p.first), apart = b.Place(p.second) - at,
                     normal = a.Turn(p.normal);
    const double along = glm::dot(apart, normal);
    gap.Add(along, p.weight, at);
    slide.Add(glm::length(apart - along * normal), p.weight, at);
    if (p.outward != glm::dvec3(0.0))
      step.Add(glm::dot(apart, a.Turn(p.outward)), p.weight, at);
  }
  return { gap.Result(), step.Result(), slide.Result() };
}

} // namespace hasp
