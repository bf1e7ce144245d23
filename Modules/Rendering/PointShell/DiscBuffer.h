#ifndef DiscBuffer_h
#define DiscBuffer_h

#include "DiscInput.h"

#include <cstddef>
#include <memory>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// Discs on the GPU, as they are in memory, read through buffer textures. Threads: RENDER, with the
/// context current.
class DiscBuffer
{
public:
  /// Uploads blocks of discs that are not those of last time; keeps the vector to compare with.
  /// Throws std::runtime_error, and holds none, if there are more than OpenGL can read or the GPU
  /// has room for.
  void Upload(std::shared_ptr<const Discs> discs);
  /// withBits: also as integers. Samplers are `discs` and `discBits`; until Unbind.
  void Bind(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, bool withBits);
  void Unbind(vtkOpenGLRenderWindow* window);
  /// Six vertices a disc, from number 0 on.
  void Draw() const;
  void Release();
  std::size_t Bytes() const { return this->Capacity * sizeof(hasp::ShellDisc); }
  /// By the last Upload that had something to do.
  std::size_t UploadedDiscs() const { return this->Uploaded; }

private:
  void Allocate(std::size_t count);

  std::shared_ptr<const Discs> Held;
  std::size_t Capacity = 0, Uploaded = 0;
  unsigned int Buffer = 0, Array = 0;
  unsigned int Textures[2] = { 0, 0 }; ///< floats; bits, once asked for
  int Units[2] = { -1, -1 };
};

#endif
