// What the pointer does to a vtkHaspSeedPainter.
#include "PainterInternals.h"

#include "LabelPalette.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace
{

constexpr unsigned long Followed[] = { vtkCommand::MouseMoveEvent, vtkCommand::LeaveEvent,
  vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent,
  vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
  vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent,
  vtkCommand::KeyPressEvent };
constexpr unsigned long ReleaseEvents[] = { vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::RightButtonReleaseEvent, vtkCommand::MiddleButtonReleaseEvent };
constexpr double Grown = 1.1; // a notch of the wheel, or a key
constexpr std::uint32_t Left = 1, Right = 2, Middle = 4;

std::uint32_t ButtonOf(unsigned long event)
{
  switch (event)
  {
    case vtkCommand::LeftButtonPressEvent:
    case vtkCommand::LeftButtonReleaseEvent:
      return Left;
    case vtkCommand::RightButtonPressEvent:
    case vtkCommand::RightButtonReleaseEvent:
      return Right;
    default:
      return Middle;
  }
}

} // namespace

vtkHaspSeedPainter::Internals::Internals(vtkHaspSeedPainter* of) : painter(of)
{
  this->command->SetClientData(this);
  this->command->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto* in = static_cast<Internals*>(self);
      const vtkSmartPointer<vtkHaspSeedPainter> alive = in->painter; // whatever observers do
      if (in->Handle(event))
        in->command->AbortFlagOn();
    });
  this->releases->SetPassiveObserver(1);
  this->releases->SetClientData(this);
  this->releases->SetCallback([](vtkObject*, unsigned long event, void* self, void*)
    { static_cast<Internals*>(self)->styles &= ~ButtonOf(event); });
}

vtkHaspSeedPainter::Internals::~Internals()
{
  this->Follow(nullptr);
}

void vtkHaspSeedPainter::Internals::Follow(vtkRenderWindowInteractor* whose)
{
  if (this->interactor)
  {
    this->interactor->RemoveObserver(this->command);
    this->interactor->RemoveObserver(this->releases);
  }
  this->interactor = whose;
  this->styles = this->swallowed = 0;
  this->held = false;
  if (whose == nullptr)
    return;
  for (const unsigned long event : Followed)
    whose->AddObserver(event, this->command, 1.0F); // before styles and widgets
  for (const unsigned long event : ReleaseEvents)
    whose->AddObserver(event, this->releases);
}

bool vtkHaspSeedPainter::Internals::Handle(unsigned long event)
{
  // Before the first picture there is nothing to point at, and asking for a camera makes one.
  vtkRenderWindow* window = this->renderer ? this->renderer->GetRenderWindow() : nullptr;
  if (!this->enabled || window == nullptr || window->GetNeverRendered() ||
      !this->renderer->IsActiveCameraCreated())
    return false;
  switch (event)
  {
    case vtkCommand::MouseMoveEvent:
      return this->Move();
    case vtkCommand::LeaveEvent:
      this->Leave();
      return false;
    case vtkCommand::LeftButtonPressEvent:
      return this->Press();
    case vtkCommand::LeftButtonReleaseEvent:
      return this->Release();
    case vtkCommand::RightButtonPressEvent:
    case vtkCommand::MiddleButtonPressEvent:
      return this->OtherPress(event);
    case vtkCommand::RightButtonReleaseEvent:
    case vtkCommand::MiddleButtonReleaseEvent:
      return this->OtherRelease(event);
    case vtkCommand::MouseWheelForwardEvent:
      return this->Wheel(Grown, true);
    case vtkCommand::MouseWheelBackwardEvent:
      return this->Wheel(1.0 / Grown, true);
    case vtkCommand::KeyPressEvent:
      return this->Key();
    default:
      return false;
  }
}

glm::ivec2 vtkHaspSeedPainter::Internals::Pointer() const
{
  const int* at = this->interactor->GetEventPosition();
  return { at[0], at[1] };
}

