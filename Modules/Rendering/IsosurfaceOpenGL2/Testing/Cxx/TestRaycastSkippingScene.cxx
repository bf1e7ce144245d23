// The scene of MixedScene.h, its opaque isosurfaces by rays that skip blocks.
#include "MixedScene.h"
#include "vtkHaspRayCachingMapper.h"

int TestRaycastSkippingScene(int argc, char* argv[])
{
  return hasp::testing::CheckMixedScene<vtkHaspRayCachingMapper>(
    argc, argv, [](vtkHaspRayCachingMapper* mapper) { mapper->SetModeToRaycastSkipping(); });
}
