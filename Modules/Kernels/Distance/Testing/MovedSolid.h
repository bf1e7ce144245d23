#pragma once
#include "Distance/ImplicitSolid.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <utility>

namespace hasp
{

/// A solid made larger and turned about 0, then moved.
class MovedSolid final : public ImplicitSolid
{
public:
  MovedSolid(SolidPointer part, double scale, const glm::dvec3& shift,
    const glm::dmat3& axes = glm::dmat3(1.0))
    : Part(std::move(part)),
      Scale(scale),
      Shift(shift),
      Axes(axes)
  {
  }
  double At(const glm::dvec3& world) const noexcept override
  {
    return this->Scale * this->Part->At(this->Back(world));
  }
  Sample SampleAt(const glm::dvec3& world) const noexcept override
  {
    return this->Larger(this->Part->SampleAt(this->Back(world)));
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& world) const noexcept override
  {
    return this->Larger(this->Part->FaceAt(face, this->Back(world)));
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override
  {
    const Box part = this->Part->Bounds();
    if (this->Axes == glm::dmat3(1.0))
      return { this->Scale * part.low + this->Shift, this->Scale * part.high + this->Shift };
    const glm::dvec3 most = glm::max(glm::abs(part.low), glm::abs(part.high));
    const double reach = this->Scale * glm::length(most); // of a ball about 0 that holds it
    return { this->Shift - reach, this->Shift + reach };
  }
  double Steepness() const noexcept override { return this->Part->Steepness(); }

private:
  glm::dvec3 Back(const glm::dvec3& world) const
  {
    return (world - this->Shift) * this->Axes / this->Scale;
  }
  Sample Larger(Sample sample) const
  {
    sample.value *= this->Scale;
    sample.gradient = this->Axes * sample.gradient;
    return sample;
  }

  SolidPointer Part;
  double Scale;
  glm::dvec3 Shift;
  glm::dmat3 Axes;
};

} // namespace hasp
