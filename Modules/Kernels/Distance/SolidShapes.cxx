#include "Distance/SolidShapes.h"

#include "Distance/Csg.h"
#include "Distance/ImplicitShapes.h"
#include "SolidChecks.h"

#include <glm/trigonometric.hpp>

#include <array>

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;
using Box = ImplicitSolid::Box;

/// The unit vector along v; 0 if v is.
glm::dvec3 Along(const glm::dvec3& v, double length)
{
  return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// Of {x: dot(x - point, normal) <= reach}, `normal` unit: it ends along an axis that it stands on.
Box HalfSpaceBounds(const glm::dvec3& point, const glm::dvec3& normal, double reach)
{
  Box box;
  for (int a = 0; a < 3; ++a)
    if (normal[a] == 1.0)
      box.high[a] = point[a] + reach;
    else if (normal[a] == -1.0)
      box.low[a] = point[a] - reach;
  return box;
}

class Plane : public ImplicitSolid
{
public:
  Plane(const glm::dvec3& point, const glm::dvec3& normal) : Point(point), Normal(normal) {}
  double At(const glm::dvec3& x) const noexcept override
  {
    return PlaneSide(x, this->Point, this->Normal);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    return { this->At(x), this->Normal, 0 };
  }
  Sample FaceAt(std::uint32_t, const glm::dvec3& x) const noexcept override
  {
    return this->SampleAt(x);
  }
  std::uint32_t Faces() const noexcept override { return 1; }
  Box Bounds() const noexcept override { return HalfSpaceBounds(this->Point, this->Normal, 0.0); }

private:
  glm::dvec3 Point, Normal;
};

class Slab : public ImplicitSolid
{
public:
  Slab(const glm::dvec3& point, const glm::dvec3& normal, double width)
    : Point(point),
      Normal(normal),
      Width(width)
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    return SlabDistance(x, this->Point, this->Normal, this->Width);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    return this->FaceAt(PlaneSide(x, this->Point, this->Normal) >= -0.5 * SolidTieMm ? 0 : 1, x);
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const glm::dvec3 out = face == 0 ? this->Normal : -this->Normal;
    return { PlaneSide(x, this->Point, out) - 0.5 * this->Width, out, face };
  }
  std::uint32_t Faces() const noexcept override { return 2; }
  Box Bounds() const noexcept override
  {
    const Box up = HalfSpaceBounds(this->Point, this->Normal, 0.5 * this->Width);
    const Box down = HalfSpaceBounds(this->Point, -this->Normal, 0.5 * this->Width);
    return { glm::max(up.low, down.low), glm::min(up.high, down.high) };
  }

private:
  glm::dvec3 Point, Normal;
  double Width;
};

/// Face = which of low (0), within (1) and high (2) along each axis, in base 3, x lowest. What is
/// within along all three is no face, so those above it count one less.
class BoxSolid : public ImplicitSolid
{
public:
  BoxSolid(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half)
    : Center(center),
      Axes(axes),
      Half(half)
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    return BoxDistance(x, this->Center, this->Axes, this->Half);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const glm::dvec3 p = (x - this->Center) * this->Axes, out = glm::abs(p) - this->Half;
    std::array<int, 3> side{ 1, 1, 1 };
    const auto sideOf = [&](int a) { return p[a] >= -0.5 * SolidTieMm ? 2 : 0; };
    if (glm::length(glm::max(out, glm::dvec3(0.0))) > SolidTieMm)
    {
      for (int a = 0; a < 3; ++a)
        if (out[a] > 0.0)
          side[a] = sideOf(a);
    }
    else
    {
      const double most = std::max({ out.x, out.y, out.z }) - SolidTieMm;
      const int a = out.x >= most ? 0 : out.y >= most ? 1 : 2;
      side[a] = sideOf(a);
    }
    const int region = side[0] + 3 * side[1] + 9 * side[2];
    return this->FaceAt(region > 13 ? region - 1 : region, x);
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const glm::dvec3 p = (x - this->Center) * this->Axes;
    const int region = face >= 13 ? face + 1 : face;
    const glm::ivec3 side(region % 3 - 1, region / 3 % 3 - 1, region / 9 - 1);
    glm::dvec3 away(0.0);
    for (int a = 0; a < 3; ++a)
      if (side[a] != 0)
        away[a] = p[a] - side[a] * this->Half[a];
    const glm::dvec3 sides(side);
    if (glm::dot(sides, sides) == 1.0)
      return { glm::dot(away, sides), this->Axes * sides, face };
    const double distance = glm::length(away);
    return { distance, this->Axes * Along(away, distance), face };
  }
  std::uint32_t Faces() const noexcept override { return 26; }
  Box Bounds() const noexcept override
  {
    const glm::dvec3 reach = glm::abs(this->Axes[0]) * this->Half.x +
                             glm::abs(this->Axes[1]) * this->Half.y +
                             glm::abs(this->Axes[2]) * this->Half.z;
    return { this->Center - reach, this->Center + reach };
  }

