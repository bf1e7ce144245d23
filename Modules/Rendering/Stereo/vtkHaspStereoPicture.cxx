#include "vtkHaspStereoPicture.h"
#include "StereoLayout.h"
#include "StereoRig.h"

#include "vtkCamera.h"
#include "vtkHaspStereoCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspStereoPicture);

struct vtkHaspStereoPicture::Internals
{
  vtkSmartPointer<vtkRenderer> renderer;
  hasp::StereoLayout layout = hasp::StereoLayout::SideBySide;
  std::optional<hasp::StereoRig> rig;
  hasp::ResourceUse secondEye{ "second eye", 0, 0.0, "nothing was drawn" };
};

namespace
{

/// Sets the camera and the window's switches aside for a while; brings them back whatever happens.
class BorrowedView
{
public:
  explicit BorrowedView(vtkRenderer* r)
    : renderer(r),
      window(r->GetRenderWindow()),
      camera(r->GetActiveCamera()),
      stereo(window->GetStereoRender()),
      swapBuffers(window->GetSwapBuffers())
  {
    this->eyeCamera->DeepCopy(this->camera); // clipping range, user transforms
    this->renderer->SetActiveCamera(this->eyeCamera);
    this->window->SetStereoRender(false);
    this->window->SetSwapBuffers(false); // a visible window does not flicker between the eyes
  }
  ~BorrowedView()
  {
    this->renderer->SetActiveCamera(this->camera);
    this->window->SetStereoRender(this->stereo);
    this->window->SetSwapBuffers(this->swapBuffers);
  }
  BorrowedView(const BorrowedView&) = delete;
  void operator=(const BorrowedView&) = delete;

  vtkSmartPointer<vtkUnsignedCharArray> Draw(const hasp::StereoRig& rig, hasp::StereoEye eye)
  {
    hasp::SetCameraToEye(this->eyeCamera, rig, eye);
    this->renderer->ResetCameraClippingRange();
    this->window->Render();
    int width, height, x, y;
    this->renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
    vtkNew<vtkUnsignedCharArray> pixels;
    if (!this->window->GetPixelData(x, y, x + width - 1, y + height - 1, 0, pixels, 0))
      throw std::runtime_error("stereo: the window's pixels cannot be read");
    return pixels.Get();
  }

private:
  vtkRenderer* renderer;
  vtkRenderWindow* window;
  vtkSmartPointer<vtkCamera> camera;
  vtkNew<vtkCamera> eyeCamera;
  vtkTypeBool stereo;
  vtkTypeBool swapBuffers;
};

glm::ivec2 ViewportSize(vtkRenderer* renderer)
{
  if (!renderer)
    throw std::invalid_argument("stereo: no renderer; call SetRenderer");
  if (!renderer->GetRenderWindow())
    throw std::invalid_argument("stereo: the renderer is in no window; add it to one");
  int width, height, x, y;
  renderer->GetTiledSizeAndOrigin(&width, &height, &x, &y);
  if (width < 1 || height < 1)
    throw std::invalid_argument("stereo: the viewport has no pixels; set the window's size");
  return { width, height };
}

void RequireAspect(const hasp::StereoScreen& screen, glm::ivec2 size)
{
  const double width = size.y * screen.widthMm / screen.heightMm;
  if (!(std::abs(width - size.x) <= 0.5))
    throw std::invalid_argument("stereo: the screen is " + std::to_string(screen.widthMm) + " x " +
                                std::to_string(screen.heightMm) + " mm, the viewport " +
                                std::to_string(size.x) + " x " + std::to_string(size.y) +
                                " pixels; make it " + std::to_string(std::lround(width)) +
                                " pixels wide");
}

std::span<const std::uint8_t> Bytes(vtkUnsignedCharArray* pixels)
{
  return { pixels->GetPointer(0), static_cast<std::size_t>(pixels->GetNumberOfValues()) };
}

vtkSmartPointer<vtkImageData> MakePicture(glm::ivec2 size, std::span<const std::uint8_t> rgb)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.x, size.y, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::memcpy(image->GetScalarPointer(), rgb.data(), rgb.size());
  return image;
}

} // namespace

