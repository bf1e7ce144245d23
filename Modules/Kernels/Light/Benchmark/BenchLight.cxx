// Error against time of light by paths, alone and kept: the phantom head, or a raw MET_SHORT .mha,
// on a plane, under the built-in sky. Usage: BenchKernelLight [volume.mha or -] [isovalue] [frames]
// [degrees a frame] [pixels]
// Prints the RMSE of linear radiance against many paths, of each surface pixel, and CPU time.
#include "Grid/Phantom.h"
#include "Isosurface/ActiveCells.h"
#include "Light/SceneLightCache.h"
#include "Light/SkyModel.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>
#include <string>

namespace
{

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

hasp::PictureView View(const hasp::LitScene& scene, double degrees, int side)
{
  const glm::dvec3 middle = 0.5 * (scene.Bounds().low + scene.Bounds().high);
  const double far = 1.75 * scene.Bounds().Size(), turn = glm::radians(degrees);
  const glm::dvec3 eye =
    middle + far * glm::normalize(glm::dvec3(std::sin(turn), -std::cos(turn), 0.25));
  return { glm::perspective(glm::radians(30.0), 1.0, 0.4 * far, 2.0 * far) *
             glm::lookAt(eye, middle, glm::dvec3(0, 0, 1)),
    { side, side }, {} };
}

double Error(const std::vector<glm::vec4>& picture, const std::vector<glm::vec4>& truth)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t n = 0; n < truth.size(); ++n)
    if (truth[n].a > 0.0F)
    {
      const glm::dvec3 off = glm::dvec3(picture[n]) - glm::dvec3(truth[n]);
      sum += glm::dot(off, off) / 3.0;
      ++count;
    }
  return std::sqrt(sum / std::max(1, count));
}

std::vector<glm::vec4> Paths(const hasp::LitScene& scene, const hasp::PictureView& view,
  int bounces, int samples, std::uint32_t seed)
{
  hasp::PathTracedPicture picture;
  for (int n = 0; n < samples; ++n)
    hasp::AddPathSample(scene, view, { { bounces }, seed, false }, picture);
  std::vector<glm::vec4> pixels(picture.sums.size());
  for (std::size_t n = 0; n < pixels.size(); ++n)
    pixels[n] = picture.Pixel(n);
  return pixels;
}

} // namespace

int main(int argc, char** argv)
{
  hasp::GridGeometry g;
  std::vector<std::int16_t> samples;
  const double isovalue = argc > 2 ? std::atof(argv[2]) : 300;
  const int frames = argc > 3 ? std::atoi(argv[3]) : 16;
  const double step = argc > 4 ? std::atof(argv[4]) : 1.0;
  const int side = argc > 5 ? std::atoi(argv[5]) : 256;
  if (argc > 1 && std::string(argv[1]) != "-")
    samples = ReadMha(argv[1], g);
  else
  {
    hasp::PhantomSettings settings;
    settings.noiseHU = 25;
    g = hasp::PhantomGridOfSize({ 200, 200, 200 }, settings);
    samples = SamplePhantom(g, settings);
  }
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  const auto cells = std::make_shared<const hasp::ClusteredCells>(
    hasp::ExtractActiveCells(grid, hasp::MinMaxBlocks(grid), isovalue));
  hasp::LitBody bone;
  bone.cells = std::make_shared<const hasp::CellTracer>(cells);
  bone.material =
    std::make_shared<const hasp::SurfaceScattering>(hasp::SurfaceMaterial{ glm::vec3(0.8F) });
  const auto sky = std::make_shared<const hasp::Environment>(hasp::MakeSky({}));
  const hasp::LitScene scene({ bone }, {}, sky);
  std::printf("%zu cells, %d x %d pixels\n", std::size_t(cells->Count()), side, side);

  for (const int bounces : { 1, 3 })
  {
    const hasp::PictureView view = View(scene, 0.0, side);
    const auto truth = Paths(scene, view, bounces, 1024, 99);
    std::printf("%d bounces: paths anew\n  samples   RMSE   CPU ms  Mray/s CPU\n", bounces);
    hasp::PathTracedPicture picture;
    const double start = CpuMilliseconds();
    for (int n = 1; n <= 128; ++n)
    {
      hasp::AddPathSample(scene, view, { { bounces }, 1, false }, picture);
      if ((n & (n - 1)) == 0)
      {
        std::vector<glm::vec4> pixels(truth.size());
        for (std::size_t p = 0; p < pixels.size(); ++p)
          pixels[p] = picture.Pixel(p);
        const double spent = CpuMilliseconds() - start;
        std::printf(
          "%9d %.4f %8.0f %.2f\n", n, Error(pixels, truth), spent, picture.rays / spent * 1e-3);
      }
    }
    hasp::SceneLightCache still;
    hasp::SceneLightRequest request;
    request.paths.bounces = bounces;
    hasp::LitPicture lit;
    std::printf("kept, still\n   frame   RMSE   CPU ms  Mray/s\n");
    double all = 0.0;
    for (int n = 1; n <= 64; ++n)
    {
      const double before = CpuMilliseconds();
      still.Light(scene, view, {}, request, lit);
      const double spent = CpuMilliseconds() - before;
      all += spent;
      if ((n & (n - 1)) == 0)
        std::printf(
          "%8d %.4f %8.0f %.2f\n", n, Error(lit, truth), all, still.Rays() / spent * 1e-3);
    }
    hasp::SceneLightCache moving;
    std::printf("kept, moving\n   frame   RMSE   CPU ms of the frame\n");
    for (int n = 0; n < frames; ++n)
    {
      const double before = CpuMilliseconds();
      const hasp::PictureView now = View(scene, step * (n - frames + 1), side);
      moving.Light(scene, now, {}, request, lit);
      const double spent = CpuMilliseconds() - before;
      if (n == 0 || n == frames - 1 || n == 7)
        std::printf(
          "%8d %.4f %8.0f\n", n + 1, Error(lit, Paths(scene, now, bounces, 256, 98)), spent);
    }
  }
}
