#ifndef NormalBlending_h
#define NormalBlending_h

#include "SplatTargets.h"

#include <cstddef>
#include <functional>

struct CellScene;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// Draws opaque cells with normals and colours blended between neighbours (EWA-like; Paper VI), in
/// three passes: depth of the hits, into a texture; what every cell adds to the hits in its
/// support, summed in floating-point textures; and one triangle over the viewport that shades and
/// writes depth. Textures are as large as the window: 24 bytes a pixel, 56 with colours of cells.
/// Threads: RENDER, with the context current.
class NormalBlending
{
public:
  /// `hits` draws all cells in CellPass::Hits; `splats` readies CellPass::Splats, calls what it is
  /// given with that program, and draws all cells. Throws std::runtime_error if the textures cannot
  /// be made or a shader does not compile.
  using Textures = std::function<void(vtkShaderProgram*)>;
  void Draw(vtkOpenGLRenderWindow* window, const CellScene& scene, bool colored,
    const std::function<void()>& hits, const std::function<void(const Textures&)>& splats);
  void Release() { this->Targets.Release(); }
  std::size_t Bytes() const { return this->Targets.Bytes(); }

private:
  void Resolve(vtkOpenGLRenderWindow* window, const CellScene& scene, bool colored);

  SplatTargets Targets; ///< sums: normal; diffuse, ambient if colored
};

#endif
