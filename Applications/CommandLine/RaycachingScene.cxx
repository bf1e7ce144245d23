#include "RaycachingScene.h"

#include <glm/geometric.hpp>

namespace hasp
{

RaycachingScene::RaycachingScene(const CellScene& cells_, int pixels_)
  : cells(cells_),
    pixels(pixels_),
    data(cells_.data + ", " + std::to_string(pixels_) + "^2 pixels")
{
}

IsosurfaceView RaycachingScene::View() const
{
  return { this->cells.image, this->cells.isovalue, this->pixels, this->pixels,
    glm::normalize(glm::dvec3(-0.6, 1.0, -0.4)) };
}

PictureTruth TrueRaycachingPicture(const IsosurfaceView& view, double isovalue, int samples)
{
  IsosurfaceView large = view;
  large.width *= samples;
  large.height *= samples;
  const auto method = MakeCellMethod(large);
  method->SetIsovalue(isovalue);
  method->Draw();
  PictureTruth truth;
  truth.pixels = Shrink(method->Picture(), large.width, samples);
  truth.surface.assign(truth.pixels.size(), false);
  const SurfacePoints points = method->Points();
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x)
      if (points[std::size_t(y) * large.width + x])
        truth.surface[std::size_t(y / samples) * view.width + x / samples] = true;
  return truth;
}

} // namespace hasp
