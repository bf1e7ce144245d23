#include "CellScene.h"

#include "Grid/AnalyticVolumes.h"
#include "Grid/Phantom.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

namespace hasp
{
namespace
{

std::string Cube(int n)
{
  return ", " + std::to_string(n) + "^3 int16";
}

/// 64 mm across whatever the number of samples: only the voxel changes.
CellScene Analytic(const char* name, const AnalyticVolume& shape, int n)
{
  const GridGeometry geometry{ glm::ivec3(n), glm::dvec3(-32.0), glm::dvec3(64.0 / (n - 1)),
    glm::dmat3(1) };
  return { std::string("@") + name + std::to_string(n), std::string(name) + Cube(n),
    MakeImage(geometry, SampleAnalytic<std::int16_t>(shape, geometry, 1000.0, 0.0)), 0.0 };
}

} // namespace

CellScene HeadScene(int n, std::uint64_t seed, bool named)
{
  PhantomSettings settings;
  settings.blurMm = glm::dvec3(0.8);
  settings.noiseHU = 25.0;
  settings.seed = seed;
  const GridGeometry geometry = PhantomGridOfSize(glm::ivec3(n), settings);
  return { named ? "" : "@head" + std::to_string(n), "phantom head" + Cube(n) + ", 300 HU",
    MakeImage(geometry, SamplePhantom(geometry, settings)), 300.0 };
}

CellScene GyroidScene(int n)
{
  return Analytic("gyroid", AnalyticGyroid(16.0), n);
}

CellScene SpongyBoneScene(int n)
{
  return Analytic("bone", AnalyticTrabecular(31.0, 0.64, 6.4), n);
}

} // namespace hasp
