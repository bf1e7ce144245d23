#include "BrushTrail.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace hasp
{

void BrushTrail::Begin()
{
  this->Strokes.clear();
  this->Pixel.reset();
  this->Latest.reset();
}

void BrushTrail::SetBrush(std::uint16_t label, double radiusMm)
{
  if (this->Label == label && this->RadiusMm == radiusMm)
    return;
  const std::optional<glm::dvec3> from = this->Latest;
  this->Close();
  this->Label = label;
  this->RadiusMm = radiusMm;
  if (from) // it is held there
  {
    this->Strokes.push_back({ label, radiusMm, { *from } });
    this->Latest = from;
  }
}

bool BrushTrail::MoveTo(const glm::ivec2& pixel, const Finder& find)
{
  const glm::ivec2 from = this->Pixel.value_or(pixel);
  const glm::ivec2 way = pixel - from;
  const int steps = std::max(std::abs(way.x), std::abs(way.y));
  bool grown = false;
  for (int n = this->Pixel ? 1 : 0; n <= steps; ++n)
  {
    const glm::dvec2 along = glm::dvec2(way) * (steps > 0 ? double(n) / steps : 0.0);
    const auto place = find(from + glm::ivec2(glm::round(along)));
    grown = (place ? this->Take(*place) : this->Close()) || grown;
  }
  this->Pixel = pixel;
  return grown;
}

bool BrushTrail::Take(const PixelPlace& place)
{
  bool grown = false;
  const double jump = std::max(this->RadiusMm, JumpPixels * place.pixelMm);
  if (this->Latest && glm::length(place.world - *this->Latest) > jump)
    grown = this->Close();
  if (!this->Latest)
  {
    this->Strokes.push_back({ this->Label, this->RadiusMm, {} });
    this->Add(place.world);
    grown = true;
  }
  else if (glm::length(place.world - this->Strokes.back().points.back()) >=
           SpacingRadii * this->RadiusMm)
  {
    this->Add(place.world);
    grown = true;
  }
  this->Latest = place.world;
  return grown;
}

void BrushTrail::Add(const glm::dvec3& point)
{
  if (this->Strokes.back().points.size() >= MostPoints)
  {
    const glm::dvec3 end = this->Strokes.back().points.back();
    this->Strokes.push_back({ this->Label, this->RadiusMm, { end } });
  }
  this->Strokes.back().points.push_back(point);
}

bool BrushTrail::Close()
{
  const std::optional<glm::dvec3> last = std::exchange(this->Latest, std::nullopt);
  if (!last || *last == this->Strokes.back().points.back())
    return false;
  this->Add(*last);
  return true;
}

void BrushTrail::Break()
{
  this->Close();
  this->Pixel.reset();
}

bool BrushTrail::End()
{
  this->Pixel.reset();
  return this->Close();
}

std::size_t BrushTrail::Points() const
{
  std::size_t points = 0;
  for (const BrushStroke& stroke : this->Strokes)
    points += stroke.points.size();
  return points;
}

} // namespace hasp
