#include "RivalLibrary.h"

namespace hasp
{

RivalTransform MakeMaurerRival()
{
  RivalTransform rival;
  rival.key = "itk";
  rival.name = "ITK SignedMaurerDistanceMapImageFilter";
  rival.absent = "this build has no ITK (HASP_ENABLE_ITK; Utilities/Scripts/setup --develop)";
  rival.exact = true;
  return rival;
}

} // namespace hasp
