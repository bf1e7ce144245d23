#include "vtkHaspStereoPicture.h"
#include "BorrowedView.h"
#include "StereoOutput.h"
#include "StereoRig.h"
#include "vtkHaspStereoCamera.h"

#include "vtkCamera.h"
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
  hasp::StereoOutput output;
  std::optional<hasp::StereoRig> rig;
  hasp::ResourceUse secondEye{ "second eye", 0, 0.0, "nothing was drawn" };
};

namespace
{

/// Draws one eye and reads its pixels.
vtkSmartPointer<vtkUnsignedCharArray> Draw(BorrowedView& view, vtkRenderer* renderer,
  const hasp::StereoRig& rig, hasp::StereoEye eye, const hasp::EyeGrid& grid)
{
  view.Draw(hasp::ViewOfEye(rig, eye), eye, grid);
  const glm::ivec2 low = view.Origin(), high = low + grid.size - 1;
  vtkNew<vtkUnsignedCharArray> pixels;
  if (!renderer->GetRenderWindow()->GetPixelData(low.x, low.y, high.x, high.y, 0, pixels, 0))
    throw std::runtime_error("stereo: the window's pixels cannot be read");
  return pixels.Get();
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

void vtkHaspStereoPicture::SetOutput(const hasp::StereoOutput& output)
{
  this->Self->output = output;
  this->Modified();
}

const hasp::StereoOutput& vtkHaspStereoPicture::GetOutput() const
{
  return this->Self->output;
}

void vtkHaspStereoPicture::SetLayout(hasp::StereoLayout layout)
{
  if (this->Self->output.layout == layout)
    return;
  this->Self->output.layout = layout;
  this->Modified();
}

hasp::StereoLayout vtkHaspStereoPicture::GetLayout() const
{
  return this->Self->output.layout;
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
  return hasp::StereoLayoutName(this->Self->output.layout);
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
  const hasp::StereoOutput& output = self.output;
  const bool two = hasp::NeedsSecondEye(output.layout);
  self.secondEye = { "second eye", 0, 0.0,
    std::string(hasp::StereoLayoutName(output.layout)) + (two ? "" : ": one eye is drawn") };
  try
  {
    if (!hasp::IsOnePicture(output.layout))
      throw std::invalid_argument(
        "stereo: " + self.secondEye.reason + " is two pictures; take vtkHaspStereoWindows for it");
    const glm::ivec2 viewSize = ViewportSize(self.renderer);
    hasp::StereoRig rig = self.rig
                            ? *self.rig
                            : hasp::RigFromCamera(self.renderer->GetActiveCamera(),
                                static_cast<double>(viewSize.x) / viewSize.y, this->EyeAngle);
    hasp::ValidateStereoRig(rig);
    RequireAspect(rig.screen, viewSize);
    if (output.layout == hasp::StereoLayout::Mono)
      rig.head.eyeSeparationMm = 0.0;
    const glm::ivec2 size = hasp::ComposedSize(output, viewSize);
    BorrowedView view(self.renderer, self.renderer->GetActiveCamera());
    const auto draw = [&](hasp::StereoEye eye)
    { return Draw(view, self.renderer, rig, eye, hasp::GridOfEye(output, size, eye)); };
    const auto eyeOf = [&](hasp::StereoEye eye) {
      return BorrowedView::Eye{ hasp::ViewOfEye(rig, eye), hasp::GridOfEye(output, size, eye) };
    };
    if (two)
      view.Announce(eyeOf(hasp::StereoEye::Left), eyeOf(hasp::StereoEye::Right));
    const bool rightAlone = output.layout == hasp::StereoLayout::Right;
    const auto left = rightAlone ? nullptr : draw(hasp::StereoEye::Left);
    if (rightAlone)
      return MakePicture(
        size, hasp::ComposeStereo(output, size, {}, Bytes(draw(hasp::StereoEye::Right))));
    if (!two)
      return MakePicture(size, hasp::ComposeStereo(output, size, Bytes(left), {}));
    const auto start = std::chrono::steady_clock::now();
    const auto right = draw(hasp::StereoEye::Right);
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    self.secondEye.bytes = static_cast<std::size_t>(right->GetNumberOfValues());
    self.secondEye.milliseconds = spent.count();
    return MakePicture(size, hasp::ComposeStereo(output, size, Bytes(left), Bytes(right)));
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
  os << indent << "Layout: " << hasp::StereoLayoutName(this->Self->output.layout) << "\n"
     << indent << "EyeAngle: " << this->EyeAngle << "\n"
     << indent << "Rig: " << (this->Self->rig ? "given" : "of the camera") << "\n";
}
