#pragma once
#include "Distance/ImplicitSolid.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

/// What all that make solids refuse, and how they say so. All throw std::invalid_argument.
namespace hasp
{

inline std::string SolidNumber(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

inline void RequireFinite(const char* shape, const char* what, double value)
{
  if (!std::isfinite(value))
    throw std::invalid_argument(
      std::string(shape) + ": " + what + " is " + SolidNumber(value) + "; it must be finite");
}

inline void RequireFinite(const char* shape, const char* what, const glm::dvec3& value)
{
  for (int a = 0; a < 3; ++a)
    RequireFinite(shape, what, value[a]);
}

inline void RequirePositive(const char* shape, const char* what, double value)
{
  if (!(value > 0.0 && std::isfinite(value)))
    throw std::invalid_argument(std::string(shape) + ": " + what + " is " + SolidNumber(value) +
                                " mm; it must be above 0 and finite");
}

/// Its unit vector, exact where it lies along an axis.
inline glm::dvec3 RequireDirection(const char* shape, const char* what, const glm::dvec3& value)
{
  RequireFinite(shape, what, value);
  const double length = glm::length(value);
  if (!(length > 1e-12 && std::isfinite(length)))
    throw std::invalid_argument(std::string(shape) + ": " + what + " has length " +
                                SolidNumber(length) + "; it must be above 1e-12 and finite");
  return value / length;
}

/// Their orthonormal ones, the first as it is: what is almost upright would stretch distances.
inline glm::dmat3 RequireOrthonormal(const char* shape, const glm::dmat3& axes)
{
  for (int a = 0; a < 3; ++a)
    if (!(std::abs(glm::dot(axes[a], axes[a]) - 1.0) <= 1e-4))
      throw std::invalid_argument(std::string(shape) + ": axis " + std::to_string(a) +
                                  " has length " + SolidNumber(glm::length(axes[a])) +
                                  "; it must be 1 within 5e-5");
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b)
      if (!(std::abs(glm::dot(axes[a], axes[b])) <= 1e-4))
        throw std::invalid_argument(std::string(shape) + ": axes " + std::to_string(a) + " and " +
                                    std::to_string(b) + " have the dot product " +
                                    SolidNumber(glm::dot(axes[a], axes[b])) +
                                    "; they must be upright on each other within 1e-4");
  glm::dmat3 exact(axes);
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < a; ++b)
      exact[a] -= glm::dot(exact[a], exact[b]) * exact[b];
    exact[a] /= glm::length(exact[a]);
  }
  return exact;
}

inline void RequirePart(const char* node, const SolidPointer& part)
{
  if (!part)
    throw std::invalid_argument(std::string(node) + ": a part is null; give each a solid");
}

inline std::uint32_t CheckedFaceCount(const char* node, double faces)
{
  if (faces > double(std::numeric_limits<std::uint32_t>::max()))
    throw std::invalid_argument(std::string(node) + ": " + SolidNumber(faces) +
                                " faces; at most 2^32 - 1: join fewer smoothly at once");
  return static_cast<std::uint32_t>(faces);
}

} // namespace hasp
