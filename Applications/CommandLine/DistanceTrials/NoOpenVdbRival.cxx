#include "RivalLibrary.h"

namespace hasp
{
namespace
{

RivalTransform Absent(const std::string& key, const std::string& name)
{
  RivalTransform rival;
  rival.key = key;
  rival.name = name;
  rival.absent = "this build has no OpenVDB (HASP_ENABLE_OPENVDB; Utilities/Scripts/setup)";
  rival.band = true;
  return rival;
}

} // namespace

RivalTransform MakeFogRival()
{
  return Absent("openvdb.fog", "OpenVDB fogToSdf");
}

RivalTransform MakeMeshRival(int bandVoxels)
{
  RivalTransform rival = Absent(bandVoxels > 4 ? "openvdb.mesh.far" : "openvdb.mesh",
    "OpenVDB volumeToMesh, meshToSignedDistanceField");
  rival.band = bandVoxels <= 4;
  return rival;
}

} // namespace hasp
