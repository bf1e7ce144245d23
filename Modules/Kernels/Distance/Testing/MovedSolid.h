#pragma once
#include "Distance/ImplicitSolid.h"

#include <utility>

namespace hasp
{

/// A solid made larger about 0, then moved.
class MovedSolid final : public ImplicitSolid
{
public:
  MovedSolid(SolidPointer part, double scale, const glm::dvec3& shift)
    : Part(std::move(part)),
      Scale(scale),
      Shift(shift)
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
    return { this->Scale * part.low + this->Shift, this->Scale * part.high + this->Shift };
  }
  double Steepness() const noexcept override { return this->Part->Steepness(); }

private:
  glm::dvec3 Back(const glm::dvec3& world) const { return (world - this->Shift) / this->Scale; }
  Sample Larger(Sample sample) const
  {
    sample.value *= this->Scale;
    return sample;
  }

  SolidPointer Part;
  double Scale;
  glm::dvec3 Shift;
};

} // namespace hasp
