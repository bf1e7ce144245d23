#ifndef TracedCells_h
#define TracedCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>

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

  /// Nothing if the picture is there. selection: cell numbers are needed, too. Throws
  /// std::runtime_error.
  void Upload(vtkOpenGLRenderWindow* window, const CellTracing& tracing, bool selection);
  void Draw(vtkShaderProgram* program, const CellTracing& tracing, const CellScene& scene) const;
  void Release();
  std::size_t Bytes() const { return this->ByteCount; }
  double UploadMilliseconds() const { return this->Milliseconds; } ///< of the picture there

private:
  vtkSmartPointer<vtkTextureObject> Gradients, Numbers;
  unsigned int VertexArray = 0;
  std::size_t ByteCount = 0;
  double Milliseconds = 0.0;
  vtkMTimeType PictureTime = 0;
};

#endif