/// In our viewport, and no other camera's.
bool vtkHaspSeedPainter::Internals::Ours(const glm::ivec2& pixel) const
{
  if (!this->renderer->IsInViewport(pixel.x, pixel.y))
    return false;
  vtkRenderer* poked = this->interactor->FindPokedRenderer(pixel.x, pixel.y);
  return poked == nullptr || poked == this->renderer ||
         (poked->IsActiveCameraCreated() &&
           poked->GetActiveCamera() == this->renderer->GetActiveCamera());
}

bool vtkHaspSeedPainter::Internals::ModifiersAsked() const
{
  const bool shift = this->interactor->GetShiftKey() != 0;
  const bool control = this->interactor->GetControlKey() != 0;
  const bool alt = this->interactor->GetAltKey() != 0;
  const int asked = this->painter->Modifier;
  return shift == (asked == ShiftModifier) && control == (asked == ControlModifier) &&
         alt == (asked == AltModifier);
}

bool vtkHaspSeedPainter::Internals::Move()
{
  const glm::ivec2 pixel = this->Pointer();
  if (this->painting)
    this->Extend(pixel); // which may have been the end, of the painter, too
  else if (!this->held)
    return this->HoverAt(pixel);
  return true;
}

bool vtkHaspSeedPainter::Internals::HoverAt(const glm::ivec2& pixel)
{
  if (this->styles != 0)
    return false; // the camera turns
  const hasp::BrushTrail::Finder find =
    this->Ours(pixel) && this->ModifiersAsked() ? this->Look() : nullptr;
  if (!find)
    this->LookAway();
  if (this->ShowBrush(find ? find(pixel) : std::nullopt))
    this->Draw();
  return false;
}

bool vtkHaspSeedPainter::Internals::Press()
{
  if (this->held) // its release was lost
    this->Release();
  const glm::ivec2 pixel = this->Pointer();
  if (this->styles == 0 && this->Ours(pixel) && this->ModifiersAsked())
    if (const auto find = this->Look(); find && find(pixel))
    {
      this->held = true;
      this->Begin(pixel);
      return true;
    }
  this->styles |= Left;
  this->LookAway();
  if (this->ShowBrush(std::nullopt))
    this->Draw();
  return false;
}

bool vtkHaspSeedPainter::Internals::Release()
{
  if (!std::exchange(this->held, false))
    return false; // the style had the press
  this->End();
  return true;
}

bool vtkHaspSeedPainter::Internals::OtherPress(unsigned long event)
{
  if (this->held)
  {
    this->swallowed |= ButtonOf(event);
    return true;
  }
  this->swallowed &= ~ButtonOf(event);
  this->styles |= ButtonOf(event);
  this->LookAway();
  return false;
}

bool vtkHaspSeedPainter::Internals::OtherRelease(unsigned long event)
{
  const bool ours = (this->swallowed & ButtonOf(event)) != 0;
  this->swallowed &= ~ButtonOf(event);
  return ours;
}

bool vtkHaspSeedPainter::Internals::Wheel(double factor, bool wheel)
{
  const bool asked =
    !wheel || (this->interactor->GetShiftKey() && !this->interactor->GetControlKey());
  if (!asked || this->styles != 0 || !this->Ours(this->Pointer()))
    return this->held; // no zoom within a stroke
  constexpr double Least = 0.1, Most = 50.0;
  this->painter->SetRadiusMm(std::clamp(this->painter->RadiusMm * factor, Least, Most));
  return true;
}

bool vtkHaspSeedPainter::Internals::Key()
{
  const std::string key =
    this->interactor->GetKeySym() != nullptr ? this->interactor->GetKeySym() : "";
  if (key == "plus" || key == "KP_Add")
    return this->Wheel(Grown, false);
  if (key == "minus" || key == "KP_Subtract")
    return this->Wheel(1.0 / Grown, false);
  if (key != "Escape" || !this->painting)
    return false;
  this->painter->Cancel();
  return true;
}

void vtkHaspSeedPainter::Internals::Leave()
{
  if (this->held)
    return; // the drag goes on outside
  this->LookAway();
  if (this->ShowBrush(std::nullopt))
    this->Draw();
}

