// The scene of MixedScene.h, its opaque isosurfaces from ray caches, once these are complete.
#include "MixedScene.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspRayCachingMapper.h"

int TestRayCachingScene(int argc, char* argv[])
{
  const auto prepare = [](vtkHaspRayCachingMapper* mapper)
  {
    mapper->SetModeToCache();
    mapper->SetRenderer(vtkHaspClusteredCellMapper::Rasterize);
  };
  return hasp::testing::CheckMixedScene<vtkHaspRayCachingMapper>(argc, argv, prepare, 60);
}
