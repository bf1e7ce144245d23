// The scene of MixedScene.h, rasterised.
#include "MixedScene.h"

int TestClusteredCells(int argc, char* argv[])
{
  return hasp::testing::CheckMixedScene(
    argc, argv, [](vtkHaspClusteredCellMapper* mapper) { mapper->SetRendererToRasterize(); });
}
