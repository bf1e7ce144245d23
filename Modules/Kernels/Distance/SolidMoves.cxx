#include "Distance/SolidMoves.h"

#include "SolidChecks.h"

#include <glm/gtc/quaternion.hpp>

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;
using Box = ImplicitSolid::Box;

class Moved : public ImplicitSolid
{
public:
  Moved(SolidPointer part, const glm::dvec3& shift, const glm::dmat3& axes)
    : Part(std::move(part)),
      Shift(shift),
      Axes(axes)
  {
  }
  double At(const glm::dvec3& x) const noexcept override { return this->Part->At(this->Back(x)); }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    return this->Turned(this->Part->SampleAt(this->Back(x)));
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return this->Turned(this->Part->FaceAt(face, this->Back(x)));
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override
  {
    if (this->Axes != glm::dmat3(1.0))
      return {};
    const Box box = this->Part->Bounds();
    return { box.low + this->Shift, box.high + this->Shift };
  }
  double Steepness() const noexcept override { return this->Part->Steepness(); }

private:
  glm::dvec3 Back(const glm::dvec3& x) const { return (x - this->Shift) * this->Axes; }
  Sample Turned(Sample s) const
  {
    s.gradient = this->Axes * s.gradient;
    return s;
  }

  SolidPointer Part;
  glm::dvec3 Shift;
  glm::dmat3 Axes;
};
} // namespace

SolidPointer MakeMoved(SolidPointer part, const RigidPose& pose)
{
  RequirePart("moved solid", part);
  RequireFinite("moved solid", "position", pose.position);
  const double length = glm::length(pose.orientation);
  if (!(std::abs(length - 1.0) <= 1e-6))
    throw std::invalid_argument("moved solid: the orientation has length " + SolidNumber(length) +
                                "; it must be 1 within 1e-6");
  return std::make_shared<Moved>(
    std::move(part), pose.position, glm::mat3_cast(pose.orientation / length));
}

} // namespace hasp
