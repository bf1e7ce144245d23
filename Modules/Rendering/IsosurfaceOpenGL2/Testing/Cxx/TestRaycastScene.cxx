// The scene of MixedScene.h, its opaque isosurfaces by a ray a pixel.
#include "MixedScene.h"
#include "vtkHaspRayCachingMapper.h"

int TestRaycastScene(int argc, char* argv[])
{
  return hasp::testing::CheckMixedScene<vtkHaspRayCachingMapper>(
    argc, argv, [](vtkHaspRayCachingMapper* mapper) { mapper->SetModeToRaycast(); });
}
