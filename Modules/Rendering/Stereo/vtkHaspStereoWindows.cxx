#include "vtkHaspStereoWindows.h"

#include "WindowDrawing.h"
#include "vtkHaspStereoCamera.h"

#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <list>
#include <optional>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspStereoWindows);

struct vtkHaspStereoWindows::Internals
{
  vtkHaspStereoWindows* owner;
  vtkSmartPointer<vtkRenderer> renderer;
  std::list<WindowDrawing> windows; // in the order they were added
  hasp::StereoHead head;
  std::optional<glm::dmat4> roomToWorld;

  void DropGone()
  {
    this->windows.remove_if([](const WindowDrawing& one) { return !one.Window(); });
  }
  WindowDrawing* Find(vtkRenderWindow* window)
  {
    const auto found = std::find_if(this->windows.begin(), this->windows.end(),
      [&](const WindowDrawing& one) { return one.Window() == window; });
    return found == this->windows.end() ? nullptr : &*found;
  }
  /// Throws what is wrong with the scene's camera.
  ViewedScene Scene() const
  {
    if (!this->renderer)
      throw std::invalid_argument("stereo: no renderer; call SetRenderer");
    ViewedScene scene{ this->renderer, this->head, glm::dmat4(1.0), this->owner->EyeAngle };
    const hasp::StereoWindow* placed = nullptr;
    for (const WindowDrawing& one : this->windows)
      if (!placed && (one.Settings().screen || one.Settings().hmd))
        placed = &one.Settings();
    for (const WindowDrawing& one : this->windows)
      if (placed && !placed->screen && one.Settings().screen)
        placed = &one.Settings(); // displays alone stand before a screen of the usual size
    if (this->roomToWorld)
      scene.roomToWorld = *this->roomToWorld;
    else if (placed)
      scene.roomToWorld = hasp::RoomOnScreen(
        this->renderer->GetActiveCamera(), placed->screen.value_or(hasp::StereoScreen{}));
    return scene;
  }
  /// Once until it is another one, or the window was drawn.
  void Say(WindowDrawing& window, const std::string& error) const
  {
    if (window.IsNews(error))
      vtkErrorWithObjectMacro(this->owner, << error);
  }
  std::optional<WindowDrawing::Position> FindPosition(
    vtkRenderWindow* window, glm::ivec2 pixel, std::optional<hasp::StereoEye> of = {})
  {
    WindowDrawing* drawing = window ? this->Find(window) : nullptr;
    if (!drawing)
      return std::nullopt;
    try
    {
      return drawing->FindPosition(this->Scene(), pixel, of);
    }
    catch (const std::exception& error)
    {
      this->Say(*drawing, error.what());
      return std::nullopt;
    }
  }
};

vtkHaspStereoWindows::vtkHaspStereoWindows() : Self(new Internals{ this, {}, {}, {}, {} }) {}
vtkHaspStereoWindows::~vtkHaspStereoWindows() = default;

void vtkHaspStereoWindows::SetRenderer(vtkRenderer* scene)
{
  if (this->Self->renderer == scene)
    return;
  this->Self->renderer = scene;
  this->Modified();
}

