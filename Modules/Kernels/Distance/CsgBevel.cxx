#include "Distance/Csg.h"

#include "SolidChecks.h"

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;
using Box = ImplicitSolid::Box;

class BevelledIntersection : public ImplicitSolid
{
public:
  BevelledIntersection(SolidPointer a, SolidPointer b, double mm)
    : A(std::move(a)),
      B(std::move(b)),
      Mm(mm),
      FacesOfA(this->A->Faces()),
      FacesOfB(this->B->Faces()),
      AllFaces(CheckedFaceCount(
        "bevelled intersection", (this->FacesOfA + 1.0) * (this->FacesOfB + 1.0) - 1.0))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const double a = this->A->At(x), b = this->B->At(x);
    return std::max({ a, b, this->Bevel(a, b) });
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const Sample a = this->A->SampleAt(x), b = this->B->SampleAt(x);
    const double most = std::max({ a.value, b.value, this->Bevel(a.value, b.value) });
    Sample s = a.value >= most - SolidTieMm   ? a
               : b.value >= most - SolidTieMm ? this->OfB(b)
                                              : this->Between(a, b);
    s.value = most;
    return s;
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    if (face < this->FacesOfA)
      return this->A->FaceAt(face, x);
    face -= this->FacesOfA;
    if (face < this->FacesOfB)
      return this->OfB(this->B->FaceAt(face, x));
    face -= this->FacesOfB;
    return this->Between(
      this->A->FaceAt(face / this->FacesOfB, x), this->B->FaceAt(face % this->FacesOfB, x));
  }
  std::uint32_t Faces() const noexcept override { return this->AllFaces; }
  Box Bounds() const noexcept override
  {
    const Box a = this->A->Bounds(), b = this->B->Bounds();
    return { glm::max(a.low, b.low), glm::min(a.high, b.high) };
  }
  double Steepness() const noexcept override
  {
    return std::max(this->A->Steepness(), this->B->Steepness());
  }

private:
  double Bevel(double a, double b) const noexcept { return 0.5 * (a + b + this->Mm); }
  Sample OfB(Sample b) const noexcept
  {
    b.face += this->FacesOfA;
    return b;
  }
  Sample Between(const Sample& a, const Sample& b) const noexcept
  {
    return { this->Bevel(a.value, b.value), 0.5 * (a.gradient + b.gradient),
      this->FacesOfA + this->FacesOfB + a.face * this->FacesOfB + b.face };
  }

  SolidPointer A, B;
  double Mm;
  std::uint32_t FacesOfA, FacesOfB, AllFaces;
};
} // namespace

SolidPointer MakeBevelledIntersection(SolidPointer a, SolidPointer b, double bevelMm)
{
  RequirePart("bevelled intersection", a);
  RequirePart("bevelled intersection", b);
  RequirePositive("bevelled intersection", "bevel", bevelMm);
  return std::make_shared<BevelledIntersection>(std::move(a), std::move(b), bevelMm);
}

} // namespace hasp
