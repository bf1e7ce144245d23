#ifndef NormalBlending_h
#define NormalBlending_h

#include "vtkOpenGLFramebufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <glm/vec2.hpp>

#include <array>
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
  void Release();
  std::size_t Bytes() const;

private:
  void Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size, bool colored);
  void DrawHits(vtkOpenGLRenderWindow* window, const std::function<void()>& hits);
  void DrawSplats(
    vtkOpenGLRenderWindow* window, const std::function<void(const Textures&)>& splats);
  void Resolve(vtkOpenGLRenderWindow* window, const CellScene& scene);

  glm::ivec2 Size{ 0 };
  bool Colored = false;
  vtkSmartPointer<vtkTextureObject> Depth, Frame;
  std::array<vtkSmartPointer<vtkTextureObject>, 3> Sums; ///< normal; diffuse, ambient if Colored
  vtkSmartPointer<vtkOpenGLFramebufferObject> HitTarget, SumTarget;
};

#endif
