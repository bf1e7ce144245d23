#include "RivalLibrary.h"

extern "C"
{
  void HaspMaurerRival(hasp::RivalTransform& rival, int)
  {
    rival = hasp::MakeMaurerRival();
  }
  void HaspFogRival(hasp::RivalTransform& rival, int)
  {
    rival = hasp::MakeFogRival();
  }
  void HaspMeshRival(hasp::RivalTransform& rival, int bandVoxels)
  {
    rival = hasp::MakeMeshRival(bandVoxels);
  }
}
