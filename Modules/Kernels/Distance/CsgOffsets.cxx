#include "Distance/Csg.h"

#include "SolidChecks.h"

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;
using Box = ImplicitSolid::Box;

class Offset : public ImplicitSolid
{
public:
  Offset(SolidPointer part, double mm) : Part(std::move(part)), Mm(mm) {}
  double At(const glm::dvec3& x) const noexcept override { return this->Part->At(x) - this->Mm; }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    Sample s = this->Part->SampleAt(x);
    s.value -= this->Mm;
    return s;
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    Sample s = this->Part->FaceAt(face, x);
    s.value -= this->Mm;
    return s;
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override
  {
    const Box box = this->Part->Bounds();
    return { box.low - this->Mm, box.high + this->Mm };
  }
  double Steepness() const noexcept override { return this->Part->Steepness(); }

private:
  SolidPointer Part;
  double Mm;
};

class Shell : public ImplicitSolid
{
public:
  Shell(SolidPointer part, double from, double to)
    : Part(std::move(part)),
      From(from),
      To(to),
      AllFaces(CheckedFaceCount("shell", 2.0 * this->Part->Faces()))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const double value = this->Part->At(x);
    return std::max(value - this->To, this->From - value);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const Sample s = this->Part->SampleAt(x);
    const bool inner = s.value - this->To < this->From - s.value - SolidTieMm;
    Sample wall = this->Wall(s, inner);
    wall.value = std::max(s.value - this->To, this->From - s.value);
    return wall;
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const std::uint32_t faces = this->Part->Faces();
    const bool inner = face >= faces;
    return this->Wall(this->Part->FaceAt(inner ? face - faces : face, x), inner);
  }
  std::uint32_t Faces() const noexcept override { return this->AllFaces; }
  Box Bounds() const noexcept override
  {
    const Box box = this->Part->Bounds();
    return { box.low - this->To, box.high + this->To };
  }
  double Steepness() const noexcept override { return this->Part->Steepness(); }

private:
  Sample Wall(const Sample& s, bool inner) const noexcept
  {
    if (inner)
      return { this->From - s.value, -s.gradient, s.face + this->Part->Faces() };
    return { s.value - this->To, s.gradient, s.face };
  }

  SolidPointer Part;
  double From, To;
  std::uint32_t AllFaces;
};

class SmoothUnion : public ImplicitSolid
{
public:
  SmoothUnion(SolidPointer a, SolidPointer b, double radius)
    : A(std::move(a)),
      B(std::move(b)),
      BoxOfA(this->A->Bounds()),
      BoxOfB(this->B->Bounds()),
      Radius(radius),
      FacesOfA(this->A->Faces()),
      FacesOfB(this->B->Faces()),
      AllFaces(
        CheckedFaceCount("smooth union", (this->FacesOfA + 1.0) * (this->FacesOfB + 1.0) - 1.0))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const double outOfA = this->BoxOfA.Excess(x), outOfB = this->BoxOfB.Excess(x);
    const bool aFirst = outOfA <= outOfB;
    const double near = (aFirst ? this->A : this->B)->At(x);
    if (this->IsFar(aFirst ? outOfB : outOfA, near))
      return near;
    const double other = (aFirst ? this->B : this->A)->At(x), h = this->Blend(near, other);
    return std::min(near, other) - 0.25 * h * h * this->Radius;
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const double outOfA = this->BoxOfA.Excess(x), outOfB = this->BoxOfB.Excess(x);
    if (outOfA <= outOfB)
    {
      const Sample a = this->A->SampleAt(x);
      return this->IsFar(outOfB, a.value) ? a : this->Joined(a, this->B->SampleAt(x));
    }
    const Sample b = this->B->SampleAt(x);
    return this->IsFar(outOfA, b.value) ? this->OfB(b) : this->Joined(this->A->SampleAt(x), b);
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    if (face < this->FacesOfA)
      return this->A->FaceAt(face, x);
    face -= this->FacesOfA;
    if (face < this->FacesOfB)
      return this->OfB(this->B->FaceAt(face, x));
    face -= this->FacesOfB;
    return this->Fillet(
      this->A->FaceAt(face / this->FacesOfB, x), this->B->FaceAt(face % this->FacesOfB, x));
  }
  std::uint32_t Faces() const noexcept override { return this->AllFaces; }
  Box Bounds() const noexcept override
  {
    const double more = 0.25 * this->Radius;
    return { glm::min(this->BoxOfA.low, this->BoxOfB.low) - more,
      glm::max(this->BoxOfA.high, this->BoxOfB.high) + more };
  }
  double Steepness() const noexcept override
  {
    return std::max(this->A->Steepness(), this->B->Steepness());
  }

