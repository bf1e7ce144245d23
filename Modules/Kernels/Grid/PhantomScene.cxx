#include "Grid/PhantomScene.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hasp
{
namespace
{

/// The normal distribution up to x, and its integral up to x.
double NormalShare(double x)
{
  return 0.5 * std::erfc(-x * glm::one_over_root_two<double>());
}
double NormalRamp(double x)
{
  return x * NormalShare(x) + std::exp(-0.5 * x * x) / glm::root_two_pi<double>();
}

} // namespace

SurfaceStep::SurfaceStep(const PhantomSettings& s)
  : blurred(s.sliceMm > 0.0 || s.blurMm != glm::dvec3(0.0)),
    edgeMm(s.edgeMm),
    blurMm(s.blurMm),
    sliceMm(s.sliceMm)
{
  // 5 sigma leave 3e-7 of a step out.
  this->reachMm = this->blurred
                    ? 5.0 * std::max({ s.blurMm.x, s.blurMm.y, s.blurMm.z }) + 0.5 * s.sliceMm
                    : 0.5 * s.edgeMm;
}

double SurfaceStep::operator()(double depth, const glm::dvec3& outward) const
{
  if (std::abs(depth) >= this->reachMm)
    return depth > 0.0 ? 1.0 : 0.0;
  if (!this->blurred)
  {
    const double t = 0.5 + depth / this->edgeMm;
    return t * t * (3.0 - 2.0 * t);
  }
  // Along the normal: a Gaussian of this sigma, and a box of this width.
  const double sigma = glm::length(this->blurMm * outward);
  const double width = this->sliceMm * std::abs(outward.z);
  if (width < 1e-3 * sigma || width < 1e-9)
    return sigma > 1e-9 ? NormalShare(depth / sigma) : (depth > 0.0 ? 1.0 : 0.0);
  if (sigma < 1e-3 * width)
    return std::clamp(0.5 + depth / width, 0.0, 1.0);
  return (sigma / width) *
         (NormalRamp((depth + 0.5 * width) / sigma) - NormalRamp((depth - 0.5 * width) / sigma));
}

PhantomScene::PhantomScene(const PhantomSettings& s) : step(s), base(s.airHU)
{
  const PhantomShapes shapes = MakePhantomShapes(s);
  const auto paint = [&](std::size_t solid, double insetMm, double value) {
    this->paints.push_back({ solid, insetMm, value });
  };
  for (const auto& [part, solid] : shapes.parts)
    this->solids.push_back(solid);
  const auto add = [&](const AnalyticSolid& solid)
  {
    this->solids.push_back(solid);
    return this->solids.size() - 1;
  };
  if (shapes.skin)
    paint(add(*shapes.skin), 0.0, s.softHU);
  for (std::size_t n = 0; n < shapes.parts.size(); ++n)
    paint(n, -s.scalpMm, s.softHU);
  if (shapes.airway)
    paint(add(*shapes.airway), 0.0, s.airHU);
  // Compact bone and what lies below it, jaws before their teeth.
  for (std::size_t n = 0; n < shapes.parts.size(); ++n)
    switch (shapes.parts[n].first)
    {
      case PhantomPart::Cranium:
        paint(n, 0.0, s.boneHU);
        paint(n, s.tableMm, s.diploeHU);
        break;
      case PhantomPart::Mandible:
        paint(n, 0.0, s.boneHU);
        paint(n, s.jawCortexMm, s.jawMarrowHU);
        break;
      case PhantomPart::Fibula:
        paint(n, 0.0, s.boneHU);
        if (shapes.canal)
          paint(add(*shapes.canal), 0.0, s.fibulaMarrowHU);
        break;
      default:
        break;
    }
  for (std::size_t n = 0; n < shapes.parts.size(); ++n)
    if (shapes.parts[n].first == PhantomPart::UpperTeeth ||
        shapes.parts[n].first == PhantomPart::LowerTeeth)
      paint(n, 0.0, s.dentineHU);
  if (shapes.enamel)
  {
    const std::size_t enamel = add(*shapes.enamel);
    paint(enamel, 0.0, s.enamelHU);
    paint(enamel, s.enamelMm, s.dentineHU);
  }
  for (const RoundConeShape& crown : shapes.metal)
    paint(add(crown), 0.0, s.metal.crownHU);
}

double PhantomScene::Value(const glm::dvec3& point) const
{
  std::array<Foot, 16> feet; // five parts, skin, airway, canal, enamel, two of metal
  for (std::size_t n = 0; n < this->solids.size(); ++n)
    feet[n] = this->solids[n].Bound(point);
  double value = this->base;
  for (const Paint& paint : this->paints)
  {
    const Foot& foot = feet[paint.solid];
    const double share = this->step(-foot.mm - paint.insetMm, foot.outward);
    value = share == 1.0 ? paint.value : value + share * (paint.value - value);
  }
  return value;
}

PhantomScene PhantomScene::Near(const glm::dvec3& center, double radius) const
{
  PhantomScene near = *this;
  near.solids.clear();
  near.paints.clear();
  std::vector<double> bounds;
  for (const AnalyticSolid& solid : this->solids)
    bounds.push_back(solid.Bound(center).mm);
  const double reach = radius + this->step.reachMm + 1e-9;
  for (const Paint& paint : this->paints)
  {
    const double depth = -bounds[paint.solid] - paint.insetMm;
    if (depth > reach)
    {
      near.paints.clear(); // all there is below is covered
      near.base = paint.value;
    }
    else if (depth > -reach)
      near.paints.push_back(paint);
  }
  std::vector<std::size_t> places(this->solids.size(), this->solids.size());
  for (Paint& paint : near.paints)
  {
    std::size_t& place = places[paint.solid];
    if (place == this->solids.size())
    {
      place = near.solids.size();
      near.solids.push_back(this->solids[paint.solid].Near(center, radius));
    }
    paint.solid = place;
  }
  return near;
}

} // namespace hasp
