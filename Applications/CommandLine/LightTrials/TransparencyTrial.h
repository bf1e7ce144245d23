#pragma once

namespace hasp
{

struct ReportContext;

/// How true pictures of 4, 6 and 8 translucent layers of cells and polydata are: by depth peeling,
/// by VTK's default weights, and blended without sorting, against all that each pixel's ray meets,
/// sorted on the CPU (LayerPicture.h). Rows light.transparency.*, the number of layers behind the
/// @: .max and .rms of each way, .time.weighted and .time.unsorted: peeling's time over theirs.
/// RENDER thread; windows must have been chosen.
void MeasureTransparency(ReportContext& context);
/// The rows of one number of layers, as LayerPicture takes them.
void MeasureLayers(ReportContext& context, int layers);

} // namespace hasp
