#ifndef vtkHaspStereoPicture_h
#define vtkHaspStereoPicture_h

#include "Grid/ResourceUse.h"             // for ListResources
#include "vtkHaspRenderingStereoModule.h" // for export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for return values

#include <memory> // for Internals
#include <string> // for names

class vtkImageData;
class vtkRenderer;

// StereoOutput.h and StereoRig.h say what these are. Included here they would bring GLM to VTK's
// wrapper, which parses it for minutes.
namespace hasp
{
enum class StereoLayout;
struct StereoOutput;
struct StereoRig;
}

/**
 * @class   vtkHaspStereoPicture
 * @brief   Draws one renderer as a stereo picture that is exact with every mapper.
 *
 * Each eye is drawn by an ordinary camera from the eye rig (StereoRig.h), never by VTK's stereo,
 * one after the other into the renderer's own window; the pictures are put together by
 * ComposeStereo. The renderer's camera is set aside meanwhile and comes back untouched, as do the
 * window's StereoRender, SwapBuffers and viewports. Mono draws one eye; a second one is then not
 * made.
 *
 * Threads: RENDER. Cost: one frame and one read of the viewport's pixels for each eye.
 * Errors: vtkErrorMacro and no picture: no window, a parallel projection, a rig whose screen has
 * another aspect than the viewport (by more than half a pixel).
 */
class VTKHASPRENDERINGSTEREO_EXPORT vtkHaspStereoPicture : public vtkObject
{
public:
  static vtkHaspStereoPicture* New();
  vtkTypeMacro(vtkHaspStereoPicture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** What is drawn. It must be in a render window. */
  void SetRenderer(vtkRenderer* renderer);

  /** "side-by-side" by default, or another name of StereoLayout.h; those of two pictures
   * ("dual-window", "quad-buffer") are an error of Render. On an unknown name vtkErrorMacro lists
   * them, and the layout stays. */
  void SetLayoutName(const std::string& name);
  std::string GetLayoutName() const;

#ifndef __VTK_WRAP__
  /** The same by value. */
  void SetLayout(hasp::StereoLayout layout);
  hasp::StereoLayout GetLayout() const;

  /** The layout with its resolution, mirror flip and order of the eyes. Pixels of the picture:
   * hasp::ComposedSize of the viewport. */
  void SetOutput(const hasp::StereoOutput& output);
  const hasp::StereoOutput& GetOutput() const;

  /** A screen and a head in world millimetres. Without one, or after ClearRig, the rig is that of
   * the renderer's camera: the screen stands at its focal point. */
  void SetRig(const hasp::StereoRig& rig);
#endif
  void ClearRig();

  /** Degrees between the eyes seen from the focal point, in [0, 90]. Read only without a rig. */
  vtkSetClampMacro(EyeAngle, double, 0.0, 90.0);
  vtkGetMacro(EyeAngle, double);

  /** Draws and composes. True: `picture` holds RGB bytes of hasp::ComposedSize pixels. False: it is
   * empty, after an error. */
  bool RenderInto(vtkImageData* picture);

#ifndef __VTK_WRAP__
  /** The same with a picture of its own; null after an error. VTK 9.1 does not wrap the type. */
  vtkSmartPointer<vtkImageData> Render();

  /** The "second eye" of the last Render: bytes of its picture and milliseconds of its frame, both
   * 0 where none was drawn. */
  void ListResources(hasp::ResourceList& resources) const;
#endif

protected:
  vtkHaspStereoPicture();
  ~vtkHaspStereoPicture() override;

private:
  vtkHaspStereoPicture(const vtkHaspStereoPicture&) = delete;
  void operator=(const vtkHaspStereoPicture&) = delete;

  double EyeAngle = 2.0;
  struct Internals;
  std::unique_ptr<Internals> Self;
};

#endif
