#include "Window/MeasureDrag.h"

#include "Realtime/RateMonitor.h"
#include "Steps/ReducePanel.h"
#include "Window/MeasureScenes.h"
#include "Window/MeasureWindow.h"
#include "Window/PlannerWindow.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"

#include "vtkProp3D.h"

#include <nlohmann/json.hpp>

#include <QApplication>
#include <QMouseEvent>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr double MostReadyS = 120.0, MostHeldS = 20.0, RestS = 0.5, LookS = 0.02;

/// The pixel of the view, from its upper left, at which a fragment that may move is seen.
QPoint PixelOfFragment(const Planner& parts)
{
  SceneView& view = parts.views.Scene();
  for (const PlanFragment& fragment : parts.plan.Now().fragments)
  {
    vtkProp3D* prop = parts.scene.PropOf(fragment.id);
    if (fragment.locked || !prop)
      continue;
    const double* middle = prop->GetCenter();
    const auto pixel = view.PixelOf({ middle[0], middle[1], middle[2] });
    if (!pixel)
      continue;
    const QPoint at = pixel->toPoint();
    const double ratio = view.effectiveDevicePixelRatio();
    const auto place =
      parts.scene.PlaceAt(int(at.x() * ratio), int((view.height() - 1 - at.y()) * ratio));
    if (place && place->object == fragment.id)
      return at;
  }
  throw std::runtime_error("no fragment can be taken in hand");
}

void Mouse(SceneView& view, QEvent::Type type, const QPoint& at, bool down)
{
  QMouseEvent event(type, at, view.mapToGlobal(at),
    type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, down ? Qt::LeftButton : Qt::NoButton,
    Qt::NoModifier);
  QApplication::sendEvent(&view, &event);
}

/// Moves the pointer in a circle for so long. How many looks found the fragment in contact.
struct Motion
{
  double seconds = 0.0, leastShare = 1.0, touching = 0.0;
};

Motion MoveAbout(SceneView& view, const GrabTool& grab, const QPoint& from, double seconds)
{
  Motion motion;
  int looks = 0, touches = 0;
  const auto start = Clock::now();
  while (MsSince(start) < 1e3 * seconds)
  {
    const double way = 2.0 * std::numbers::pi * MsSince(start) / 1e3;
    Mouse(view, QEvent::MouseMove,
      from + QPoint(int(25.0 * std::sin(way)), int(12.0 * std::cos(way))), true);
    QApplication::processEvents();
    motion.leastShare = std::min(motion.leastShare, view.Share());
    touches += grab.State().isTouching;
    ++looks;
  }
  FinishDrawing(view);
  motion.seconds = 1e-3 * MsSince(start);
  motion.touching = double(touches) / looks;
  return motion;
}

template <typename Holds>
void WaitUntil(const char* what, double mostS, const Holds& holds)
{
  for (const auto start = Clock::now(); !holds(); Spend(LookS))
    if (MsSince(start) > 1e3 * mostS)
      throw std::runtime_error(what);
}

Json DragOnce(PlannerWindow& window, GrabTool& grab, double seconds)
{
  WaitUntil("what can be felt is not prepared", MostReadyS, [&] { return grab.State().isReady; });
  SceneView& view = window.Parts().views.Scene();
  const QPoint from = PixelOfFragment(window.Parts());
  Mouse(view, QEvent::MouseMove, from, false);
  Mouse(view, QEvent::MouseButtonPress, from, true);
  WaitUntil("the fragment is not in hand", MostHeldS, [&] { return !grab.State().held.empty(); });
  const unsigned long long before = view.Frames();
  const RateCounts first = grab.Haptic()->GetLoop()->GetRates();
  const Motion motion = MoveAbout(view, grab, from, seconds);
  const unsigned long long frames = view.Frames() - before;
  const RateCounts ticks = grab.Haptic()->GetLoop()->GetRates().Since(first);
  Spend(RestS); // it comes to rest where the hand is; the number of pixels stays
  DrawnMs(view);
  const QImage moving = view.grabFramebuffer();
  Mouse(view, QEvent::MouseButtonRelease, from, false);
  WaitSettled(window);
  const double rms = RmsBetween(moving, view.grabFramebuffer());
  window.Parts().plan.Undo();
  WaitSettled(window);
  return { { "frames", frames }, { "seconds", motion.seconds }, { "share", motion.leastShare },
    { "touching", motion.touching }, { "rms_255", rms }, { "ticks", ticks.ticks },
    { "skipped", ticks.skipped }, { "tick_us", 1e-3 * ticks.cost.PercentileNs(0.5) },
    { "tick_us_p99", 1e-3 * ticks.cost.PercentileNs(0.99) } };
}
} // namespace

Json MeasureDrag(PlannerWindow& window, double seconds)
{
  ShowBrokenJaw(window);
  window.ChooseStep("reduce");
  GrabTool& grab = static_cast<ReducePanel*>(window.Step("reduce"))->Grab();
  window.Parts().tools.Take(&grab);
  SceneView& view = window.Parts().views.Scene();
  Json measured = DragOnce(window, grab, seconds);
  const double aimed = std::exchange(view.framesAimed, 0.0);
  measured["full"] = DragOnce(window, grab, seconds);
  view.framesAimed = aimed;
  window.Parts().tools.Take(nullptr);
  return measured;
}

} // namespace hasp
