#ifndef SplatTargets_h
#define SplatTargets_h

#include "vtkHaspRenderingSharedModule.h" // for export macro

#include "vtkOpenGLFramebufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <glm/vec2.hpp>

#include <cstddef>
#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// The textures of splats that are blended where something visible was hit: depth of the hits, with
/// what else they write; and the sums of what splats add, in floating point. As large as the
/// window, so that gl_FragCoord is that of the window. Threads: RENDER, with the context current.
class VTKHASPRENDERINGSHARED_EXPORT SplatTargets
{
public:
  struct Shape
  {
    glm::ivec2 size{ 0 };  ///< pixels
    bool numbered = false; ///< hits write a number of their own, as a float
    std::vector<int> sums; ///< components of each, 1 or 4
    bool operator==(const Shape&) const = default;
  };
  /// hits draws with depth test and without blending, splats draws adding and without depth test.
  /// What is drawn to stays so. Throws std::runtime_error if the textures cannot be made; passes on
  /// what the two throw. Nothing is kept then.
  void Draw(vtkOpenGLRenderWindow* window, const Shape& shape, const std::function<void()>& hits,
    const std::function<void()>& splats);

  /// Makes a texture known to a program; until Deactivate.
  void SampleDepth(vtkShaderProgram* program, const char* name);
  void SampleNumber(vtkShaderProgram* program, const char* name);
  void SampleSum(std::size_t n, vtkShaderProgram* program, const char* name);
  void Deactivate();

  void Release();
  std::size_t Bytes() const;

private:
  void Allocate(vtkOpenGLRenderWindow* window, const Shape& shape);
  void DrawHits(vtkOpenGLRenderWindow* window, const std::function<void()>& hits);
  void DrawSplats(vtkOpenGLRenderWindow* window, const std::function<void()>& splats);

  Shape Made;
  vtkSmartPointer<vtkTextureObject> Depth, Number;
  std::vector<vtkSmartPointer<vtkTextureObject>> Sums;
  vtkSmartPointer<vtkOpenGLFramebufferObject> HitTarget, SumTarget;
};

/// Draws one triangle over the viewport: its vertices are gl_VertexID 0, 1, 2.
VTKHASPRENDERINGSHARED_EXPORT void DrawViewportTriangle();

#endif
