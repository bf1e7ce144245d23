// The scene of MixedScene.h, its opaque isosurfaces traced.
#include "MixedScene.h"

int TestTracedCellScene(int argc, char* argv[])
{
  return hasp::testing::CheckMixedScene(
    argc, argv, [](vtkHaspClusteredCellMapper* mapper) { mapper->SetRendererToTrace(); });
}