private:
  double Blend(double a, double b) const noexcept
  {
    return std::max(0.0, 1.0 - std::abs(a - b) / this->Radius);
  }
  bool IsFar(double excess, double near) const noexcept
  {
    return excess > near + this->Radius + SolidTieMm;
  }
  Sample Joined(const Sample& a, const Sample& b) const noexcept
  {
    if (this->Blend(a.value, b.value) > 0.0)
      return this->Fillet(a, b);
    return a.value <= b.value ? a : this->OfB(b);
  }
  Sample OfB(Sample b) const noexcept
  {
    b.face += this->FacesOfA;
    return b;
  }
  Sample Fillet(const Sample& a, const Sample& b) const noexcept
  {
    // The gradient is a mean of both, weighted, so that the value is no steeper than they are.
    const double h = this->Blend(a.value, b.value), other = 0.5 * h;
    const double share = a.value <= b.value ? other : 1.0 - other;
    return { std::min(a.value, b.value) - 0.25 * h * h * this->Radius,
      glm::mix(a.gradient, b.gradient, share),
      this->FacesOfA + this->FacesOfB + a.face * this->FacesOfB + b.face };
  }

  SolidPointer A, B;
  Box BoxOfA, BoxOfB;
  double Radius;
  std::uint32_t FacesOfA, FacesOfB, AllFaces;
};
/// Everything but the part.
class Complement : public ImplicitSolid
{
public:
  explicit Complement(SolidPointer part) : Part(std::move(part)) {}
  double At(const glm::dvec3& x) const noexcept override { return -this->Part->At(x); }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    return Turned(this->Part->SampleAt(x));
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return Turned(this->Part->FaceAt(face, x));
  }
  std::uint32_t Faces() const noexcept override { return this->Part->Faces(); }
  Box Bounds() const noexcept override { return {}; }
  double Steepness() const noexcept override { return this->Part->Steepness(); }

  static Sample Turned(const Sample& s) noexcept { return { -s.value, -s.gradient, s.face }; }

private:
  SolidPointer Part;
};

/// Everything but the smooth union of the complements.
class SmoothIntersection : public ImplicitSolid
{
public:
  SmoothIntersection(const SolidPointer& a, const SolidPointer& b, double radius)
    : Rest(std::make_shared<Complement>(a), std::make_shared<Complement>(b), radius)
  {
    const Box boxOfA = a->Bounds(), boxOfB = b->Bounds();
    this->Hull = { glm::max(boxOfA.low, boxOfB.low), glm::min(boxOfA.high, boxOfB.high) };
  }
  double At(const glm::dvec3& x) const noexcept override { return -this->Rest.At(x); }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    return Complement::Turned(this->Rest.SampleAt(x));
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return Complement::Turned(this->Rest.FaceAt(face, x));
  }
  std::uint32_t Faces() const noexcept override { return this->Rest.Faces(); }
  Box Bounds() const noexcept override { return this->Hull; }
  double Steepness() const noexcept override { return this->Rest.Steepness(); }

private:
  SmoothUnion Rest;
  Box Hull;
};
} // namespace

SolidPointer MakeOffset(SolidPointer part, double mm)
{
  RequirePart("offset", part);
  RequireFinite("offset", "distance", mm);
  return std::make_shared<Offset>(std::move(part), mm);
}

SolidPointer MakeShell(SolidPointer part, double fromMm, double toMm)
{
  RequirePart("shell", part);
  RequireFinite("shell", "from", fromMm);
  RequireFinite("shell", "to", toMm);
  if (!(fromMm < toMm))
    throw std::invalid_argument("shell: from " + SolidNumber(fromMm) + " mm to " +
                                SolidNumber(toMm) + " mm is no wall; from must be below to");
  return std::make_shared<Shell>(std::move(part), fromMm, toMm);
}

SolidPointer MakeSmoothUnion(SolidPointer a, SolidPointer b, double radiusMm)
{
  RequirePart("smooth union", a);
  RequirePart("smooth union", b);
  RequirePositive("smooth union", "radius", radiusMm);
  return std::make_shared<SmoothUnion>(std::move(a), std::move(b), radiusMm);
}

SolidPointer MakeSmoothIntersection(SolidPointer a, SolidPointer b, double radiusMm)
{
  RequirePart("smooth intersection", a);
  RequirePart("smooth intersection", b);
  RequirePositive("smooth intersection", "radius", radiusMm);
  return std::make_shared<SmoothIntersection>(a, b, radiusMm);
}

} // namespace hasp
