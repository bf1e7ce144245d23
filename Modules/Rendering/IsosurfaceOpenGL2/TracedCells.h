#ifndef TracedCells_h
#define TracedCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>

class CellLight;
class CellTracing;
struct CellScene;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

/// A traced picture in an OpenGL context: as textures, drawn as one rectangle whose fragments are
/// shaded as rasterised ones are. Threads: RENDER, with the context current.
class TracedCells
{
public:
  TracedCells();
  ~TracedCells();
  TracedCells& operator=(TracedCells&&);

  /// Nothing if the picture is there. selection: cell numbers are needed, too. light: of the
  /// picture, or null. Throws std::runtime_error.
  void Upload(vtkOpenGLRenderWindow* window, const CellTracing& tracing, bool selection,
    const CellLight* light);
  void Draw(vtkShaderProgram* program, const CellTracing& tracing, const CellScene& scene) const;
  void Release();
  std::size_t Bytes() const { return this->ByteCount; } ///< without light
  std::size_t LightBytes() const { return this->LightByteCount; }
  double UploadMilliseconds() const { return this->Milliseconds; } ///< of the picture there

private:
  vtkSmartPointer<vtkTextureObject> Gradients, Numbers, Light;
  unsigned int VertexArray = 0;
  void UploadLight(
    vtkOpenGLRenderWindow* window, const CellTracing& tracing, const CellLight* light);

  std::size_t ByteCount = 0, LightByteCount = 0;
  double Milliseconds = 0.0;
  vtkMTimeType PictureTime = 0, LightTime = 0;
};

#endif
