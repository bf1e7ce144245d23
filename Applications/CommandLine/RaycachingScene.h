#pragma once
#include "CachingMethod.h"
#include "CameraPaths.h"
#include "CellScene.h"
#include "PictureErrors.h"

namespace hasp
{

struct ReportContext;

/// A volume, a picture size and the first view of a recorded path.
struct RaycachingScene
{
  const CellScene& cells;
  int pixels;
  std::string data; ///< of rows

  RaycachingScene(const CellScene& cells, int pixels);
  IsosurfaceView View() const;
};

/// The picture as it should be: `samples` x `samples` rays a pixel against all active cells, shaded
/// as every method of ours shades.
PictureTruth TrueRaycachingPicture(const IsosurfaceView& view, double isovalue, int samples = 4);

/// The parts of `hasp report raycaching`. Each checks what it measures and puts rows into the
/// report. RENDER thread.

/// raycaching.speedup.*: orbit, against direct ray casts and VTK's volume mapper
void ReportRaycachingFrames(ReportContext& context, const RaycachingScene& scene);
/// raycaching.psnr, .depth.median, .holes, .bricks.unique
void ReportRaycachingQuality(ReportContext& context, const RaycachingScene& scene);
/// raycaching.cost.isovalue, .first95 and the curves after a cut and after a jump
void ReportRaycachingChanges(ReportContext& context, const RaycachingScene& scene);

} // namespace hasp
