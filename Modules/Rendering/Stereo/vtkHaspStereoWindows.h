#ifndef vtkHaspStereoWindows_h
#define vtkHaspStereoWindows_h

#include "Grid/ResourceUse.h"             // for ListResources
#include "vtkHaspRenderingStereoModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for Internals
#include <string> // for names

class vtkMatrix4x4;
class vtkRenderWindow;
class vtkRenderer;

// StereoWindow.h says what these are. Included here they would bring GLM to VTK's wrapper.
namespace hasp
{
struct StereoHead;
struct StereoWindow;
enum class StereoEye;
}

/**
 * @class   vtkHaspStereoWindows
 * @brief   One scene in several windows, each a screen of its own in the viewer's room.
 *
 * A window is a screen (StereoWindow.h: its place in the room, how two eyes become one picture, a
 * mirror, lenses), or a head-mounted display. Each eye is drawn by an ordinary camera from the eye
 * rig, so that it is exact with every mapper; one pass on the GPU puts the eyes together. A visible
 * window swaps once a frame. Eyes are drawn left first, by one vtkRenderer a window, and each
 * camera's LeftEye says which it is.
 *
 * The scene's renderer draws in its own window, if that is one of them; in others a renderer of
 * ours shows the same props, lights and background. In its own window, other layers of its viewport
 * with the same camera are seen by the same eyes. Its camera and the windows' StereoRender,
 * SwapBuffers and viewports come back as they were: interactors go on moving the application's
 * camera. So that interaction draws two eyes, not one, call interactor->EnableRenderOff() and let
 * its vtkCommand::RenderEvent call Render.
 *
 * Where the room lies: with SetRoomToWorld(nullptr) the first window's screen stands at the focal
 * point of the scene's camera (hasp::RoomOnScreen), else where the matrix says.
 *
 * Mono, left and right without mirror and lens have no pass and no textures. What the pass puts
 * together is opaque, whatever the background's alpha. Each frame draws all renderers of the
 * window: of two scenes in viewports of one window only the last one drawn has its eyes put
 * together. VTK's own mappers keep buffers of one window: with several windows VTK 9.1 makes them
 * anew at each change of window, whether their contexts are shared or not; ours keep them a window.
 * With several samples a pixel, an eye's pixel is their mean.
 *
 * Threads: RENDER. Windows are held weakly: they may be deleted at any time.
 * Errors: vtkErrorMacro, once until it is another one, and that window keeps its last picture.
 */
class VTKHASPRENDERINGSTEREO_EXPORT vtkHaspStereoWindows : public vtkObject
{
public:
  static vtkHaspStereoWindows* New();
  vtkTypeMacro(vtkHaspStereoWindows, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What is shown. It may be in a window of its own, in one of these, or in none. */
  void SetRenderer(vtkRenderer* scene);

  /** Shows the scene in a window, by the layout's name (StereoLayout.h), two eyes `EyeAngle`
   * degrees apart beside the scene's camera. False, after an error, for an unknown name. */
  bool AddWindow(vtkRenderWindow* window, const std::string& layoutName);

#ifndef __VTK_WRAP__
  /** The same with settings; those of a window that is there already are replaced. False, after an
   * error, for a null window, for dual windows (AddDualWindow), and for settings that
   * ValidateStereoWindow refuses. */
  bool AddWindow(vtkRenderWindow* window, const hasp::StereoWindow& settings);

  /** Layout "dual-window": two windows of one screen, one eye each; swapEyes changes them over. */
  bool AddDualWindow(
    vtkRenderWindow* left, vtkRenderWindow* right, const hasp::StereoWindow& settings);

  /** The viewer, in the room's millimetres; (0, 0, 600) at first. Any values: what a window cannot
   * show is an error of Render. */
  void SetHead(const hasp::StereoHead& head);
#endif

  /** The window's own picture comes back with its next Render. Nothing for an unknown window. */
  void RemoveWindow(vtkRenderWindow* window);
  int GetNumberOfWindows() const;

  /** Where the room's millimetres lie in the world: a rotation, one scale > 0 and a translation
   * (copied; checked when drawing). Null, as at first: from the scene's camera. */
  void SetRoomToWorld(vtkMatrix4x4* roomToWorld);

  /** Degrees between the eyes seen from the camera's focal point, in [0, 90]: of windows without a
   * screen. */
  vtkSetClampMacro(EyeAngle, double, 0.0, 90.0);
  vtkGetMacro(EyeAngle, double);

  /** Draws all windows, one frame each. False if there is none, or after an error in one; the
   * others are drawn. */
  bool Render();

  /** The ray of a window's pixel (from the lower left), through mirror and lens, in the world: from
   * the eye whose pixel it is, through a point that is seen there. For vtkCellPicker::Pick3DRay and
   * the like. False if there is nothing: outside, black behind a lens, or after an error. */
  bool GetRay(vtkRenderWindow* window, int x, int y, double eye[3], double through[3]);

#ifndef __VTK_WRAP__
  /** Where a window's pixel lies in the view of the eye whose pixel it is, through mirror and lens:
   * (-1, -1) lower left, (1, 1) upper right. For what is hit-tested in the view (widgets). False
   * as GetRay. */
  bool GetPositionInView(
    vtkRenderWindow* window, int x, int y, hasp::StereoEye& eye, double device[2]);

  /** The same for a given eye and any pixel, outside of the window too, as if the eye's part of it
   * went on beyond its borders: where a drag is that began in that eye. Beyond what a lens shows
   * there is nothing: false. */
  bool GetPositionInViewOf(
    hasp::StereoEye eye, vtkRenderWindow* window, int x, int y, double device[2]);

  /** "second eye", "eye pictures", "lens tables": bytes of textures of all windows; milliseconds of
   * the second eyes' last frames. All 0, with a reason, where nothing asks for them. */
  void ListResources(hasp::ResourceList& resources) const;
#endif

protected:
  vtkHaspStereoWindows();
  ~vtkHaspStereoWindows() override;

private:
  vtkHaspStereoWindows(const vtkHaspStereoWindows&) = delete;
  void operator=(const vtkHaspStereoWindows&) = delete;

  double EyeAngle = 2.0;
  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
