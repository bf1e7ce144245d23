// The scene of MixedScene.h, rasterised from compact cells.
#include "MixedScene.h"

int TestCompactCells(int argc, char* argv[])
{
  return hasp::testing::CheckMixedScene(argc, argv,
    [](vtkHaspClusteredCellMapper* mapper)
    {
      mapper->SetRendererToRasterize();
      mapper->SetPrecisionToCompact();
    });
}
