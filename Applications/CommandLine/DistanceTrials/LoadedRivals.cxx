#include "RivalLibrary.h"

#include <dlfcn.h>

namespace hasp
{
namespace
{

/// Looked for beside this program's libraries, as those are.
RivalTransform Loaded(const char* symbol, const char* key, int bandVoxels = 0)
{
  static void* const library = dlopen("libHaspDistanceRivals.so", RTLD_NOW | RTLD_LOCAL);
  RivalTransform rival;
  rival.key = key;
  if (void* fill = library ? dlsym(library, symbol) : nullptr)
    reinterpret_cast<FillRival*>(fill)(rival, bandVoxels);
  else
  {
    rival.name = std::string("the rival ") + key;
    rival.absent = "libHaspDistanceRivals.so, which has it, cannot be loaded: is it, and all that "
                   "it links, installed with this program?";
  }
  return rival;
}

} // namespace

RivalTransform MaurerRival()
{
  return Loaded(MaurerRivalSymbol, "itk");
}

RivalTransform FogRival()
{
  return Loaded(FogRivalSymbol, "openvdb.fog");
}

RivalTransform MeshRival(int bandVoxels)
{
  return Loaded(MeshRivalSymbol, bandVoxels > 4 ? "openvdb.mesh.far" : "openvdb.mesh", bandVoxels);
}

} // namespace hasp
