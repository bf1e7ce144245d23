#include "SurfaceDistances.h"

#include <stdexcept>

namespace hasp
{

std::vector<float> SurfaceDistances(
  const TriangleMesh&, const GridGeometry&, double, const ProgressFunction&)
{
  throw std::runtime_error(
    "surface: this build has no OpenVDB, which measures surfaces; build with HASP_ENABLE_OPENVDB");
}

} // namespace hasp
