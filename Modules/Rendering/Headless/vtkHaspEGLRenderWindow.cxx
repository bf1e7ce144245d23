#include "vtkHaspEGLRenderWindow.h"

#include "EGLContextHandle.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVersion.h"
#include "vtk_glew.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

struct vtkHaspEGLRenderWindow::Internals
{
  hasp::EGLContextHandle Context;
  bool Failed = false; ///< said once why there is no context, not once a frame
  int ScreenSize[2] = { 1920, 1080 };

  /// What was current before a PushContext; somebody else's context may have surfaces.
  struct Current
  {
    EGLDisplay Display = eglGetCurrentDisplay();
    EGLSurface Drawn = eglGetCurrentSurface(EGL_DRAW), Read = eglGetCurrentSurface(EGL_READ);
    EGLContext Context = eglGetCurrentContext();
  };
  std::vector<Current> Pushed;
};

vtkStandardNewMacro(vtkHaspEGLRenderWindow);

vtkHaspEGLRenderWindow::vtkHaspEGLRenderWindow() : Impl(new Internals)
{
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->FrameBlitMode = NoBlit;
}

vtkHaspEGLRenderWindow::~vtkHaspEGLRenderWindow()
{
  this->Finalize();
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
    renderer->SetRenderWindow(nullptr);
}

void vtkHaspEGLRenderWindow::CreateAWindow()
{
  EGLContext shared = EGL_NO_CONTEXT;
  if (auto* other = vtkHaspEGLRenderWindow::SafeDownCast(this->SharedRenderWindow))
  {
    other->Initialize();
    shared = other->Impl->Context.GetContext();
  }
  try
  {
    this->Impl->Context.Create(shared);
    this->Impl->Failed = false;
    this->Mapped = 0;
  }
  catch (const std::exception& error)
  {
    this->Impl->Failed = true;
    this->OpenGLSupportMessage = error.what();
    vtkErrorMacro(<< error.what());
  }
}

void vtkHaspEGLRenderWindow::Initialize()
{
  if (this->Impl->Context.IsValid() || this->Impl->Failed)
    return;
  if (this->Size[0] <= 0 || this->Size[1] <= 0)
    this->SetSize(300, 300); // as other windows do
  this->CreateAWindow();
  if (!this->Impl->Context.IsValid())
    return;
  // Renderers hold resources of an earlier context: let them drop these.
  vtkCollectionSimpleIterator it;
  this->Renderers->InitTraversal(it);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(it))
  {
    renderer->SetRenderWindow(nullptr);
    renderer->SetRenderWindow(this);
  }
  this->OpenGLInit();
}

void vtkHaspEGLRenderWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
    return;
  // A GLEW built for GLX loads every entry point (through GLVND they serve EGL contexts as well)
  // and only then fails for want of a GLX display. That failure is harmless.
  constexpr GLenum glewErrorNoGLXDisplay = 4;
  glewExperimental = GL_TRUE;
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == glewErrorNoGLXDisplay;
  if (!this->GlewInitValid || !GLEW_VERSION_3_2)
  {
    this->Impl->Failed = true;
    this->Impl->Context.Destroy();
    vtkErrorMacro(<< "OpenGL 3.2 could not be loaded: "
                  << reinterpret_cast<const char*>(glewGetErrorString(result)));
    return;
  }
  this->Initialized = true;
  GLfloat range[2] = { 1, 1 };
  glGetFloatv(
    this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

void vtkHaspEGLRenderWindow::DestroyWindow()
{
  this->Impl->Failed = false; // the next Initialize tries anew
  if (!this->Impl->Context.MakeCurrent())
    return;
  this->ReleaseGraphicsResources(this);
  this->Impl->Context.Destroy();
  this->Initialized = false;
}

void vtkHaspEGLRenderWindow::Finalize()
{
  this->DestroyWindow();
}

void vtkHaspEGLRenderWindow::Render()
{
  if (this->SupportsOpenGL())
    this->Superclass::Render();
}

void vtkHaspEGLRenderWindow::Start()
{
  if (this->SupportsOpenGL())
    this->Superclass::Start();
}

int vtkHaspEGLRenderWindow::GetColorBufferSizes(int* rgba)
{
  std::fill_n(rgba, 4, 8); // vtkOpenGLRenderWindow makes its render frame buffers RGBA8
  return 32;
}

void vtkHaspEGLRenderWindow::Frame()
{
  this->MakeCurrent();
  this->Superclass::Frame();
}

int vtkHaspEGLRenderWindow::SupportsOpenGL()
{
  this->Initialize();
  return this->Impl->Context.IsValid() ? 1 : 0;
}

int vtkHaspEGLRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  if (!this->SupportsOpenGL())
    return VTK_ERROR;
  return this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right);
}

const char* vtkHaspEGLRenderWindow::ReportCapabilities()
{
  return this->SupportsOpenGL() ? this->Superclass::ReportCapabilities()
                                : this->OpenGLSupportMessage.c_str();
}

void vtkHaspEGLRenderWindow::MakeCurrent()
{
  this->Impl->Context.MakeCurrent();
}

void vtkHaspEGLRenderWindow::ReleaseCurrent()
{
  this->Impl->Context.ReleaseCurrent();
}

bool vtkHaspEGLRenderWindow::IsCurrent()
{
  return this->Impl->Context.IsCurrent();
}

void vtkHaspEGLRenderWindow::PushContext()
{
  eglBindAPI(EGL_OPENGL_API);
  this->Impl->Pushed.push_back({});
  this->MakeCurrent();
}

void vtkHaspEGLRenderWindow::PopContext()
{
  if (this->Impl->Pushed.empty())
    return;
  const Internals::Current last = this->Impl->Pushed.back();
  this->Impl->Pushed.pop_back();
  if (last.Context != EGL_NO_CONTEXT && last.Context != eglGetCurrentContext())
    eglMakeCurrent(last.Display, last.Drawn, last.Read, last.Context);
}

void* vtkHaspEGLRenderWindow::GetGenericContext()
{
  return this->Impl->Context.GetContext();
}

void* vtkHaspEGLRenderWindow::GetGenericDisplayId()
{
  return this->Impl->Context.GetDisplay();
}

int* vtkHaspEGLRenderWindow::GetScreenSize()
{
  return this->Impl->ScreenSize;
}

void vtkHaspEGLRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Display: " << this->Impl->Context.GetName() << "\n";
}

namespace
{
class HeadlessFactory : public vtkObjectFactory
{
public:
  static HeadlessFactory* New();
  vtkTypeMacro(HeadlessFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Hasp: windows without X"; }

protected:
  HeadlessFactory()
  {
    this->RegisterOverride("vtkRenderWindow", "vtkHaspEGLRenderWindow", "EGL", 1,
      []() -> vtkObject* { return vtkHaspEGLRenderWindow::New(); });
    this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
      "no events", 1, []() -> vtkObject* { return vtkGenericRenderWindowInteractor::New(); });
  }
};
vtkStandardNewMacro(HeadlessFactory);
}

void vtkHaspEGLRenderWindow::InstallFactoryOverride()
{
  static bool installed = false;
  if (installed)
    return;
  installed = true;
  // The first factory that answers wins, and VTK's own may come before ours.
  vtkObjectFactory::SetAllEnableFlags(false, "vtkRenderWindow");
  vtkObjectFactory::SetAllEnableFlags(false, "vtkRenderWindowInteractor");
  vtkNew<HeadlessFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
}
