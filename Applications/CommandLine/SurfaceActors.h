#pragma once
#include "Grid/ResourceUse.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkHaspClusteredCells;
class vtkImageData;

namespace hasp
{

struct Session;

/// Something drawn, and how to ask what it uses (after drawing).
struct SurfaceActor
{
  vtkSmartPointer<vtkActor> actor;
  std::function<void(ResourceList&)> listResources;
  std::function<bool()> refining; ///< will the next frame show more? Empty: never
};

/// The names that --mapper takes in this build, the default first: "cells" (active cells, exact),
/// "raycaching" (vtkHaspRayCachingMapper), "raycast" (a ray a pixel on the GPU), "mesh"
/// (vtkFlyingEdges3D).
const std::vector<std::string>& SurfaceMappers();

/// How active cells are made and drawn.
struct CellDrawing
{
  std::string renderer = "automatic";       ///< a name of CellRendererNames()
  bool compact = false;                     ///< 8 bits a corner; of a volume's cells only
  std::optional<double> ambientOcclusionMm; ///< how far what darkens may be
  bool shadows = false;                     ///< of the scene's first light
  bool Lit() const { return this->ambientOcclusionMm || this->shadows; }
};

/// The names that --renderer takes, the default first: what draws active cells.
const std::vector<std::string>& CellRendererNames();

/// The isosurface through the mapper of that name; the other mapper is listed as skipped. Throws
/// Failure: WrongUse for an unknown name, or a renderer that this build lacks.
SurfaceActor MakeIsosurface(vtkImageData* image, double isoValue, const std::string& mapper,
  const CellDrawing& drawing, Session& session);

/// Active cells as they are. Throws Failure: WrongUse in a build that cannot draw them.
SurfaceActor MakeCells(vtkHaspClusteredCells* cells, const CellDrawing& drawing);

/// The triangles of a surface file, called "surface 2" by its number. Throws Failure: BadInput.
SurfaceActor MakeSurface(const std::string& path, std::size_t number, Session& session);

} // namespace hasp
