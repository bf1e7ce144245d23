#ifndef OcclusionCulling_h
#define OcclusionCulling_h

#include "CellDraws.h"

#include "vtkWeakPointer.h"

#include <functional>

class CellBuffers;
struct CellScene;
class vtkObject;
class vtkOpenGLRenderWindow;

/// Draws only the clusters of opaque cells that something in front does not hide, and never leaves
/// out one that shows (visibility buffer; Paper VI). Each frame
///   1. draws the clusters that were seen in the last one,
///   2. draws, where nothing is written, boxes of all clusters against that depth; a fragment that
///      passes notes that its cluster is seen,
///   3. draws the clusters that are seen now and were not drawn in 1.
/// Steps 2 and 3 go over the clusters in pieces from front to back, so that a first frame, or one
/// after a jump of the camera, gains too. What is drawn is decided on the GPU: a compute shader
/// writes the draw commands, and nothing is read back.
/// The second eye of a frame in stereo starts from what the first one saw, and tests the boxes of
/// the other clusters alone.
///
/// A box is grown by more than a pixel and the rounding of depth, so a cluster whose box is hidden
/// is hidden. Boxes that cross the near plane count as seen. Whatever is in the depth buffer
/// already hides, too. Clipped parts of the surface do not, nor do they let a hidden box through.
///
/// 24 bytes a cluster on the GPU. Threads: RENDER, with the context current.
class OcclusionCulling
{
public:
  /// What is drawn, and for whom: each (renderer, actor) remembers on its own what it saw, up to
  /// seven of them; one more takes the place of the first.
  struct Frame
  {
    vtkOpenGLRenderWindow* window;
    vtkObject *renderer, *actor;
    bool leftEye; ///< the one that is drawn first
    const CellScene& scene;
    const CellBuffers& buffers;
    const CellDraws& draws;
    /// Binds the program that shades cells.
    std::function<void()> ready;
    /// Sets its uniforms for a range, whose buffers are bound.
    std::function<void(const DrawRange&)> prepare;
  };

  /// Nothing has been seen of these cells. Throws std::runtime_error if the GPU has no memory or
  /// the shaders do not compile.
  void Reset(const hasp::ClusteredCells& cells);
  void Release();
  bool Ready() const { return this->States != 0; }
  std::size_t Bytes() const { return this->ByteCount; }
  void Draw(const Frame& frame);

private:
  struct Viewer
  {
    vtkWeakPointer<vtkObject> renderer, actor;
    bool leftEye = false; ///< of its last frame
  };
  int ViewerOf(const Frame& frame);
  /// Binds what a range needs, and no more, so that no number of clusters is too large for a
  /// storage block: a part's clusters fit one (DivideClusters), at 96 bytes each; here 16 is the
  /// most. Attributes of cells take the same slots while cells are drawn.
  void Bind(const Frame& frame, const DrawRange& range) const;
  void WriteCommands(
    const Frame& frame, const DrawRange& range, int viewer, bool late, bool keep = false) const;
  void TestBoxes(const Frame& frame, const DrawRange& range, int viewer) const;
  void DrawCells(const Frame& frame, const DrawRange& range) const;

  unsigned int States = 0, Order = 0, Commands = 0, CommandProgram = 0;
  std::size_t ByteCount = 0;
  std::vector<Viewer> Viewers;
  std::size_t NextViewer = 0;
};

#endif
