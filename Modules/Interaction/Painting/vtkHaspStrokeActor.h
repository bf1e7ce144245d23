#ifndef vtkHaspStrokeActor_h
#define vtkHaspStrokeActor_h

#include "vtkHaspInteractionPaintingModule.h" // for export macro
#include "vtkProp.h"

#include <memory> // for Internals
#include <vector> // for strokes

namespace hasp
{
struct BrushStroke;
}

/**
 * @class   vtkHaspStrokeActor
 * @brief   Draws strokes of a brush: balls of their radius along them, each in its label's colour.
 *
 * What of them stands out of a bone is seen on it, as wide as the brush. They are drawn after all
 * that is opaque, hidden by it and by each other, but are not in the depth that vtkHaspSeedPainter
 * paints on: one can paint over strokes. They cannot be picked. Balls are exact, not faceted (an
 * impostor each, OpenGL 3.2), a quarter of a radius apart.
 *
 * SetStrokes compares with what is shown: strokes that are the same stay as they are, one that has
 * grown at its end gets the new points' balls, and what differs is made anew. Without strokes
 * nothing is there. About 40 bytes a ball.
 *
 * Threads: RENDER. Errors (vtkErrorMacro; what was shown stays): a radius that is not in (0, 50], a
 * point that is not finite.
 */
class VTKHASPINTERACTIONPAINTING_EXPORT vtkHaspStrokeActor : public vtkProp
{
public:
  static vtkHaspStrokeActor* New();
  vtkTypeMacro(vtkHaspStrokeActor, vtkProp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /** All that are to be shown. False after an error. */
  bool SetStrokes(const std::vector<hasp::BrushStroke>& strokes);
#endif
  /** The same without any. */
  void ClearStrokes();
  int GetNumberOfStrokes() const;

  /** Of strokes of this label, [0, 65535], components in [0, 1]; hasp::PaletteColour's until then.
   * An error (vtkErrorMacro), and no change, for others. */
  void SetLabelColor(int label, double r, double g, double b);

  /** Balls that have been made since this was: what is new, and no more. */
  vtkIdType GetNumberOfBallsMade() const;

  double* GetBounds() VTK_SIZEHINT(6) override; ///< of what is shown; null without strokes
  int RenderOverlay(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkHaspStrokeActor();
  ~vtkHaspStrokeActor() override;

private:
  vtkHaspStrokeActor(const vtkHaspStrokeActor&) = delete;
  void operator=(const vtkHaspStrokeActor&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
