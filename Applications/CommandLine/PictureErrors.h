#pragma once
#include <glm/vec3.hpp>

#include <vector>

namespace hasp
{

/// A picture that others are held against, and where it shows a surface.
struct PictureTruth
{
  std::vector<glm::vec3> pixels; ///< in [0,1], row by row from below
  std::vector<bool> surface;
  double SurfaceShare() const;
};

/// Means over squares of n x n pixels; width is of the large picture, a multiple of n.
std::vector<glm::vec3> Shrink(const std::vector<glm::vec3>& pixels, int width, int n);

/// Peak signal-to-noise ratio over the pixels that truly show a surface, dB; 99 if they are equal.
double ForegroundPsnr(const PictureTruth& truth, const std::vector<glm::vec3>& shown);

/// A mean that pictures are added to one by one.
class PictureMean
{
public:
  void Add(const std::vector<glm::vec3>& picture);
  std::vector<glm::vec3> Mean() const;

private:
  std::vector<glm::dvec3> Sum;
  int Count = 0;
};

} // namespace hasp
