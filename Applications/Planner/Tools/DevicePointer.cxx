#include "Tools/DevicePointer.h"

#include "Devices/HapticDevice.h"
#include "HapticExchange.h"
#include "Tools/Planner.h"
#include "Tools/ToolMarks.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"

#include "vtkRenderer.h"

#include <QColor>
#include <QCoreApplication>
#include <QMouseEvent>

#include <utility>

namespace hasp
{
namespace
{
constexpr int LookMs = 16;
constexpr double SeenMm = 1.0; // so near to a slice the tip is full in it
const QColor TipColour(120, 220, 255);
} // namespace

bool GiveDevice(vtkHaspHapticInteractor& hand, Planner& planner)
{
  if (!planner.openDevice)
    return false;
  std::unique_ptr<HapticDevice> device = planner.openDevice();
  return device && hand.SetDevice(std::move(device));
}

DevicePointer::DevicePointer(Planner& planner, QObject* parent)
  : QObject(parent),
    Of(planner),
    Faults([&planner](const QString& text) { planner.SayFault(text); })
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void* button)
    {
      if (*static_cast<const int*>(button) == 0)
        static_cast<DevicePointer*>(self)->Pressed.push_back(
          event == vtkHaspHapticInteractor::ButtonPressEvent ? QEvent::MouseButtonPress
                                                             : QEvent::MouseButtonRelease);
    });
  this->Looking.setInterval(LookMs);
  connect(&this->Looking, &QTimer::timeout, this, &DevicePointer::Look);
  connect(&planner.tools, &ToolBox::Changed, this, &DevicePointer::Follow);
  connect(&planner, &Planner::DeviceChanged, this,
    [this]
    {
      if (this->IsOn())
        this->End();
      this->Follow();
    });
}

DevicePointer::~DevicePointer() = default;

void DevicePointer::Follow()
{
  const Tool* tool = this->Of.tools.InHand();
  const bool wanted = tool && !tool->TakesDevice() && this->Of.openDevice;
  if (wanted && !this->IsOn())
    this->Begin();
  else if (!wanted && this->IsOn())
    this->End();
}

void DevicePointer::Begin()
{
  std::unique_ptr<HapticDevice> device = this->Of.openDevice();
  if (!device)
    return;
  this->Hand = vtkSmartPointer<vtkHaspHapticInteractor>::New();
  this->Faults.Follow(this->Hand);
  this->Faults.Follow(this->Hand->GetLoop());
  this->Hand->SetRenderer(this->Of.views.Scene().Renderer());
  if (!this->Hand->SetDevice(std::move(device)) || !this->Hand->Start())
  {
    this->Hand = nullptr;
    return;
  }
  this->Hand->AddObserver(vtkHaspHapticInteractor::ButtonPressEvent, this->Command);
  this->Hand->AddObserver(vtkHaspHapticInteractor::ButtonReleaseEvent, this->Command);
  this->Marks = std::make_unique<ToolMarks>(this->Of.views,
    [this](QPainter& painter, const MarkedView& view) { this->Paint(painter, view); });
  this->Looking.start();
}

void DevicePointer::End()
{
  this->Looking.stop();
  if (std::exchange(this->IsDown, false)) // the view's drag, if it is one, ends too
    this->Send(QEvent::MouseButtonRelease);
  this->Pressed.clear();
  this->Marks.reset();
  this->Hand->Stop();
  this->Hand = nullptr;
}

void DevicePointer::Look()
{
  const auto hand = this->Hand; // a tool may put itself away by what it is told
  hand->Update();
  const HapticSnapshot& seen = hand->GetLoop()->GetSnapshot();
  const auto pixel = this->Of.views.Scene().PixelOf(seen.tool.position);
  if (seen.ticks == 0 || !pixel)
    return;
  this->Marks->Update();
  if (std::exchange(this->At, *pixel) != *pixel)
    this->Send(QEvent::MouseMove);
  for (const QEvent::Type type : std::exchange(this->Pressed, {}))
  {
    if (this->Hand != hand)
      return;
    this->IsDown = type == QEvent::MouseButtonPress;
    this->Send(type);
  }
}

void DevicePointer::Send(QEvent::Type type)
{
  SceneView& view = this->Of.views.Scene();
  const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
  QMouseEvent event(type, this->At, this->At, view.mapToGlobal(this->At.toPoint()), button,
    this->IsDown ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&view, &event);
}

void DevicePointer::Paint(QPainter& painter, const MarkedView& view) const
{
  const glm::dvec3 tip = this->Hand->GetLoop()->GetSnapshot().tool.position;
  if (const auto pixel = view.PixelOf(tip))
    PaintBall(painter, *pixel, TipColour, {}, this->IsDown, view.Off(tip) > SeenMm);
}

} // namespace hasp
