// Rays a second and bytes of CellTracer against RayCaster on a phantom head, 512 x 512 pixels.
// Usage: BenchKernelCellTracer [samples per axis, default 256] [compact]
// Least of seven runs, ours and the rival's in turn. AO: two cosine-weighted rays a hit, any
// length.
#include "Grid/ParallelFor.h"
#include "Grid/Phantom.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellTracer.h"
#include "Isosurface/RayCaster.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#if HASP_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

namespace
{

constexpr int Side = 512, Runs = 7, AORays = 2;

struct Row
{
  std::string name;
  std::size_t rays;
  std::function<void()> run;
  double seconds = 1e300;
};

void WithThreads(int threads, const std::function<void()>& run)
{
#if HASP_WITH_TBB
  const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  arena.execute(run);
#else
  (void)threads;
  run();
#endif
}

double Seconds(const std::function<void()>& run)
{
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

int main(int argc, char** argv)
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 256;
  if (n < 16 || n > 1024)
  {
    std::fprintf(stderr, "samples per axis must be 16 to 1024\n");
    return 2;
  }
  const auto precision = argc > 2 && std::string(argv[2]) == "compact"
                           ? hasp::CellPrecision::Compact
                           : hasp::CellPrecision::Exact;
  hasp::PhantomSettings settings;
  settings.noiseHU = 25;
  const hasp::GridGeometry g = hasp::PhantomGridOfSize({ n, n, n }, settings);
  const auto samples = SamplePhantom(g, settings);
  const hasp::AnyGridView grid = hasp::GridView<const std::int16_t>{ samples.data(), g };
  const hasp::MinMaxBlocks blocks(grid);
  const auto cells =
    std::make_shared<hasp::ClusteredCells>(ExtractActiveCells(grid, blocks, 226, precision));
  std::optional<hasp::CellTracer> made;
  const double build = Seconds([&] { made.emplace(cells); });
  const hasp::CellTracer& tracer = *made;
  const hasp::RayCaster caster(grid, blocks, 226);
  std::printf("%zu cells, %.2f MB; tree %.2f MB, built in %.1f ms\n", cells->Count(),
    cells->Bytes() / 1e6, tracer.Bytes() / 1e6, build * 1e3);

  const glm::dvec3 middle = glm::dvec3(g.dims - 1) * 0.5,
                   eye = middle + glm::dvec3(0.5, -1.6, 0.35) * double(n);
  const hasp::PictureView view{ glm::perspective(0.72, 1.0, 0.5 * n, 4.0 * n) *
                                  glm::lookAt(eye, middle, glm::dvec3(0, 0, 1)),
    { Side, Side }, {} };
  const glm::dmat4 back = glm::inverse(view.indexToClip);
  std::vector<hasp::CellRay> rays;
  std::vector<hasp::CellHit> hits;
  for (int pixel = 0; pixel < Side * Side; ++pixel)
  {
    const glm::dvec2 device = (glm::dvec2(pixel % Side, pixel / Side) + 0.5) * (2.0 / Side) - 1.0;
    const glm::dvec4 far = back * glm::dvec4(device, 1, 1);
    rays.push_back({ eye, glm::normalize(glm::dvec3(far) / far.w - eye) });
    if (const auto hit = tracer.Trace(rays.back()))
      hits.push_back(*hit);
  }
  const auto each = [](std::size_t count, const auto& body)
  {
    hasp::ParallelFor(0, std::int64_t(count), 4096,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t r = first; r < last; ++r)
          body(r);
      });
  };
  volatile bool sink = false;
  hasp::TracedPicture picture;
  std::vector<Row> rows{
    { "RayCaster primary", rays.size(),
      [&]
      {
        each(rays.size(),
          [&](auto r)
          {
            const glm::dvec3 o = g.IndexToWorld(rays[r].origin);
            sink =
              caster.Cast(o, g.IndexToWorld(rays[r].origin + rays[r].direction) - o).has_value();
          });
      } },
    { "CellTracer primary, single rays", rays.size(),
      [&] { each(rays.size(), [&](auto r) { sink = tracer.Trace(rays[r]).has_value(); }); } },
    { "CellTracer primary, picture", rays.size(), [&] { tracer.TracePicture(view, picture); } },
    { "CellTracer ambient occlusion", hits.size() * AORays,
      [&]
      {
        each(hits.size(),
          [&](auto r) {
            sink = tracer.AmbientOcclusion(hits[r], { AORays, 1e9 }, unsigned(r)) > 0.5F;
          });
      } },
  };
  for (const int threads : { 1, 2 })
  {
    for (int run = 0; run < Runs; ++run)
      for (Row& row : rows)
        WithThreads(threads, [&] { row.seconds = std::min(row.seconds, Seconds(row.run)); });
    for (Row& row : rows)
      std::printf("%d thread%s  %-34s %6.2f Mray/s\n", threads, threads > 1 ? "s" : " ",
        row.name.c_str(), row.rays / std::exchange(row.seconds, 1e300) / 1e6);
  }
  return 0;
}
