#ifndef VolumeRaycast_h
#define VolumeRaycast_h

#include "VolumeTextures.h"
#include "WindowContext.h"

#include "vtkType.h"

struct CellScene;
class vtkActor;
class vtkHardwareSelector;
class vtkMapper;
class vtkRenderer;
class vtkShaderProgram;

/// What a raycast is made of. volumeTime tells volumes apart, changes in place do not count.
struct RaycastVolume
{
  hasp::AnyGridView grid;
  const hasp::MinMaxBlocks& blocks;
  vtkMTimeType volumeTime;
  double isovalue;
};

struct RaycastSettings
{
  bool skipping = false; ///< pass blocks without surface in one step
  double stepSize = 1.0; ///< voxels; less than a block of 8
};

/// Draws the isosurface of a volume by a ray a pixel on the GPU (vtkHaspVolumeRaycastFS.glsl): in
/// the OpenGL context of one window. Nothing but the samples, once, and the min-max blocks, where
/// they are used, is uploaded. Threads: RENDER.
class VolumeRaycast
{
public:
  explicit VolumeRaycast(vtkOpenGLRenderWindow* window) : Home(window) {}
  ~VolumeRaycast() { this->Free(nullptr); }
  VolumeRaycast(const VolumeRaycast&) = delete;
  VolumeRaycast& operator=(const VolumeRaycast&) = delete;

  bool IsOf(vtkOpenGLRenderWindow* window) const { return this->Home.IsOf(window); }
  bool IsLost() const { return this->Home.IsLost(); }
  /// Lets go of everything. To be called for a window that is being deleted.
  void Free(vtkOpenGLRenderWindow* window);

  /// The samples [low, high], both included, and blocks that hold them have changed in place.
  void MarkModified(const glm::ivec3& low, const glm::ivec3& high);
  /// The context must be current. Throws std::runtime_error, in words for the user.
  void Draw(const RaycastVolume& volume, const RaycastSettings& settings, vtkMapper* mapper,
    vtkRenderer* renderer, vtkActor* actor);

  const VolumeTextures& Textures() const { return this->Held; }
  double SamplesMilliseconds = 0.0, BlocksMilliseconds = 0.0, ShaderMilliseconds = 0.0;

private:
  void Update(const RaycastVolume& volume, bool skipping);
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const RaycastVolume& volume,
    const CellScene& scene, bool skipping, vtkHardwareSelector* selector);
  void DrawParts(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);

  WindowContext Home;
  VolumeTextures Held;
  vtkMTimeType HeldTime = 0; ///< of the volume
  glm::ivec3 ChangedLow{ 0 }, ChangedHigh{ -1 };
  unsigned int VertexArray = 0;
};

#endif
