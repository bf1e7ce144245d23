// The same picture whatever the number of threads.
#include "Grid/AnalyticVolumes.h"
#include "Grid/Testing/WithThreads.h"
#include "Isosurface/Testing/TracedVolume.h"

#include <glm/gtc/matrix_transform.hpp>

namespace
{

TEST(CellTracerThreads, GiveTheSamePicture)
{
  const hasp::GridGeometry g = hasp::testing::Cube({ 60, 50, 55 });
  const auto samples = hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(9), g, 100, 0);
  const hasp::PictureView view{ glm::perspective(0.6, 1.3, 20.0, 200.0) *
                                  glm::lookAt(glm::dvec3(90, -40, 60), glm::dvec3(30, 25, 27),
                                    glm::dvec3(0, 0, 1)),
    { 211, 163 }, {} };
  const auto draw = [&](int threads)
  {
    return hasp::testing::WithThreads(threads,
      [&]
      {
        const hasp::testing::TracedVolume<std::int16_t> scene(samples, g, 0.5);
        hasp::TracedPicture picture;
        scene.tracer.TracePicture(view, picture);
        return picture;
      });
  };
  const hasp::TracedPicture one = draw(1);
  for (const int threads : { 2, 3, 8 })
  {
    const hasp::TracedPicture many = draw(threads);
    EXPECT_EQ(many.cells, one.cells) << threads;
    EXPECT_EQ(many.places, one.places) << threads;
    EXPECT_EQ(many.corners, one.corners) << threads;
    EXPECT_EQ(many.gradients, one.gradients) << threads;
  }
}

} // namespace
