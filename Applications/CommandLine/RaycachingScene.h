#pragma once
#include "CachingMethod.h"
#include "CameraPaths.h"
#include "CellScene.h"
#include "Grid/GridView.h"
#include "Isosurface/PictureRays.h"
#include "PictureErrors.h"

#include <functional>

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
  /// Of pictures with light: from the side, above and behind the first view's eye; unit, world.
  glm::dvec3 TowardsLight() const;
  static constexpr double Ambient = 0.3, Diffuse = 0.7; ///< of the bone there; white
  static constexpr double DarkeningMm = 25.0;           ///< how far away what darkens may be
};

/// A recorded path, from the scene's first view: places the camera, gives the frame's isovalue.
struct RecordedPath
{
  std::string id;   ///< of rows: "orbit", "fly", "jitter", "sweep"
  std::string text; ///< "orbit 1 degree a frame"
  std::function<double(int frame)> go;
};
/// All there are, for any number of frames; they move `view`, which must outlive them.
std::vector<RecordedPath> RecordedPaths(const RaycachingScene& scene, IsosurfaceView& view);

/// As kernels see it, in the grid's index coordinates.
PictureView IndexView(const IsosurfaceView& view, const AnyGridView& grid);

/// The picture as it should be: `samples` x `samples` rays a pixel against all active cells, shaded
/// as every method of ours shades.
PictureTruth TrueRaycachingPicture(const IsosurfaceView& view, double isovalue, int samples = 4);

/// One exact ray through each pixel's centre, on the CPU: what a picture of one ray a pixel should
/// be. A window's 8 bits alone make 58.9 dB of a perfect one.
PictureTruth CentreRaycachingPicture(const IsosurfaceView& view, double isovalue);

/// A white surface under a white light, as the mappers' shaders have it (without what hides the
/// light). All in the world; toEye and towardsLight unit, the normal of any sign.
double DiffuseShade(
  const glm::dvec3& gradient, const glm::dvec3& toEye, const glm::dvec3& towardsLight);

/// Share of the pixels with surface where nothing is shown. Draws `exact`.
double HoleShare(IsosurfaceMethod& exact, IsosurfaceMethod& shown);

/// "33.1 dB"
std::string Decibels(double psnr);

/// The parts of `hasp report raycaching`. Each checks what it measures and puts rows into the
/// report. RENDER thread.

/// raycaching.speedup.*: all paths, against direct ray casts and VTK's volume mapper
void ReportRaycachingFrames(ReportContext& context, const RaycachingScene& scene);
/// raycaching.psnr, .depth.median, .holes, .bricks.unique
void ReportRaycachingQuality(ReportContext& context, const RaycachingScene& scene);
/// raycaching.head.*: a minute before a screen
void ReportRaycachingHead(ReportContext& context, const RaycachingScene& scene);
/// raycaching.stereo.*, cells.stereo.*
void ReportRaycachingStereo(ReportContext& context, const RaycachingScene& scene);
/// raycaching.cost.lit
void ReportRaycachingLight(ReportContext& context, const RaycachingScene& scene);
/// raycaching.ao.*
void ReportRaycachingStillLight(ReportContext& context, const RaycachingScene& scene);
/// raycaching.cost.isovalue, .first95 and the curves after a cut and after a jump
void ReportRaycachingChanges(ReportContext& context, const RaycachingScene& scene);
/// raycaching.soak.*: a walk of context.settings.soakFrames
void ReportRaycachingSoak(ReportContext& context, const RaycachingScene& scene);

} // namespace hasp
