#pragma once
#include "IsosurfaceMethods.h"

namespace hasp
{

struct NamedMethod
{
  std::string id; ///< in a row's id: "rasterize", "trace"
  std::unique_ptr<IsosurfaceMethod> method;
};

/// Every way to draw clustered cells that this build has, the one first that a scene gets that asks
/// for nothing. The view must outlive them.
std::vector<NamedMethod> CellRenderers(const IsosurfaceView& view);

/// CellTracer alone, a ray a pixel, no window. Null in a build without Embree.
std::unique_ptr<IsosurfaceMethod> MakeTracerMethod(const IsosurfaceView& view);

} // namespace hasp
