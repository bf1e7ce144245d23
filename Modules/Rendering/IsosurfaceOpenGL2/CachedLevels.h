#ifndef CachedLevels_h
#define CachedLevels_h

#include "Isosurface/ClusteredCells.h"

#include <memory>
#include <string>
#include <vector>

class vtkActor;
class vtkCommand;
class vtkHaspRayCachingMapper;
class vtkRenderer;
class vtkWindow;

/// Draws the levels of a cache, each with a clustered-cell mapper of its own: a level is a volume
/// with longer cells. Threads: RENDER.
class CachedLevels
{
public:
  /// hearsErrors: what the mappers say is wrong.
  explicit CachedLevels(vtkCommand* hearsErrors);
  ~CachedLevels();

  /// What level n draws from now on; null: nothing, and its mapper goes at the next Draw.
  void Set(std::size_t n, std::shared_ptr<const hasp::ClusteredCells> cells);
  /// As `mapper` would be drawn: with its clipping planes and renderer.
  void Draw(vtkHaspRayCachingMapper* mapper, vtkRenderer* renderer, vtkActor* actor);
  void Release(vtkWindow* window);
  void Clear();

  /// What drew the level with the most cells, and why.
  std::string RendererText() const;
  std::size_t Bytes() const;        ///< of the copies
  std::size_t DrawingBytes() const; ///< of what draws them: buffers, or trees and pictures
  double DrawMilliseconds = 0.0;    ///< of the last Draw, until OpenGL had taken the commands

private:
  struct Level;
  vtkCommand* HearsErrors;
  std::vector<std::unique_ptr<Level>> Levels;
};

#endif
