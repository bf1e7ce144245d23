// The scene of MixedScene.h, its opaque isosurfaces from ray caches, once these are complete.
#include "MixedScene.h"
#include "vtkHaspRayCachingMapper.h"

int TestRayCachingScene(int argc, char* argv[])
{
  return hasp::testing::CheckMixedScene<vtkHaspRayCachingMapper>(
    argc, argv, [](vtkHaspRayCachingMapper* mapper) { mapper->SetModeToCache(); }, 60);
}
