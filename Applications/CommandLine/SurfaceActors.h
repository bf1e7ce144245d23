#pragma once
#include "Grid/ResourceUse.h"
#include "VolumeLook.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkHaspClusteredCells;
class vtkImageData;
class vtkProp3D;

namespace hasp
{

struct Session;

using WorldPoint = std::array<double, 3>; ///< patient LPS, mm

/// A box around something: x from, to, y from, to, z from, to in world mm.
using WorldBounds = std::array<double, 6>;

/// What a box around a scene is known from.
struct ContentBox
{
  WorldBounds bounds{};
  bool ofVolume = false; ///< around the whole volume, air and table too: the surface is not known
};

/// Something drawn, and how to ask it and change it. RENDER thread.
struct SurfaceActor
{
  vtkSmartPointer<vtkProp3D> prop;
  std::function<void(ResourceList&)> listResources; ///< after drawing
  std::function<bool()> refining{};                 ///< will the next frame show more? Empty: never
  std::function<void(double)> setIsoValue{};        ///< empty: it has none, or its own
  /// Red, green, blue in [0, 1]; empty: the prop's property says it.
  std::function<void(const std::array<double, 3>&)> setColor{};
  std::function<std::string()> drewBy{}; ///< what drew last: "cache", "traced"
  /// Where the line first meets it; empty: it cannot be asked.
  std::function<std::optional<WorldPoint>(const WorldPoint& from, const WorldPoint& to)> pick{};
  /// Of what is drawn now, none if that is nothing; empty: known by the volume alone. May take as
  /// long as extracting the active cells.
  std::function<std::optional<WorldBounds>()> bounds{};
};

/// The names that --mapper takes in this build for an isosurface, the default of `hasp render`
/// first: "cells" (active cells, exact), "raycaching" (vtkHaspRayCachingMapper), "raycast" (a ray a
/// pixel on the GPU), "mesh" (vtkFlyingEdges3D), "vtk" (VTK's own GPU volume mapper).
const std::vector<std::string>& SurfaceMappers();

/// Those that it takes for what has no surface: "mip" (the brightest value along each line of
/// sight), "composite" (translucent skin and bone).
const std::vector<std::string>& VolumeMappers();

/// How a volume is made a picture of.
struct SurfaceDrawing
{
  std::string mapper = SurfaceMappers().front();
  /// For a window: a frame soon, the rest while nothing happens. Else one picture, soon complete.
  bool interactive = false;
  std::string renderer = "automatic";       ///< a name of CellRendererNames()
  bool compact = false;                     ///< 8 bits a corner; of a volume's cells only
  bool blendNormals = false;                ///< between neighbouring cells; of mapper cells only
  std::optional<double> ambientOcclusionMm; ///< how far what darkens may be
  bool shadows = false;                     ///< of the scene's first light
  VolumeLook look;                          ///< of VolumeMappers() only
  bool Lit() const { return this->ambientOcclusionMm || this->shadows; }
};

/// The names that --renderer takes, the default first: what draws active cells.
const std::vector<std::string>& CellRendererNames();

/// The isosurface through the mapper of that name; the other mappers are listed as skipped. Throws
/// Failure: WrongUse for an unknown name, or a renderer that this build lacks.
SurfaceActor MakeIsosurface(
  vtkImageData* image, double isoValue, const SurfaceDrawing& drawing, Session& session);

/// What the mapper of that name shows, be it an isosurface or not; `mip` takes no isovalue. Throws
/// as MakeIsosurface.
SurfaceActor MakeVolume(
  vtkImageData* image, double isoValue, const SurfaceDrawing& drawing, Session& session);

/// Active cells as they are. Throws Failure: WrongUse in a build that cannot draw them.
SurfaceActor MakeCells(vtkHaspClusteredCells* cells, const SurfaceDrawing& drawing);

/// The triangles of a surface file, called "surface 2" by its number. Throws Failure: BadInput.
SurfaceActor MakeSurface(const std::string& path, std::size_t number, Session& session);

} // namespace hasp
