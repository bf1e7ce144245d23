#include "CellRenderers.h"

namespace hasp
{

std::vector<NamedMethod> CellRenderers(const IsosurfaceView& view)
{
  std::vector<NamedMethod> all;
  all.push_back({ "automatic", MakeCellMethod(view, CellDrawing::Automatic) });
  all.push_back({ "rasterize", MakeCellMethod(view, CellDrawing::Rasterize) });
  all.push_back({ "rasterize.all", MakeCellMethod(view, CellDrawing::RasterizeAll) });
#if HASP_WITH_RAYS
  all.push_back({ "trace", MakeCellMethod(view, CellDrawing::Trace) });
#endif
  return all;
}

} // namespace hasp
