#ifndef PainterInternals_h
#define PainterInternals_h

#include "BrushTrail.h"
#include "SlicePlace.h"
#include "vtkHaspBrushProp.h"
#include "vtkHaspSeedPainter.h"

#include "vtkCallbackCommand.h"
#include "vtkImageSlice.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

/// What vtkHaspSeedPainter.cxx (what is said) and PainterEvents.cxx (what the pointer does) share.
/// Threads: RENDER.
struct vtkHaspSeedPainter::Internals
{
  explicit Internals(vtkHaspSeedPainter* of);
  ~Internals();

  void Follow(vtkRenderWindowInteractor* whose);
  bool Handle(unsigned long event); ///< true: nobody else's
  bool Move();
  bool HoverAt(const glm::ivec2& pixel);
  bool Press();
  bool Release();
  bool OtherPress(unsigned long event);
  bool OtherRelease(unsigned long event);
  bool Wheel(double factor, bool wheel);
  bool Key();
  void Leave();

  bool Ours(const glm::ivec2& pixel) const;
  bool ModifiersAsked() const;
  glm::ivec2 Pointer() const;

  void Begin(const glm::ivec2& pixel);
  void Extend(const glm::ivec2& pixel);
  void End();
  void UseBrush(); ///< label and radius as they are now

  /// What pixels show now, of a picture that is made where none was kept. Empty: nothing is shown.
  hasp::BrushTrail::Finder Look();
  std::optional<hasp::PixelPlace> InSlice(
    const hasp::SeenDepth& view, const glm::ivec2& pixel, const hasp::SlicePlane& plane);
  /// Shows the brush there; none: hides it. True if the picture changes.
  bool ShowBrush(const std::optional<hasp::PixelPlace>& place);
  void Draw();
  void LookAway();

  vtkHaspSeedPainter* const painter;
  vtkWeakPointer<vtkRenderer> renderer;
  vtkWeakPointer<vtkImageSlice> slice;
  bool inSlice = false; ///< there was one: surfaces are not meant when it has gone
  vtkWeakPointer<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkCallbackCommand> command;
  /// Hears of releases even while a style keeps its drag's events to itself (GrabFocus).
  vtkNew<vtkCallbackCommand> releases;
  vtkSmartPointer<vtkHaspBrushProp> prop; ///< null while not enabled

  hasp::BrushTrail trail;
  std::optional<hasp::SlicePlane> plane;     ///< as of the last look
  std::optional<hasp::SlicePlane> paintedIn; ///< as of the last step of the stroke
  bool enabled = false;
  bool painting = false;
  bool held = false;   ///< the left button, by us: until its release, whatever became of the stroke
  bool faulty = false; ///< has been said
  std::uint32_t styles = 0;    ///< buttons whose drags are the style's
  std::uint32_t swallowed = 0; ///< pressed within a stroke: nobody's
  std::map<int, glm::dvec3> colours;
};

#endif
