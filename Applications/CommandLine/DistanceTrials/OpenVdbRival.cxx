#include "RivalLibrary.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/FastSweeping.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/Morphology.h>
#include <openvdb/tools/VolumeToMesh.h>

namespace hasp
{
namespace
{

namespace vdb = openvdb;
using Dense = vdb::tools::Dense<float, vdb::tools::LayoutXYZ>; // x fastest

constexpr int BandVoxels = 4;

vdb::CoordBBox BoxOf(const GridGeometry& grid)
{
  return { vdb::Coord(0), vdb::Coord(grid.dims.x - 1, grid.dims.y - 1, grid.dims.z - 1) };
}

/// Coverage as a fog volume, in index units.
vdb::FloatGrid::Ptr FogOf(const TransformInput& input)
{
  const auto fog = vdb::FloatGrid::create(0.0F);
  const Dense dense(BoxOf(input.grid), const_cast<float*>(input.coverage.data())); // read alone
  vdb::tools::copyFromDense(dense, *fog, 0.0F);
  return fog;
}

/// Both work in index units on cubes.
class VdbRun : public RivalRun
{
public:
  explicit VdbRun(const TransformInput& input) : Grid(input.grid) {}
  std::vector<float> Distances() const override
  {
    std::vector<float> distances(this->Grid.Size());
    Dense dense(BoxOf(this->Grid), distances.data());
    vdb::tools::copyToDense(*this->Result, dense);
    for (float& distance : distances)
      distance *= static_cast<float>(this->Grid.spacing.x);
    return distances;
  }

protected:
  GridGeometry Grid;
  vdb::FloatGrid::Ptr Result;
};

class FogRun final : public VdbRun
{
public:
  explicit FogRun(const TransformInput& input) : VdbRun(input), Fog(FogOf(input))
  {
    // Active: what is partial or next to it, and four voxels around.
    vdb::MaskTree near(false);
    for (auto value = this->Fog->cbeginValueOn(); value; ++value)
      if (value.isVoxelValue() && *value < 1.0F)
        near.setValueOn(value.getCoord());
    vdb::tools::dilateActiveValues(
      near, BandVoxels, vdb::tools::NN_FACE_EDGE_VERTEX, vdb::tools::EXPAND_TILES);
    this->Fog->tree().topologyUnion(near);
    this->Fog->tree().topologyIntersection(near);
  }
  void Run() override { this->Result = vdb::tools::fogToSdf(*this->Fog, 0.5F); }

private:
  vdb::FloatGrid::Ptr Fog;
};

class MeshRun final : public VdbRun
{
public:
  MeshRun(const TransformInput& input, int band)
    : VdbRun(input),
      Fog(FogOf(input)),
      Band(static_cast<float>(band))
  {
  }
  void Run() override
  {
    std::vector<vdb::Vec3s> points;
    std::vector<vdb::Vec3I> triangles;
    std::vector<vdb::Vec4I> quads;
    vdb::tools::volumeToMesh(*this->Fog, points, triangles, quads, 0.5);
    this->Result = vdb::tools::meshToSignedDistanceField<vdb::FloatGrid>(
      *vdb::math::Transform::createLinearTransform(1.0), points, triangles, quads, this->Band,
      this->Band);
  }

private:
  vdb::FloatGrid::Ptr Fog;
  float Band;
};

RivalTransform Named(const std::string& key, const std::string& settings)
{
  vdb::initialize();
  RivalTransform rival;
  rival.key = key;
  rival.name = std::string("OpenVDB ") + vdb::getLibraryVersionString() + " " + settings;
  return rival;
}

} // namespace

RivalTransform MakeFogRival()
{
  RivalTransform rival =
    Named("openvdb.fog", "fogToSdf of coverage at 0.5, 4 voxels around what is partial");
  rival.band = true;
  rival.make = [](const TransformInput& input) { return std::make_unique<FogRun>(input); };
  return rival;
}

RivalTransform MakeMeshRival(int bandVoxels)
{
  RivalTransform rival = Named(bandVoxels > BandVoxels ? "openvdb.mesh.far" : "openvdb.mesh",
    "volumeToMesh of coverage at 0.5, meshToSignedDistanceField out to " +
      std::to_string(bandVoxels) + " voxels");
  rival.band = bandVoxels <= BandVoxels;
  rival.make = [bandVoxels](const TransformInput& input)
  { return std::make_unique<MeshRun>(input, bandVoxels); };
  return rival;
}

} // namespace hasp
