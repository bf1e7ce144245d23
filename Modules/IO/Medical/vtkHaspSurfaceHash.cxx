#include "vtkHaspSurfaceHash.h"

#if HASP_WITH_OPENSSL
#include <openssl/evp.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hasp
{

#if HASP_WITH_OPENSSL
namespace
{

using Corner = std::array<float, 3>;
using Corners = std::array<Corner, 3>;

Corner CornerOf(const glm::dvec3& point)
{
  Corner corner{};
  for (int a = 0; a < 3; ++a)
  {
    const auto value = static_cast<float>(point[a]);
    if (!std::isfinite(value))
      throw std::invalid_argument("surface hash: a point is not finite in 32-bit floats");
    corner[a] = value == 0.0F ? 0.0F : value; // without its sign
  }
  return corner;
}

/// From its least corner on, the way that it is wound.
Corners Turned(const Corners& corners)
{
  Corners least = corners;
  for (int first = 1; first < 3; ++first)
    least = std::min(
      least, Corners{ corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3] });
  return least;
}

std::string Hexadecimal(const unsigned char* digest, std::size_t size)
{
  std::string text;
  for (std::size_t n = 0; n < size; ++n)
  {
    text += "0123456789abcdef"[digest[n] >> 4U];
    text += "0123456789abcdef"[digest[n] & 15U];
  }
  return text;
}

} // namespace

std::string SurfaceHash(const TriangleMesh& mesh)
{
  static_assert(sizeof(Corners) == 36, "triangles are hashed as they lie in memory");
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles)
  {
    if (std::max({ t.x, t.y, t.z }) >= mesh.points.size())
      throw std::invalid_argument("surface hash: a triangle names point " +
                                  std::to_string(std::max({ t.x, t.y, t.z })) + " of " +
                                  std::to_string(mesh.points.size()));
    triangles.push_back(Turned(
      { CornerOf(mesh.points[t.x]), CornerOf(mesh.points[t.y]), CornerOf(mesh.points[t.z]) }));
  }
  std::sort(triangles.begin(), triangles.end());
  std::array<unsigned char, 32> digest{};
  unsigned int length = 0;
  if (EVP_Digest(triangles.data(), triangles.size() * sizeof(Corners), digest.data(), &length,
        EVP_sha256(), nullptr) != 1 ||
      length != digest.size())
    throw std::runtime_error("SHA-256 is not available; check the installation of OpenSSL");
  return Hexadecimal(digest.data(), digest.size());
}
#else
std::string SurfaceHash(const TriangleMesh&)
{
  return {};
}
#endif

} // namespace hasp