private:
  glm::dvec3 Center;
  glm::dmat3 Axes;
  glm::dvec3 Half;
};

/// In the plane of (distance from the segment seen along the normal, height): a rectangle.
class Stadium : public ImplicitSolid
{
public:
  Stadium(const glm::dvec3& middle, const glm::dvec3& along, const glm::dvec3& normal,
    double halfLength, double radius, double halfHeight)
    : Middle(middle),
      Axis(along),
      Normal(normal),
      HalfLength(halfLength),
      Radius(radius),
      HalfHeight(halfHeight)
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const Position p = this->Locate(x);
    const double side = p.away - this->Radius, end = std::abs(p.height) - this->HalfHeight;
    return side > 0.0 && end > 0.0 ? std::hypot(side, end) : std::max(side, end);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const Position p = this->Locate(x);
    const double side = p.away - this->Radius, end = std::abs(p.height) - this->HalfHeight;
    const bool low = p.height < -0.5 * SolidTieMm;
    if (side > 0.0 && end > 0.0 && std::hypot(side, end) > SolidTieMm)
      return this->FaceAt(low ? 4 : 3, x);
    return this->FaceAt(side >= end - SolidTieMm ? 0 : low ? 2 : 1, x);
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const Position p = this->Locate(x);
    const glm::dvec3 out = Along(p.across, p.away);
    if (face == 0)
      return { p.away - this->Radius, out, face };
    const glm::dvec3 up = face == 1 || face == 3 ? this->Normal : -this->Normal;
    const double end = (face == 1 || face == 3 ? p.height : -p.height) - this->HalfHeight;
    if (face <= 2)
      return { end, up, face };
    const double side = p.away - this->Radius, rim = std::hypot(side, end);
    return { rim, Along(side * out + end * up, rim), face };
  }
  std::uint32_t Faces() const noexcept override { return 5; }
  Box Bounds() const noexcept override
  {
    const glm::dvec3 disc =
      glm::sqrt(glm::max(glm::dvec3(0.0), 1.0 - this->Normal * this->Normal)) * this->Radius;
    const glm::dvec3 reach =
      disc + glm::abs(this->Normal) * this->HalfHeight + glm::abs(this->Axis) * this->HalfLength;
    return { this->Middle - reach, this->Middle + reach };
  }

private:
  struct Position
  {
    glm::dvec3 across; ///< from the segment, upright on the normal
    double away;       ///< its length
    double height;     ///< along the normal
  };
  Position Locate(const glm::dvec3& x) const noexcept
  {
    const glm::dvec3 v = x - this->Middle;
    const double height = glm::dot(v, this->Normal);
    const double t = glm::clamp(glm::dot(v, this->Axis), -this->HalfLength, this->HalfLength);
    const glm::dvec3 across = v - height * this->Normal - t * this->Axis;
    return { across, glm::length(across), height };
  }

  glm::dvec3 Middle, Axis, Normal;
  double HalfLength, Radius, HalfHeight;
};

class Capsule : public ImplicitSolid
{
public:
  Capsule(const glm::dvec3& a, const glm::dvec3& b, double radius) : A(a), B(b), Radius(radius) {}
  double At(const glm::dvec3& x) const noexcept override
  {
    return CapsuleDistance(x, this->A, this->B, this->Radius);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const glm::dvec3 along = this->B - this->A, v = x - this->A;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? glm::clamp(glm::dot(v, along) / squared, 0.0, 1.0) : 0.0;
    const glm::dvec3 out = v - t * along;
    const double away = glm::length(out);
    return { away - this->Radius, Along(out, away), 0 };
  }
  Sample FaceAt(std::uint32_t, const glm::dvec3& x) const noexcept override
  {
    return this->SampleAt(x);
  }
  std::uint32_t Faces() const noexcept override { return 1; }
  Box Bounds() const noexcept override
  {
    return { glm::min(this->A, this->B) - this->Radius, glm::max(this->A, this->B) + this->Radius };
  }

private:
  glm::dvec3 A, B;
  double Radius;
};