vtkHaspStereoPicture::vtkHaspStereoPicture() : Self(std::make_unique<Internals>()) {}
vtkHaspStereoPicture::~vtkHaspStereoPicture() = default;

void vtkHaspStereoPicture::SetRenderer(vtkRenderer* renderer)
{
  if (this->Self->renderer == renderer)
    return;
  this->Self->renderer = renderer;
  this->Modified();
}

void vtkHaspStereoPicture::SetLayout(hasp::StereoLayout layout)
{
  if (this->Self->layout == layout)
    return;
  this->Self->layout = layout;
  this->Modified();
}

hasp::StereoLayout vtkHaspStereoPicture::GetLayout() const
{
  return this->Self->layout;
}

void vtkHaspStereoPicture::SetLayoutName(const std::string& name)
{
  try
  {
    this->SetLayout(hasp::StereoLayoutFromName(name));
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro(<< error.what());
  }
}

std::string vtkHaspStereoPicture::GetLayoutName() const
{
  return hasp::StereoLayoutName(this->Self->layout);
}

void vtkHaspStereoPicture::SetRig(const hasp::StereoRig& rig)
{
  this->Self->rig = rig;
  this->Modified();
}

void vtkHaspStereoPicture::ClearRig()
{
  this->Self->rig.reset();
  this->Modified();
}

bool vtkHaspStereoPicture::RenderInto(vtkImageData* picture)
{
  const auto rendered = this->Render();
  picture->Initialize();
  if (rendered)
    picture->ShallowCopy(rendered);
  return rendered;
}

vtkSmartPointer<vtkImageData> vtkHaspStereoPicture::Render()
{
  Internals& self = *this->Self;
  const bool two = hasp::NeedsSecondEye(self.layout);
  self.secondEye = { "second eye", 0, 0.0,
    std::string(hasp::StereoLayoutName(self.layout)) + (two ? "" : ": one eye is drawn") };
  try
  {
    const glm::ivec2 size = ViewportSize(self.renderer);
    hasp::StereoRig rig = self.rig ? *self.rig
                                   : hasp::RigFromCamera(self.renderer->GetActiveCamera(),
                                       static_cast<double>(size.x) / size.y, this->EyeAngle);
    hasp::ValidateStereoRig(rig);
    RequireAspect(rig.screen, size);
    if (self.layout == hasp::StereoLayout::Mono)
      rig.head.eyeSeparationMm = 0.0;
    BorrowedView view(self.renderer);
    const bool rightAlone = self.layout == hasp::StereoLayout::Right;
    const auto first = view.Draw(rig, rightAlone ? hasp::StereoEye::Right : hasp::StereoEye::Left);
    if (!two)
      return MakePicture(size, Bytes(first));
    const auto start = std::chrono::steady_clock::now();
    const auto second = view.Draw(rig, hasp::StereoEye::Right);
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    self.secondEye.bytes = static_cast<std::size_t>(second->GetNumberOfValues());
    self.secondEye.milliseconds = spent.count();
    const auto picture = hasp::ComposeStereo(self.layout, size, Bytes(first), Bytes(second));
    return MakePicture(hasp::ComposedSize(self.layout, size), picture);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return nullptr;
  }
}

void vtkHaspStereoPicture::ListResources(hasp::ResourceList& resources) const
{
  resources.push_back(this->Self->secondEye);
}

void vtkHaspStereoPicture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layout: " << hasp::StereoLayoutName(this->Self->layout) << "\n"
     << indent << "EyeAngle: " << this->EyeAngle << "\n"
     << indent << "Rig: " << (this->Self->rig ? "given" : "of the camera") << "\n";
}
