// The same in daylight that is kept, of three bounces; sixteen frames.
#include "LightPicture.h"

int TestLightTraced(int argc, char* argv[])
{
  return hasp::testing::DrawLightPicture(vtkHaspLightPass::Traced, 16, argc, argv);
}
