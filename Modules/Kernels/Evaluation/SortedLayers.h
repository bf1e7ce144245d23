#pragma once
#include <glm/vec3.hpp>

#include <vector>

namespace hasp
{

/// A surface that a pixel's ray meets.
struct Layer
{
  double t = 0.0;          ///< along the ray; the smaller the nearer
  glm::dvec3 color{ 0.0 }; ///< as it is shaded, [0,1]; not multiplied by its opacity
  double opacity = 1.0;    ///< [0,1]; what is opaque hides what is behind it
  int surface = 0;         ///< whose it is
};

/// Nearest first; of the same t in the order they came in. Nothing is left behind an opaque one.
std::vector<Layer> SortLayers(std::vector<Layer> layers);

/// What pictures of translucent surfaces are judged by: the colour of the pixel, each layer over
/// what is behind it (Porter and Duff 1984), the background last. `sorted`: as SortLayers returns
/// it.
glm::dvec3 BlendLayers(const std::vector<Layer>& sorted, const glm::dvec3& background);

/// Do two rays meet the same surfaces in the same order? Where those a small part of a pixel apart
/// do not, a pixel lies on a silhouette, or where two surfaces cut each other.
bool SameSurfaces(const std::vector<Layer>& a, const std::vector<Layer>& b);

} // namespace hasp