bool vtkHaspStereoWindows::AddWindow(vtkRenderWindow* window, const std::string& layoutName)
{
  try
  {
    hasp::StereoWindow settings;
    settings.output.layout = hasp::StereoLayoutFromName(layoutName);
    return this->AddWindow(window, settings);
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

bool vtkHaspStereoWindows::AddWindow(vtkRenderWindow* window, const hasp::StereoWindow& settings)
{
  try
  {
    if (!window)
      throw std::invalid_argument("stereo: no window; give one");
    if (settings.output.layout == hasp::StereoLayout::DualWindow)
      throw std::invalid_argument("stereo: dual-window takes two windows; call AddDualWindow");
    hasp::ValidateStereoWindow(settings);
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  this->Self->DropGone();
  if (WindowDrawing* known = this->Self->Find(window))
    known->ChangeSettings(settings);
  else
    this->Self->windows.emplace_back(window, settings);
  this->Modified();
  return true;
}

bool vtkHaspStereoWindows::AddDualWindow(
  vtkRenderWindow* left, vtkRenderWindow* right, const hasp::StereoWindow& settings)
{
  if (left == right)
  {
    vtkErrorMacro(<< "stereo: dual-window takes two windows, not one twice");
    return false;
  }
  hasp::StereoWindow one = settings;
  one.output.swapEyes = false;
  const bool swap = settings.output.swapEyes;
  one.output.layout = swap ? hasp::StereoLayout::Right : hasp::StereoLayout::Left;
  if (!right || !this->AddWindow(left, one))
  {
    if (!right)
      vtkErrorMacro(<< "stereo: no window for the right eye; give one");
    return false;
  }
  one.output.layout = swap ? hasp::StereoLayout::Left : hasp::StereoLayout::Right;
  return this->AddWindow(right, one);
}

void vtkHaspStereoWindows::SetHead(const hasp::StereoHead& head)
{
  this->Self->head = head;
  this->Modified();
}

void vtkHaspStereoWindows::RemoveWindow(vtkRenderWindow* window)
{
  this->Self->windows.remove_if([&](const WindowDrawing& one) { return one.Window() == window; });
  this->Modified();
}

int vtkHaspStereoWindows::GetNumberOfWindows() const
{
  this->Self->DropGone();
  return static_cast<int>(this->Self->windows.size());
}

void vtkHaspStereoWindows::SetRoomToWorld(vtkMatrix4x4* roomToWorld)
{
  this->Self->roomToWorld.reset();
  if (roomToWorld)
  {
    glm::dmat4& matrix = this->Self->roomToWorld.emplace();
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        matrix[column][row] = roomToWorld->GetElement(row, column);
  }
  this->Modified();
}

bool vtkHaspStereoWindows::Render()
{
  Internals& self = *this->Self;
  self.DropGone();
  bool all = !self.windows.empty();
  for (WindowDrawing& one : self.windows)
  {
    try
    {
      one.Draw(self.Scene());
      if (self.windows.size() > 1)
        one.Leave(self.Scene());
      one.IsNews("");
    }
    catch (const std::exception& error)
    {
      self.Say(one, error.what());
      all = false;
    }
  }
  return all;
}

bool vtkHaspStereoWindows::GetRay(
  vtkRenderWindow* window, int x, int y, double eye[3], double through[3])
{
  const auto at = this->Self->FindPosition(window, { x, y });
  if (!at)
    return false;
  for (int axis = 0; axis < 3; ++axis)
  {
    eye[axis] = at->origin[axis];
    through[axis] = at->through[axis];
  }
  return true;
}

bool vtkHaspStereoWindows::GetPositionInView(
  vtkRenderWindow* window, int x, int y, hasp::StereoEye& eye, double device[2])
{
  const auto at = this->Self->FindPosition(window, { x, y });
  if (!at)
    return false;
  eye = at->eye;
  device[0] = at->device.x;
  device[1] = at->device.y;
  return true;
}

bool vtkHaspStereoWindows::GetPositionInViewOf(
  hasp::StereoEye eye, vtkRenderWindow* window, int x, int y, double device[2])
{
  const auto at = this->Self->FindPosition(window, { x, y }, eye);
  if (!at)
    return false;
  device[0] = at->device.x;
  device[1] = at->device.y;
  return true;
}

void vtkHaspStereoWindows::ListResources(hasp::ResourceList& resources) const
{
  hasp::ResourceUse second{ "second eye", 0, 0.0, "no window shows both eyes" };
  hasp::ResourceUse pictures{ "eye pictures", 0, 0.0, "no window puts eyes together" };
  hasp::ResourceUse tables{ "lens tables", 0, 0.0, "no window has a lens" };
  this->Self->DropGone();
  for (const WindowDrawing& one : this->Self->windows)
  {
    const hasp::StereoOutput& output = one.Settings().output;
    if (one.SecondEyeMilliseconds() > 0.0)
    {
      second.milliseconds += one.SecondEyeMilliseconds();
      second.bytes += one.Pass().PictureBytes() / 2;
      second.reason = hasp::StereoLayoutName(output.layout);
    }
    pictures.bytes += one.Pass().PictureBytes();
    if (one.Pass().PictureBytes() > 0)
      pictures.reason = hasp::StereoLayoutName(output.layout);
    tables.bytes += one.Pass().LensBytes();
    if (one.Pass().LensBytes() > 0)
      tables.reason = "a lens";
  }
  resources.insert(resources.end(), { second, pictures, tables });
}

void vtkHaspStereoWindows::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Windows: " << this->GetNumberOfWindows() << "\n"
     << indent << "EyeAngle: " << this->EyeAngle << "\n"
     << indent << "RoomToWorld: " << (this->Self->roomToWorld ? "given" : "of the camera") << "\n";
}
