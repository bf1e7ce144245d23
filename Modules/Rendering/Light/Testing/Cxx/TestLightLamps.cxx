// A lamp's shadows of bone, metal and floor on each other.
#include "LightPicture.h"

int TestLightLamps(int argc, char* argv[])
{
  return hasp::testing::DrawLightPicture(vtkHaspLightPass::Lamps, 1, argc, argv);
}
