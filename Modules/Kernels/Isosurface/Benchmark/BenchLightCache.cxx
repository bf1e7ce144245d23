// Error and cost of LightCache against rays for each picture alone: an orbit, 512 x 512 pixels,
// ambient occlusion within 25 mm and a hard shadow. Usage: BenchKernelLightCache [volume.mha, raw
// MET_SHORT, or -] [isovalue] [frames] [degrees a frame]
// -: the phantom head of 256^3 samples. RMSE of openness, of 1, against 1024 rays, of each 31st
// surface pixel.
#include "Grid/ParallelFor.h"
#include "Grid/Phantom.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellTracer.h"
#include "Isosurface/LightCache.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace
{

constexpr int Side = 512;

double CpuMilliseconds()
{
  return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

std::vector<std::int16_t> ReadMha(const char* path, hasp::GridGeometry& g)
{
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line) && line.rfind("ElementDataFile", 0) != 0)
  {
    std::istringstream words(line);
    std::string name, equals;
    words >> name >> equals;
    if (name == "DimSize")
      words >> g.dims.x >> g.dims.y >> g.dims.z;
    if (name == "ElementSpacing")
      words >> g.spacing.x >> g.spacing.y >> g.spacing.z;
  }
  std::vector<std::int16_t> samples(g.Size());
  file.read(reinterpret_cast<char*>(samples.data()), std::streamsize(samples.size() * 2));
  if (!file)
  {
    std::fprintf(stderr, "cannot read %s\n", path);
    std::exit(2);
  }
  return samples;
}

hasp::PictureView View(const hasp::GridGeometry& g, double degrees)
{
  const glm::dvec3 size = glm::dvec3(g.dims - 1) * g.spacing, middle = 0.5 * size;
  const double far = 1.75 * glm::length(size), turn = glm::radians(degrees);
  const glm::dvec3 eye =
    middle + far * glm::normalize(glm::dvec3(std::sin(turn), -std::cos(turn), 0.25));
  return { glm::perspective(glm::radians(30.0), 1.0, 0.4 * far, 2.0 * far) *
             glm::lookAt(eye, middle, glm::dvec3(0, 0, 1)) * glm::scale(glm::dmat4(1.0), g.spacing),
    { Side, Side }, {} };
}

} // namespace

int main(int argc, char** argv)
{
  hasp::GridGeometry g;
  std::vector<std::int16_t> samples;
  const double isovalue = argc > 2 ? std::atof(argv[2]) : 300;
  const int frames = argc > 3 ? std::atoi(argv[3]) : 32;
  const double step = argc > 4 ? std::atof(argv[4]) : 1.0;
  if (argc > 1 && std::string(argv[1]) != "-")
    samples = ReadMha(argv[1], g);
  else
  {
    hasp::PhantomSettings settings;
    settings.noiseHU = 25;
    g = hasp::PhantomGridOfSize({ 256, 256, 256 }, settings);
    samples = SamplePhantom(g, settings);
    g.origin = {};
  }
  g.origin = {};
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  const hasp::MinMaxBlocks blocks(grid);
  const auto cells =
    std::make_shared<hasp::ClusteredCells>(ExtractActiveCells(grid, blocks, isovalue));
  const hasp::CellTracer tracer(cells);
  const double distance = 25;
  const glm::dvec4 lamp(0.4, -0.8, 0.6, 0);

  hasp::LightCache cache;
  hasp::PictureLight light;
  hasp::TracedPicture picture;
  std::printf(
    "%zu cells; CPU ms and RMSE with the cache | with rays for each picture alone\n"
    "frame  pixels  primary     rays  light   RMSE | 16: light   RMSE | 4: RMSE | 64: RMSE |"
    " frame / frame of 16 rays\n",
    cells->Count());
  for (int f = 1; f <= frames; ++f)
  {
    const hasp::PictureView view = View(g, step * (f - 1));
    const double p0 = CpuMilliseconds();
    tracer.TracePicture(view, picture);
    const double t0 = CpuMilliseconds();
    cache.Light(tracer, view, picture, { distance, lamp }, light);
    const double spent = CpuMilliseconds() - t0;
    if ((f & (f - 1)) != 0 && f != frames)
      continue;
    const hasp::PictureRays rays(view);
    std::vector<std::size_t> pixels;
    std::vector<hasp::CellHit> hits;
    for (std::size_t pixel = 0; pixel < picture.cells.size(); ++pixel)
    {
      if (picture.cells[pixel] == hasp::TracedPicture::Nothing)
        continue;
      hasp::CellRay ray;
      rays.Of(glm::dvec2(pixel % Side, pixel / Side) + 0.5, ray);
      pixels.push_back(pixel);
      hits.push_back(*tracer.Trace(ray));
    }
    const auto each = [&](std::size_t by, const auto& body)
    {
      hasp::ParallelFor(0, std::int64_t(hits.size() / by), 256,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first; n < last; ++n)
            body(std::size_t(n) * by);
        });
    };
    std::vector<float> truth(hits.size()), direct(hits.size());
    std::vector<char> lit(hits.size());
    constexpr std::size_t By = 31;
    each(By,
      [&](std::size_t n) {
        truth[n] = tracer.AmbientOcclusion(hits[n], { 1024, distance }, 77777 + unsigned(n));
      });
    const auto rmse = [&](const auto& value)
    {
      double sum = 0;
      std::size_t count = 0;
      for (std::size_t n = 0; n / By < hits.size() / By; n += By, ++count)
        sum += std::pow(value(n) - truth[n], 2);
      return std::sqrt(sum / count);
    };
    const double t1 = CpuMilliseconds();
    each(1,
      [&](std::size_t n)
      {
        direct[n] =
          tracer.AmbientOcclusion(hits[n], { 16, distance }, unsigned(pixels[n] + 1000003 * f));
      });
    const double ao = CpuMilliseconds() - t1;
    const double t2 = CpuMilliseconds();
    each(1, [&](std::size_t n) { lit[n] = tracer.Light(hits[n], { glm::dvec3(lamp) }) > 0; });
    const double shadow = CpuMilliseconds() - t2;
    const double error16 = rmse([&](std::size_t n) { return direct[n]; });
    std::vector<float> other(hits.size());
    const auto alone = [&](int count)
    {
      each(By,
        [&](std::size_t n)
        {
          other[n] = tracer.AmbientOcclusion(
            hits[n], { count, distance }, unsigned(pixels[n] + 1000003 * f));
        });
      return rmse([&](std::size_t n) { return other[n]; });
    };
    std::printf("%5d %7zu %8.1f %8lld %6.1f %.4f |    %6.1f %.4f |  %.4f |   %.4f | %.3f\n", f,
      hits.size(), t0 - p0, static_cast<long long>(cache.Rays()), spent,
      rmse([&](std::size_t n) { return light[pixels[n]].x / 255.0; }), ao + shadow, error16,
      alone(4), alone(64), (t0 - p0 + spent) / (t0 - p0 + ao + shadow));
    std::fflush(stdout);
  }
  return 0;
}
