// The same by 64 paths a pixel.
#include "LightPicture.h"

int TestLightPathTraced(int argc, char* argv[])
{
  return hasp::testing::DrawLightPicture(vtkHaspLightPass::PathTraced, 1, argc, argv);
}
