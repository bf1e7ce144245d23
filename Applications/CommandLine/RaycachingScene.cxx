#include "RaycachingScene.h"

#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"
#include "Isosurface/RayCaster.h"
#include "vtkHaspVolumeView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hasp
{
namespace
{

/// Where the flight ends: the lower fifth of what the first view shows, the jaw of a head.
glm::dvec3 Jaw(const IsosurfaceView& view)
{
  const auto cells = MakeCellMethod(view);
  cells->Draw();
  SurfacePoints shown = cells->Points(); // from the lowest row up
  std::erase(shown, std::nullopt);
  if (shown.empty())
    throw std::runtime_error("raycaching: the first view shows no surface to fly to");
  return *shown[shown.size() / 5];
}

} // namespace

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

glm::dvec3 RaycachingScene::TowardsLight() const
{
  return glm::normalize(glm::dvec3(-0.5, -1.0, 1.2));
}

std::vector<RecordedPath> RecordedPaths(const RaycachingScene& scene, IsosurfaceView& view)
{
  const auto path = std::make_shared<CameraPath>(view);
  const double isovalue = scene.cells.isovalue;
  const glm::dvec3 jaw = Jaw(view);
  // There and back in 120 frames, without a jump.
  const auto wave = [](int frame)
  { return 0.5 - 0.5 * std::cos(glm::pi<double>() * frame / 60.0); };
  return { { "orbit", "orbit 1 degree a frame",
             [=](int frame)
             {
               path->Orbit(frame);
               return isovalue;
             } },
    { "fly", "flight into the jaw to 20 mm and back",
      [=](int frame)
      {
        path->Fly(int(std::lround(600.0 * wave(frame))), 600, jaw, 20.0);
        return isovalue;
      } },
    { "jitter", "head jitter 5 mm and 3 degrees",
      [=](int frame)
      {
        path->Jitter(frame);
        return isovalue;
      } },
    { "sweep", "isovalue swept to half as much again and back",
      [=](int frame)
      {
        path->Orbit(0);
        return isovalue * (1.0 + 0.5 * wave(frame));
      } } };
}

PictureView IndexView(const IsosurfaceView& view, const AnyGridView& grid)
{
  const GridGeometry& geometry = GeometryOf(grid);
  glm::dmat4 indexToWorld(geometry.IndexToWorldMatrix());
  indexToWorld[3] = glm::dvec4(geometry.origin, 1.0);
  return { glm::inverse(view.clipToWorld) * indexToWorld, { view.width, view.height }, {} };
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

PictureTruth CentreRaycachingPicture(const IsosurfaceView& view, double isovalue)
{
  const AnyGridView grid = ViewImage(view.image);
  const MinMaxBlocks blocks(grid);
  const RayCaster caster(grid, blocks, isovalue);
  const glm::dvec3 lamp = -glm::make_vec3(view.camera->GetDirectionOfProjection());
  PictureTruth truth;
  truth.pixels.assign(std::size_t(view.width) * view.height, glm::vec3(0.0F));
  std::vector<char> surface(truth.pixels.size()); // a byte each: threads write side by side
  ParallelFor(0, view.height, 8,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto y = int(first); y < last; ++y)
        for (int x = 0; x < view.width; ++x)
        {
          const auto [origin, direction] = view.Ray(x, y);
          const double reach = glm::length(view.Unproject(x, y, 1.0) - origin);
          const std::size_t n = std::size_t(y) * view.width + x;
          const auto hit = caster.Cast(origin, direction, 0.0, reach);
          surface[n] = hit.has_value();
          if (hit)
            truth.pixels[n] = glm::vec3(float(DiffuseShade(hit->gradient, -direction, lamp)));
        }
    });
  truth.surface.assign(surface.begin(), surface.end());
  return truth;
}

double DiffuseShade(
  const glm::dvec3& gradient, const glm::dvec3& toEye, const glm::dvec3& towardsLight)
{
  const double length = glm::length(gradient);
  if (!(length > 0.0))
    return 0.0;
  const double facing = glm::dot(gradient, towardsLight) / length;
  return std::max(0.0, glm::dot(gradient, toEye) < 0.0 ? -facing : facing);
}

double HoleShare(IsosurfaceMethod& exact, IsosurfaceMethod& shown)
{
  exact.Draw();
  const SurfacePoints truth = exact.Points(), points = shown.Points();
  std::size_t surface = 0, holes = 0;
  for (std::size_t n = 0; n < truth.size(); ++n)
  {
    surface += truth[n].has_value();
    holes += truth[n] && !points[n];
  }
  return surface ? double(holes) / double(surface) : 0.0;
}

std::string Decibels(double psnr)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.1f dB", psnr);
  return text;
}

} // namespace hasp
