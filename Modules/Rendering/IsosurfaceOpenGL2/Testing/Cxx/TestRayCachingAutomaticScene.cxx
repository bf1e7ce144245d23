// The scene of MixedScene.h, its opaque isosurfaces by what is fastest, once that is decided.
#include "MixedScene.h"
#include "vtkHaspRayCachingMapper.h"

int TestRayCachingAutomaticScene(int argc, char* argv[])
{
  return hasp::testing::CheckMixedScene<vtkHaspRayCachingMapper>(
    argc, argv, [](vtkHaspRayCachingMapper* mapper) { mapper->SetModeToAutomatic(); }, 60);
}
