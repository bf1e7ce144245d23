#include "PictureErrors.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{

double PictureTruth::SurfaceShare() const
{
  const auto count = std::count(this->surface.begin(), this->surface.end(), true);
  return this->surface.empty() ? 0.0 : double(count) / double(this->surface.size());
}

std::vector<glm::vec3> Shrink(const std::vector<glm::vec3>& pixels, int width, int n)
{
  const int height = int(pixels.size()) / width, w = width / n, h = height / n;
  std::vector<glm::vec3> small(std::size_t(w) * h, glm::vec3(0.0F));
  for (int y = 0; y < h * n; ++y)
    for (int x = 0; x < w * n; ++x)
      small[std::size_t(y / n) * w + x / n] += pixels[std::size_t(y) * width + x] / float(n * n);
  return small;
}

double ForegroundPsnr(const PictureTruth& truth, const std::vector<glm::vec3>& shown)
{
  if (shown.size() != truth.pixels.size())
    throw std::invalid_argument("ForegroundPsnr: pictures of two sizes");
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t n = 0; n < shown.size(); ++n)
    if (truth.surface[n])
    {
      const glm::dvec3 difference = glm::dvec3(shown[n]) - glm::dvec3(truth.pixels[n]);
      sum += glm::dot(difference, difference);
      ++count;
    }
  if (count == 0)
    throw std::invalid_argument("ForegroundPsnr: no pixel shows a surface");
  return sum == 0.0 ? 99.0 : -10.0 * std::log10(sum / (3.0 * double(count)));
}

void PictureMean::Add(const std::vector<glm::vec3>& picture)
{
  this->Sum.resize(picture.size());
  for (std::size_t n = 0; n < picture.size(); ++n)
    this->Sum[n] += glm::dvec3(picture[n]);
  ++this->Count;
}

std::vector<glm::vec3> PictureMean::Mean() const
{
  std::vector<glm::vec3> mean;
  for (const glm::dvec3& sum : this->Sum)
    mean.emplace_back(sum / double(this->Count));
  return mean;
}

} // namespace hasp