class Cone : public ImplicitSolid
{
public:
  Cone(const glm::dvec3& tip, const glm::dvec3& direction, double halfAngle)
    : Tip(tip),
      Direction(direction),
      Sine(std::sin(halfAngle)),
      Cosine(std::cos(halfAngle))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const glm::dvec3 v = x - this->Tip;
    const double height = glm::dot(v, this->Direction);
    const double away = glm::length(v - height * this->Direction);
    return this->IsBeforeTip(height, away) ? glm::length(v)
                                           : away * this->Cosine - height * this->Sine;
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const glm::dvec3 v = x - this->Tip;
    const double height = glm::dot(v, this->Direction);
    const double away = glm::length(v - height * this->Direction);
    return this->FaceAt(this->IsBeforeTip(height, away) && glm::length(v) > SolidTieMm ? 1 : 0, x);
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const glm::dvec3 v = x - this->Tip;
    if (face == 1)
      return { glm::length(v), Along(v, glm::length(v)), face };
    const double height = glm::dot(v, this->Direction);
    const glm::dvec3 across = v - height * this->Direction;
    const double away = glm::length(across);
    return { away * this->Cosine - height * this->Sine,
      this->Cosine * Along(across, away) - this->Sine * this->Direction, face };
  }
  std::uint32_t Faces() const noexcept override { return 2; }
  Box Bounds() const noexcept override { return HalfSpaceBounds(this->Tip, -this->Direction, 0.0); }

private:
  bool IsBeforeTip(double height, double away) const noexcept
  {
    return height * this->Cosine + away * this->Sine < 0.0;
  }

  glm::dvec3 Tip, Direction;
  double Sine, Cosine;
};
} // namespace

SolidPointer MakePlane(const glm::dvec3& point, const glm::dvec3& normal)
{
  RequireFinite("plane", "point", point);
  return std::make_shared<Plane>(point, RequireDirection("plane", "normal", normal));
}

SolidPointer MakeSlab(const glm::dvec3& point, const glm::dvec3& normal, double widthMm)
{
  RequireFinite("slab", "point", point);
  RequirePositive("slab", "width", widthMm);
  return std::make_shared<Slab>(point, RequireDirection("slab", "normal", normal), widthMm);
}

SolidPointer MakeBox(const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half)
{
  RequireFinite("box", "center", center);
  for (int a = 0; a < 3; ++a)
    RequirePositive("box", "half side", half[a]);
  return std::make_shared<BoxSolid>(center, RequireOrthonormal("box", axes), half);
}

SolidPointer MakeRoundedBox(
  const glm::dvec3& center, const glm::dmat3& axes, const glm::dvec3& half, double radiusMm)
{
  RequirePositive("rounded box", "radius", radiusMm);
  const double least = std::min({ half.x, half.y, half.z });
  if (!(radiusMm < least))
    throw std::invalid_argument("rounded box: radius " + SolidNumber(radiusMm) +
                                " mm must be below the smallest half side, " + SolidNumber(least) +
                                " mm; a smaller radius, or a capsule");
  return MakeOffset(MakeBox(center, axes, half - radiusMm), radiusMm);
}

SolidPointer MakeCylinder(const glm::dvec3& a, const glm::dvec3& b, double radiusMm)
{
  RequireFinite("cylinder", "end", a);
  RequireFinite("cylinder", "end", b);
  RequirePositive("cylinder", "radius", radiusMm);
  const glm::dvec3 normal = RequireDirection("cylinder", "axis from end to end", b - a);
  return std::make_shared<Stadium>(
    0.5 * (a + b), glm::dvec3(0.0), normal, 0.0, radiusMm, 0.5 * glm::distance(a, b));
}

SolidPointer MakeStadium(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& normal,
  double radiusMm, double heightMm)
{
  RequireFinite("stadium", "end", a);
  RequireFinite("stadium", "end", b);
  RequirePositive("stadium", "radius", radiusMm);
  RequirePositive("stadium", "height", heightMm);
  const double length = glm::distance(a, b);
  const glm::dvec3 along = Along(b - a, length);
  glm::dvec3 upright = RequireDirection("stadium", "normal", normal);
  upright = RequireDirection(
    "stadium", "normal, upright on the segment,", upright - glm::dot(upright, along) * along);
  return std::make_shared<Stadium>(
    0.5 * (a + b), along, upright, 0.5 * length, radiusMm, 0.5 * heightMm);
}

SolidPointer MakeCapsule(const glm::dvec3& a, const glm::dvec3& b, double radiusMm)
{
  RequireFinite("capsule", "end", a);
  RequireFinite("capsule", "end", b);
  RequirePositive("capsule", "radius", radiusMm);
  return std::make_shared<Capsule>(a, b, radiusMm);
}

SolidPointer MakeCone(const glm::dvec3& tip, const glm::dvec3& direction, double angleDeg)
{
  RequireFinite("cone", "tip", tip);
  if (!(angleDeg >= 1.0 && angleDeg <= 179.0))
    throw std::invalid_argument(
      "cone: the angle is " + SolidNumber(angleDeg) + " degrees; it must be in [1, 179]");
  return std::make_shared<Cone>(
    tip, RequireDirection("cone", "direction", direction), glm::radians(0.5 * angleDeg));
}

} // namespace hasp
