#pragma once
#include "CameraOptions.h"
#include "SceneLight.h"
#include "SurfaceActors.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;
class vtkRenderer;

namespace hasp
{

struct Session;

struct SceneOptions
{
  double isoValue = 0.0; ///< of no meaning to mapper mip
  SurfaceDrawing drawing;
  LightChoices light;
  std::array<int, 2> resolution{ 800, 800 };            ///< pixels, of one eye
  std::array<double, 3> color{ 0.93, 0.87, 0.76 };      ///< of the isosurface, in [0,1]
  std::array<double, 3> background{ 0.10, 0.11, 0.13 }; ///< in [0,1]
  std::vector<std::string> surfaces;                    ///< files drawn with it
  CameraOptions camera;
};

/// An isosurface or what else a mapper shows of a volume, meshes, a camera and lamps in a renderer:
/// what a picture and a window show. The renderer must outlive it. RENDER thread.
class SurfaceScene
{
public:
  /// `volume` is a vtkImageData, or a vtkHaspClusteredCells, which has its own isovalue. Fills the
  /// renderer. Throws Failure: BadInput for a surface that cannot be read, CannotDraw.
  SurfaceScene(
    vtkRenderer* renderer, vtkDataObject* volume, const SceneOptions& options, Session& session);

  vtkRenderer* Renderer() const { return this->Shown; }
  /// Of the isosurface; nothing if it has its own.
  void SetIsoValue(double value);
  /// What drew the isosurface last: "cache", "active cells, traced".
  std::string DrewBy() const { return this->Surfaces.front().drewBy(); }
  /// Can the isosurface be asked for a point? VTK's own mapper cannot, and takes rays of ours.
  bool CanPick() const { return bool(this->Surfaces.front().pick); }
  /// Where the line first meets a surface.
  std::optional<WorldPoint> Pick(const WorldPoint& from, const WorldPoint& to) const;
  /// What the camera shows in a pixel of the window, from the lower left: from, to.
  std::optional<std::pair<WorldPoint, WorldPoint>> RayOf(int x, int y) const;
  /// The box around all that is shown; none around nothing. As slow as SurfaceActor::bounds.
  std::optional<ContentBox> Content() const;
  /// After drawing: what each surface holds.
  void ListResources(ResourceList& list) const;

  /// Call when something was changed: the picture is as incomplete as at first.
  void Restart() { this->Frames = this->Quiet = 0; }
  /// Call after each frame: will another one show more? Ends after mostFrames in any case.
  bool WantsFrame(int mostFrames);
  /// When it wants one: milliseconds until that is worth its time. What frames refine is better at
  /// once; paths need no frames, only time.
  int NextFrameMs() const { return this->NextMs; }
  /// Does a frame end only when all paths of its picture are traced? For pictures in files; a
  /// scene that is not interactive begins so.
  void SetWaitForPaths(bool wait);
  /// Is told the share of a long frame that is done, while it is drawn: of paths.
  void SetFrameProgress(std::function<void(double share)> progress);
  /// Of the frames that it takes in any case, the share that has been drawn.
  double ShareDrawn() const
  {
    return std::min(1.0, double(this->Frames) / double(this->LeastFrames));
  }

private:
  void Add(SurfaceActor surface, const std::array<double, 3>& color);

  vtkRenderer* Shown;
  std::vector<SurfaceActor> Surfaces; ///< the isosurface first
  std::unique_ptr<SceneLight> Light;  ///< that they share; null: each has its own
  int LeastFrames = 1;
  int QuietFrames = 1;       ///< without a find, until the picture is taken to be complete
  int Frames = 0, Quiet = 0; ///< since the last change; without a find, in a row
  int NextMs = 1;
};

} // namespace hasp
