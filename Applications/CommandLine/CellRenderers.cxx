#include "CellRenderers.h"

namespace hasp
{

std::vector<NamedMethod> CellRenderers(const IsosurfaceView& view)
{
  std::vector<NamedMethod> all;
  all.push_back({ "rasterize", MakeCellMethod(view) });
  all.push_back({ "rasterize.all", MakeCellMethod(view, false) });
  return all;
}

} // namespace hasp
