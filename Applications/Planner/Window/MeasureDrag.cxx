#include "Window/MeasureDrag.h"

#include "Realtime/RateMonitor.h"
#include "Steps/ReducePanel.h"
#include "Studies/FractureCases.h"
#include "Window/MeasureWindow.h"
#include "Window/PlannerWindow.h"
#include "vtkHaspHapticInteractor.h"
#include "vtkHaspHapticLoop.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkProp3D.h"

#include <nlohmann/json.hpp>

#include <QApplication>
#include <QMouseEvent>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;

std::string WholeFile(const std::filesystem::path& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(text).str();
}

/// A broken mandible with its true labels as fragments, the first locked.
void ShowBrokenJaw(PlannerWindow& window)
{
  const FractureCase jaw = BrokenMandible({ .spacingMm = 0.8 });
  FracturedScan scan = BreakPhantom(jaw.geometry, jaw.settings);
  Planner& parts = window.Parts();
  parts.plan.BeginNew();
  const std::filesystem::path file = parts.plan.Folder() / "measured.nrrd";
  WriteVolume(MakeImage(scan.geometry, scan.truth), file.string());
  const std::string labels = parts.plan.StoreBlob(WholeFile(file));
  std::filesystem::remove(file);
  ShelfScan shelf;
  shelf.passport.geometry = scan.geometry;
  shelf.passport.hounsfield = true;
  shelf.passport.hash =
    VolumeHash(GridView<const std::int16_t>{ scan.samples.data(), scan.geometry });
  shelf.image = MakeImage(scan.geometry, std::move(scan.samples));
  PlanId id = parts.plan.NewId();
  const PlanId volume = id++, map = id++;
  std::vector<PlanEdit> edits{ AddObject<PlanVolume>{ { volume, "jaw", shelf.passport.hash } },
    AddObject<PlanSegmentation>{ { map, "pieces", volume, labels } } };
  for (std::size_t n = 0; n < scan.names.size(); ++n)
  {
    PlanFragment fragment;
    fragment.id = id++;
    fragment.name = scan.names[n];
    fragment.source = LabelSource{ map, std::uint32_t(2 + n), 226.0, 0.8 };
    fragment.locked = n == 0;
    edits.push_back(AddObject<PlanFragment>{ fragment });
  }
  parts.scans.Put(std::move(shelf));
  parts.plan.Do(std::move(edits));
  WaitSettled(window);
  parts.scene.LookFrom('A');
  WaitSettled(window);
}

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

Json DragOnce(PlannerWindow& window, GrabTool& grab, double seconds)
{
  SceneView& view = window.Parts().views.Scene();
  const QPoint from = PixelOfFragment(window.Parts());
  Mouse(view, QEvent::MouseMove, from, false);
  Mouse(view, QEvent::MouseButtonPress, from, true);
  const unsigned long long before = view.Frames();
  const RateCounts first = grab.Haptic()->GetLoop()->GetRates();
  const auto start = Clock::now();
  double least = 1.0;
  QImage last;
  while (MsSince(start) < 1e3 * seconds)
  {
    const double way = 2.0 * std::numbers::pi * MsSince(start) / 1e3;
    Mouse(view, QEvent::MouseMove,
      from + QPoint(int(25.0 * std::sin(way)), int(12.0 * std::cos(way))), true);
    QApplication::processEvents();
    least = std::min(least, view.Share());
  }
  const double took = 1e-3 * MsSince(start);
  const unsigned long long frames = view.Frames() - before;
  last = view.grabFramebuffer();
  const RateCounts ticks = grab.Haptic()->GetLoop()->GetRates().Since(first);
  view.DrawNow();
  const double rms = RmsBetween(last, view.grabFramebuffer());
  Mouse(view, QEvent::MouseButtonRelease, from, false);
  WaitSettled(window);
  window.Parts().plan.Undo();
  WaitSettled(window);
  return { { "frames", frames }, { "seconds", took }, { "share", least }, { "rms_255", rms },
    { "ticks", ticks.ticks }, { "skipped", ticks.skipped },
    { "tick_us", 1e-3 * ticks.cost.PercentileNs(0.5) } };
}
} // namespace

Json MeasureDrag(PlannerWindow& window, double seconds)
{
  ShowBrokenJaw(window);
  window.ChooseStep("reduce");
  GrabTool& grab = static_cast<ReducePanel*>(window.Step("reduce"))->Grab();
  window.Parts().tools.Take(&grab);
  const auto start = Clock::now();
  while (!grab.State().isReady && MsSince(start) < 120e3)
    Spend(0.1);
  SceneView& view = window.Parts().views.Scene();
  Json measured = DragOnce(window, grab, seconds);
  const double aimed = std::exchange(view.framesAimed, 0.0);
  measured["full"] = DragOnce(window, grab, seconds);
  view.framesAimed = aimed;
  window.Parts().tools.Take(nullptr);
  return measured;
}

} // namespace hasp
