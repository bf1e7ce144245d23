#ifndef vtkHaspEGLRenderWindow_h
#define vtkHaspEGLRenderWindow_h

#include "vtkHaspRenderingHeadlessModule.h" // for export macro
#include "vtkOpenGLRenderWindow.h"

#include <memory> // for Internals

/**
 * @class   vtkHaspEGLRenderWindow
 * @brief   A render window without X, for a VTK before 9.4 that was built for X alone (Debian).
 *
 * Draws off-screen through EGL: on the first graphics card that has a driver of the kind
 * EGL_EXT_platform_device (NVIDIA), else on Mesa's surfaceless display, which computes on the CPU
 * where there is no card. The environment variable HASP_EGL_DEVICE overrides it: a number chooses
 * a device of eglQueryDevicesEXT, "surfaceless" chooses Mesa's.
 *
 * Errors: without a driver Initialize reports through vtkErrorMacro what was tried and what to
 * install; SupportsOpenGL is then 0, Render draws nothing and pixels read as failure. It never ends
 * the process. Stereo of every type works; CrystalEyes too, with StereoCapableWindowOn.
 * There is no screen: GetScreenSize is 1920x1080, positions and cursors are ignored.
 * Threads: RENDER. Cost: 0.1 to 0.2 s for the first window of a process.
 */
class VTKHASPRENDERINGHEADLESS_EXPORT vtkHaspEGLRenderWindow : public vtkOpenGLRenderWindow
{
public:
  static vtkHaspEGLRenderWindow* New();
  vtkTypeMacro(vtkHaspEGLRenderWindow, vtkOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// From now on vtkRenderWindow::New() returns this class, and vtkRenderWindowInteractor::New()
  /// a vtkGenericRenderWindowInteractor. hasp::UseHeadlessWindows asks DISPLAY first.
  static void InstallFactoryOverride();

  void Initialize() override;
  void Finalize() override;
  void Render() override;
  void Start() override;
  void Frame() override;
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  /// Makes this window's context current until PopContext brings back what was: VTK's mappers free
  /// their buffers in between, while another window draws.
  void PushContext() override;
  void PopContext() override;
  int SupportsOpenGL() override;
  /// Of what is drawn into: VTK's own frame buffer, for there is no default one to ask about.
  /// Hardware selection refuses windows with less than 8 bits.
  int GetColorBufferSizes(int* rgba) override;
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;
  const char* ReportCapabilities() override;

  void* GetGenericContext() override;
  void* GetGenericDisplayId() override;
  void* GetGenericWindowId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericDrawable() override { return nullptr; }
  void SetDisplayId(void*) override {}
  void SetWindowId(void*) override {}
  void SetParentId(void*) override {}
  void SetNextWindowId(void*) override {}
  void SetWindowInfo(const char*) override {}
  void SetNextWindowInfo(const char*) override {}
  void SetParentInfo(const char*) override {}
  int* GetScreenSize() VTK_SIZEHINT(2) override;
  int* GetPosition() VTK_SIZEHINT(2) override { return this->Position; }
  void HideCursor() override {}
  void ShowCursor() override {}
  void SetFullScreen(vtkTypeBool) override {}
  void WindowRemap() override {}
  vtkTypeBool GetEventPending() override { return 0; }

protected:
  vtkHaspEGLRenderWindow();
  ~vtkHaspEGLRenderWindow() override;
  void CreateAWindow() override;
  void DestroyWindow() override;
  int ReadPixels(
    const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right = 0) override;

private:
  vtkHaspEGLRenderWindow(const vtkHaspEGLRenderWindow&) = delete;
  void operator=(const vtkHaspEGLRenderWindow&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
