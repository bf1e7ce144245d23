#ifndef vtkHaspSeedPainter_h
#define vtkHaspSeedPainter_h

#include "Grid/ResourceUse.h"                 // for ListResources
#include "vtkCommand.h"                       // for the events
#include "vtkHaspInteractionPaintingModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for Internals
#include <vector> // for pieces

class vtkImageSlice;
class vtkRenderer;

namespace hasp
{
struct BrushStroke;
}

/**
 * @class   vtkHaspSeedPainter
 * @brief   Paints strokes on what a renderer shows, or in a slice, with a brush in world mm.
 *
 * Give it a renderer whose window has an interactor, switch it on (SetEnabled), and a left drag
 * that begins on something paints; the stroke is then there as hasp::BrushStroke. A drag that
 * begins before the background is the interactor's style's, as are all other buttons and, with
 * NoModifier, whatever is done with Ctrl, Shift or Alt held. Two views of a patient have a painter
 * each.
 *
 *   left drag                         paints; with SetErase on it is label 0 (takes away)
 *   Shift + wheel, keys + and -       the brush grows and shrinks by a tenth (as in 3D Slicer)
 *   Escape                            takes the stroke back that is being painted
 *
 * On a surface the place under the pointer is what the depth of the renderer's last frame says,
 * in the middle of the pixel: whatever mapper has drawn it. A drag asks all pixels that it passes;
 * where it meets the background, or two neighbours that are farther apart than the brush's radius
 * (4 pixels, where these are larger), it is cut into pieces, so that no stroke spans a silhouette.
 * What a stroke is painted on is what was seen at its press, as long as the view stays: what it
 * changes does not lift it. Points are a quarter of a radius apart, or a pixel.
 *
 * With SetSlice it is where the line of sight meets the plane that a vtkImageSlice shows, however
 * oblique, within its image; no depth is asked. The brush is a ball all the same: it marks the
 * slices beside this one, too.
 *
 * While the pointer is over something a ring of the brush's radius is drawn there, parallel to the
 * screen or in the slice, and on surfaces a translucent ball. It is not in the depth that is asked.
 * Pictures are asked for by the interactor's Render, after each step, so who follows
 * StrokeChangedEvent need not; and once more where the depth of the last frame was not kept: after
 * a drag of the camera.
 *
 * Events, on this, in order: StrokeStartedEvent at a press, when the first point is there;
 * StrokeChangedEvent when there are more; StrokeEndedEvent at the release (or when painter,
 * renderer or slice are switched meanwhile), or StrokeCancelledEvent, when the pieces are gone.
 * Nothing but these says that a stroke is done: pieces stay until the next one begins.
 * RadiusChangedEvent.
 *
 * Stereo: depth and pixels are the left eye's, whose picture the pointer is taken to lie in.
 * Limits: layouts that squeeze the eyes' pictures are not undone; what is translucent, and volumes,
 * write no depth in VTK, and one paints on what lies behind them; renderers with passes of their
 * own (vtkSSAAPass) leave none in the window. With a renderer above in the same viewport the
 * pointer is ours only if that is not interactive or has the same camera.
 *
 * Threads: RENDER. Renderer, window and slice are held weakly: each may go at any time.
 * Errors: vtkErrorMacro with what to do, and nothing changes.
 * Cost: nothing until it is enabled; then 4 bytes a pixel of the viewport, copied from the GPU once
 * a frame while the pointer is over it. In slices neither.
 */
class VTKHASPINTERACTIONPAINTING_EXPORT vtkHaspSeedPainter : public vtkObject
{
public:
  static vtkHaspSeedPainter* New();
  vtkTypeMacro(vtkHaspSeedPainter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    StrokeStartedEvent = vtkCommand::UserEvent + 7301,
    StrokeChangedEvent,
    StrokeEndedEvent,
    StrokeCancelledEvent,
    RadiusChangedEvent
  };
  enum Modifiers
  {
    NoModifier, ///< a brush mode: plain drags paint
    ShiftModifier,
    ControlModifier,
    AltModifier
  };

  /** Where it is drawn, and whose window's interactor is followed. Ends a stroke; null: none. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  /** Paints in what this prop shows, in the same renderer, instead of on surfaces. Its mapper has
   * an image of its own (vtkImageSliceMapper, vtkImageResliceMapper), and it stands in no assembly.
   * Ends a stroke; null, the default: surfaces. */
  void SetSlice(vtkImageSlice* slice);
  vtkImageSlice* GetSlice() const;

  ///@{
  /** Default off. An error, and it stays off, where the renderer's window has no interactor. Off:
   * ends a stroke, frees what it has. */
  void SetEnabled(bool enabled);
  bool GetEnabled() const;
  vtkBooleanMacro(Enabled, bool);
  ///@}
  ///@{
  /** Held at a press that is to paint, alone. Default NoModifier. */
  vtkSetClampMacro(Modifier, int, NoModifier, AltModifier);
  vtkGetMacro(Modifier, int);
  ///@}
  ///@{
  /** What is painted from now on; a change within a drag begins a new piece. [1, 65535]; an error,
   * and no change, for others. Default 2. */
  void SetLabel(int label);
  vtkGetMacro(Label, int);
  ///@}
  ///@{
  /** Strokes are of label 0 from now on. Default off. */
  vtkSetMacro(Erase, bool);
  vtkGetMacro(Erase, bool);
  vtkBooleanMacro(Erase, bool);
  ///@}
  ///@{
  /** World mm, (0, 50]; an error, and no change, for others. Wheel and keys stay within [0.1, 50].
   * A change within a drag begins a new piece. Default 2. */
  void SetRadiusMm(double mm);
  vtkGetMacro(RadiusMm, double);
  ///@}
  /** The brush's, for this label (0: the eraser); hasp::PaletteColour's until then. Components in
   * [0, 1], labels in [0, 65535]; an error, and no change, for others. */
  void SetLabelColor(int label, double r, double g, double b);

  /** Is a stroke being painted? */
  bool IsPainting() const;
  /** As Escape. Nothing where none is painted. */
  void Cancel();

#ifndef __VTK_WRAP__
  /** Of the stroke that is painted, or of the last one: a drag's pieces, in order. Each has a
   * label, a radius and at least one point. The last one's end may lie a quarter of a radius behind
   * the pointer until the stroke has ended. */
  const std::vector<hasp::BrushStroke>& GetPieces() const;
  /** The newest piece; without any, a stroke without points. */
  const hasp::BrushStroke& GetStroke() const;
#endif
  ///@{
  /** The same, number by number. Out of range: 0, false and untouched. */
  int GetNumberOfPieces() const;
  int GetNumberOfPoints(int piece) const;
  bool GetPoint(int piece, int point, double world[3]) const;
  ///@}

  /** What the pixel of the window shows (event positions), world mm; false, and untouched, where it
   * shows nothing to paint on, or there has been no picture. While enabled. */
  bool GetPlace(int x, int y, double world[3]);

#ifndef __VTK_WRAP__
  void ListResources(hasp::ResourceList& resources) const;
#endif

protected:
  vtkHaspSeedPainter();
  ~vtkHaspSeedPainter() override;

private:
  vtkHaspSeedPainter(const vtkHaspSeedPainter&) = delete;
  void operator=(const vtkHaspSeedPainter&) = delete;

  struct Internals;
  friend struct Internals;
  int Modifier = NoModifier;
  int Label = 2;
  bool Erase = false;
  double RadiusMm = 2.0;
  std::unique_ptr<Internals> Self;
};

#endif
