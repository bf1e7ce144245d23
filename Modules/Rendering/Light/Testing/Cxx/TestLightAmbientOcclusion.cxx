// The same darkened where they are close; sixteen frames, so that the light has added up.
#include "LightPicture.h"

int TestLightAmbientOcclusion(int argc, char* argv[])
{
  return hasp::testing::DrawLightPicture(vtkHaspLightPass::AmbientOcclusion, 16, argc, argv);
}
