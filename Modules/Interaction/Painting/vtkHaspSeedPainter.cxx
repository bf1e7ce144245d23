#include "vtkHaspSeedPainter.h"

#include "LabelPalette.h"
#include "PainterInternals.h"

#include "Segmentation/LabelMap.h"

#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <cstddef>

vtkStandardNewMacro(vtkHaspSeedPainter);

namespace
{
constexpr double MostRadiusMm = 50.0; // of a BrushStroke
}

vtkHaspSeedPainter::vtkHaspSeedPainter() : Self(std::make_unique<Internals>(this)) {}

vtkHaspSeedPainter::~vtkHaspSeedPainter()
{
  Internals& self = *this->Self;
  self.Follow(nullptr);
  if (self.renderer && self.prop)
    self.renderer->RemoveViewProp(self.prop);
}

void vtkHaspSeedPainter::SetRenderer(vtkRenderer* renderer)
{
  Internals& self = *this->Self;
  if (self.renderer == renderer)
    return;
  const bool enabled = self.enabled;
  this->SetEnabled(false);
  self.renderer = renderer;
  this->Modified();
  if (enabled && renderer != nullptr)
    this->SetEnabled(true);
}

vtkRenderer* vtkHaspSeedPainter::GetRenderer() const
{
  return this->Self->renderer;
}

void vtkHaspSeedPainter::SetSlice(vtkImageSlice* slice)
{
  Internals& self = *this->Self;
  if (self.slice == slice && self.inSlice == (slice != nullptr))
    return;
  self.End();
  self.slice = slice;
  self.inSlice = slice != nullptr;
  self.plane.reset();
  self.faulty = false;
  self.LookAway();
  self.ShowBrush(std::nullopt);
  this->Modified();
}

vtkImageSlice* vtkHaspSeedPainter::GetSlice() const
{
  return this->Self->slice;
}

void vtkHaspSeedPainter::SetEnabled(bool enabled)
{
  Internals& self = *this->Self;
  if (self.enabled == enabled)
    return;
  vtkRenderWindow* window = self.renderer ? self.renderer->GetRenderWindow() : nullptr;
  if (enabled && (window == nullptr || window->GetInteractor() == nullptr))
  {
    vtkErrorMacro(
      << "Painting follows the interactor of a renderer's window; put the renderer into "
         "a window, give that one, then call SetRenderer and EnabledOn");
    return;
  }
  if (!enabled)
    self.End(); // whose observers may do the same
  if (self.enabled == enabled)
    return;
  self.enabled = enabled;
  self.Follow(enabled ? window->GetInteractor() : nullptr);
  if (enabled)
  {
    self.prop = vtkSmartPointer<vtkHaspBrushProp>::New();
    self.renderer->AddViewProp(self.prop);
  }
  else if (self.renderer)
    self.renderer->RemoveViewProp(self.prop);
  if (!enabled)
    self.prop = nullptr;
  this->Modified();
}

bool vtkHaspSeedPainter::GetEnabled() const
{
  return this->Self->enabled;
}

void vtkHaspSeedPainter::SetLabel(int label)
{
  if (label < 1 || label > hasp::MaxLabel)
    vtkErrorMacro(<< "Label " << label << " cannot be painted, it must be in [1, " << hasp::MaxLabel
                  << "]; EraseOn paints label 0");
  else if (this->Label != label)
  {
    this->Label = label;
    this->Modified();
  }
}

void vtkHaspSeedPainter::SetRadiusMm(double mm)
{
  if (!(mm > 0.0 && mm <= MostRadiusMm))
  {
    vtkErrorMacro(<< "A brush of " << mm << " mm; its radius must be in (0, " << MostRadiusMm
                  << "] mm");
    return;
  }
  if (this->RadiusMm == mm)
    return;
  this->RadiusMm = mm;
  this->Modified();
  Internals& self = *this->Self;
  if (self.prop && self.prop->GetBrush())
  {
    vtkHaspBrushProp::Brush brush = *self.prop->GetBrush();
    brush.radiusMm = mm;
    self.prop->SetBrush(brush);
    self.Draw();
  }
  this->InvokeEvent(RadiusChangedEvent);
}

void vtkHaspSeedPainter::SetLabelColor(int label, double r, double g, double b)
{
  if (!hasp::IsColour(label, { r, g, b }))
  {
    vtkErrorMacro(<< "Label " << label << " cannot have the colour " << r << ", " << g << ", " << b
                  << "; labels are in [0, " << hasp::MaxLabel << "], components in [0, 1]");
    return;
  }
  this->Self->colours[label] = { r, g, b };
  this->Modified();
}

bool vtkHaspSeedPainter::IsPainting() const
{
  return this->Self->painting;
}

void vtkHaspSeedPainter::Cancel()
{
  Internals& self = *this->Self;
  if (!self.painting)
    return;
  self.painting = false;
  self.prop->SetKeep(false);
  self.trail.Begin();
  this->InvokeEvent(StrokeCancelledEvent);
  self.Draw();
}

const std::vector<hasp::BrushStroke>& vtkHaspSeedPainter::GetPieces() const
{
  return this->Self->trail.Pieces();
}

const hasp::BrushStroke& vtkHaspSeedPainter::GetStroke() const
{
  static const hasp::BrushStroke none;
  return this->GetPieces().empty() ? none : this->GetPieces().back();
}

int vtkHaspSeedPainter::GetNumberOfPieces() const
{
  return static_cast<int>(this->GetPieces().size());
}

int vtkHaspSeedPainter::GetNumberOfPoints(int piece) const
{
  return piece >= 0 && piece < this->GetNumberOfPieces()
           ? static_cast<int>(this->GetPieces()[piece].points.size())
           : 0;
}

bool vtkHaspSeedPainter::GetPoint(int piece, int point, double world[3]) const
{
  if (point < 0 || point >= this->GetNumberOfPoints(piece))
    return false;
  const glm::dvec3& at = this->GetPieces()[piece].points[point];
  std::copy_n(&at.x, 3, world);
  return true;
}

bool vtkHaspSeedPainter::GetPlace(int x, int y, double world[3])
{
  Internals& self = *this->Self;
  vtkRenderWindow* window = self.renderer ? self.renderer->GetRenderWindow() : nullptr;
  if (!self.enabled || window == nullptr || window->GetNeverRendered() ||
      !self.renderer->IsActiveCameraCreated())
    return false;
  const hasp::BrushTrail::Finder find = self.Look();
  const auto place = find ? find({ x, y }) : std::nullopt;
  if (!place)
    return false;
  std::copy_n(&place->world.x, 3, world);
  return true;
}

void vtkHaspSeedPainter::ListResources(hasp::ResourceList& resources) const
{
  if (this->Self->prop)
    this->Self->prop->ListResources(resources);
  else
    resources.push_back({ "painting depth", 0, 0.0, "painting is switched off" });
}

void vtkHaspSeedPainter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << (this->GetEnabled() ? "on" : "off") << "\n"
     << indent << "Painting: " << (this->IsPainting() ? "yes" : "no") << "\n"
     << indent << "Modifier: " << this->Modifier << "\n"
     << indent << "Label: " << this->Label << "\n"
     << indent << "Erase: " << (this->Erase ? "on" : "off") << "\n"
     << indent << "RadiusMm: " << this->RadiusMm << "\n"
     << indent << "Pieces: " << this->GetNumberOfPieces() << "\n";
}