void vtkHaspSeedPainter::Internals::Begin(const glm::ivec2& pixel)
{
  this->painting = true;
  this->trail.Begin();
  this->UseBrush();
  this->prop->SetKeep(true);
  const hasp::BrushTrail::Finder find = this->Look();
  this->trail.MoveTo(pixel, find);
  this->paintedIn = this->plane;
  this->ShowBrush(find(pixel));
  this->painter->InvokeEvent(StrokeStartedEvent);
  this->Draw();
}

void vtkHaspSeedPainter::Internals::Extend(const glm::ivec2& pixel)
{
  const hasp::BrushTrail::Finder find = this->Look();
  if (this->paintedIn != this->plane)
    this->trail.Break(); // another slice
  const std::size_t pieces = this->trail.Pieces().size();
  this->UseBrush();
  const bool grown = this->trail.MoveTo(
    pixel, find ? find : [](const glm::ivec2&) { return std::nullopt; });
  const bool changed = grown || this->trail.Pieces().size() != pieces;
  this->paintedIn = this->plane;
  const bool moved = this->ShowBrush(find ? find(pixel) : std::nullopt);
  if (changed)
    this->painter->InvokeEvent(StrokeChangedEvent);
  if (changed || moved)
    this->Draw();
}

void vtkHaspSeedPainter::Internals::End()
{
  if (!std::exchange(this->painting, false))
    return;
  if (this->prop)
    this->prop->SetKeep(false);
  const bool grown = this->trail.End();
  if (grown)
    this->painter->InvokeEvent(StrokeChangedEvent);
  this->painter->InvokeEvent(StrokeEndedEvent);
  this->Draw();
}

void vtkHaspSeedPainter::Internals::UseBrush()
{
  this->trail.SetBrush(this->painter->Erase ? 0 : static_cast<std::uint16_t>(this->painter->Label),
    this->painter->RadiusMm);
}

hasp::BrushTrail::Finder vtkHaspSeedPainter::Internals::Look()
{
  if (this->inSlice)
  {
    this->plane = hasp::PlaneOf(this->slice);
    if (!this->plane || this->slice->GetVisibility() == 0)
      return nullptr;
    return [this, view = vtkHaspBrushProp::ViewOf(this->renderer), plane = *this->plane](
             const glm::ivec2& pixel) { return this->InSlice(view, pixel, plane); };
  }
  this->prop->SetLook(true);
  if (this->prop->GetSeen() == nullptr)
    this->Draw();
  if (!this->prop || this->prop->GetSeen() == nullptr)
    return nullptr;
  return [seen = this->prop->GetSeen()](const glm::ivec2& pixel) { return seen->At(pixel); };
}

std::optional<hasp::PixelPlace> vtkHaspSeedPainter::Internals::InSlice(
  const hasp::SeenDepth& view, const glm::ivec2& pixel, const hasp::SlicePlane& in)
{
  try
  {
    const auto place = hasp::PlaceInSlice(view, pixel, this->slice, in);
    this->faulty = false;
    return place;
  }
  catch (const std::exception& error)
  {
    if (!std::exchange(this->faulty, true))
      vtkErrorWithObjectMacro(
        this->painter, << "This slice cannot be painted in: " << error.what());
    return std::nullopt;
  }
}

bool vtkHaspSeedPainter::Internals::ShowBrush(const std::optional<hasp::PixelPlace>& place)
{
  if (!this->prop)
    return false;
  if (!place)
    return this->prop->SetBrush(std::nullopt);
  const int label = this->painter->Erase ? 0 : this->painter->Label;
  const auto said = this->colours.find(label);
  vtkHaspBrushProp::Brush brush;
  brush.world = place->world;
  brush.radiusMm = this->painter->RadiusMm;
  brush.colour = said != this->colours.end() ? said->second
                                             : hasp::PaletteColour(static_cast<hasp::Label>(label));
  brush.ball = !this->inSlice;
  if (this->inSlice && this->plane)
    brush.normal = this->plane->normal;
  return this->prop->SetBrush(brush);
}

void vtkHaspSeedPainter::Internals::Draw()
{
  if (this->interactor)
    this->interactor->Render();
}

/// No frame need be copied: the pointer is elsewhere.
void vtkHaspSeedPainter::Internals::LookAway()
{
  if (this->prop)
    this->prop->SetLook(false);
}
