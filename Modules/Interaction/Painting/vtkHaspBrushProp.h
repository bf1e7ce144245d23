#ifndef vtkHaspBrushProp_h
#define vtkHaspBrushProp_h

#include "SeenDepth.h"

#include "Grid/ResourceUse.h"

#include "vtkHaspInteractionPaintingModule.h" // for export macro: tests
#include "vtkProp.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

#include <optional>

class vtkActor;
class vtkActor2D;
class vtkOpenGLSphereMapper;
class vtkPoints;
class vtkRenderer;

/**
 * @class   vtkHaspBrushProp
 * @brief   A painter's part in a renderer's frame: it copies the depth, then draws the brush.
 *
 * The depth is taken after all that is opaque and before all that lies over the picture: texts,
 * strokes (vtkHaspStrokeActor) and the brush itself are not in it, nor is what later layers draw,
 * which clear it. With two eyes it is the left one's. Nothing is copied unless SetLook is on.
 *
 * The brush is a ring of radiusMm about a place, in the plane through it that is parallel to the
 * screen, or in a slice's, projected by the frame's own matrix and drawn over everything, two
 * pixels wide at 72 dpi; and, on a surface, a translucent ball that is hidden by what is before it.
 * It has no bounds, cannot be picked and is not there in selections.
 *
 * Limits: a render pass that draws elsewhere than into the window's framebuffer (vtkSSAAPass) has
 * no depth there. With UseDepthPeelingForVolumes VTK asks for it late: strokes may then be in it.
 * Threads: RENDER.
 */
class VTKHASPINTERACTIONPAINTING_EXPORT vtkHaspBrushProp : public vtkProp
{
public:
  static vtkHaspBrushProp* New();
  vtkTypeMacro(vtkHaspBrushProp, vtkProp);

  /// The viewport and matrix of a frame through this renderer as it is now, of two eyes the left
  /// one's; no depth.
  static hasp::SeenDepth ViewOf(vtkRenderer* renderer);

  /// Frames copy their depth from now on; else the copy is freed with the next one.
  void SetLook(bool look) { this->Look = look; }
  /// While it is on the copy is kept through frames with the same view, whatever they show.
  void SetKeep(bool keep) { this->Keep = keep; }
  /// Of the last frame; null if it was not copied.
  const hasp::SeenDepth* GetSeen() const { return this->Fresh ? &this->Seen : nullptr; }
  void Forget(); ///< the copy

  struct Brush
  {
    glm::dvec3 world{ 0.0 };
    double radiusMm = 1.0;
    glm::dvec3 colour{ 1.0 };
    std::optional<glm::dvec3> normal; ///< of the ring's plane; none: parallel to the screen
    bool ball = true;
    bool operator==(const Brush&) const noexcept = default;
  };
  /// None: nothing is drawn. True if that changes the picture.
  bool SetBrush(const std::optional<Brush>& brush);
  const std::optional<Brush>& GetBrush() const { return this->Shown; }

  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  void ListResources(hasp::ResourceList& resources) const;

protected:
  vtkHaspBrushProp();
  ~vtkHaspBrushProp() override;

private:
  vtkHaspBrushProp(const vtkHaspBrushProp&) = delete;
  void operator=(const vtkHaspBrushProp&) = delete;

  void TakeDepth(vtkViewport* viewport);
  void DrawBall(vtkViewport* viewport);
  void DrawRing(vtkRenderer* renderer);

  bool Look = false, Keep = false, Fresh = false;
  bool Taken = false; ///< in this frame
  double Milliseconds = 0.0;
  hasp::SeenDepth Seen;
  std::optional<Brush> Shown;
  vtkSmartPointer<vtkActor2D> Ring;
  vtkSmartPointer<vtkPoints> RingPoints;
  vtkSmartPointer<vtkActor> Ball;
  vtkSmartPointer<vtkOpenGLSphereMapper> BallMapper;
};

#endif
