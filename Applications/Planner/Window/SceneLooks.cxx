#include "Window/SceneLooks.h"

#include "Tools/Planner.h"
#include "View/ScanLooks.h"
#include "View/ViewLight.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QInputDialog>
#include <QMenu>

namespace hasp
{
namespace
{

struct Words
{
  Q_DECLARE_TR_FUNCTIONS(SceneLooks)
};

void AddSwitch(QMenu& menu, const QString& text, const char* name, const QKeySequence& key,
  PlanScene& scene, void (ScanLooks::*set)(bool))
{
  QAction* action = menu.addAction(text);
  action->setObjectName(name);
  action->setShortcut(key);
  action->setCheckable(true);
  QObject::connect(
    action, &QAction::toggled, &scene, [&scene, set](bool on) { (scene.Looks().*set)(on); });
}

void AskSkin(Planner& planner)
{
  const ShelfScan* scan = planner.scans.OfVolume(planner.plan.Now(), planner.scene.ShownVolume());
  if (!scan)
    return planner.Say(Words::tr("There is no scan: import one first."));
  const Passport& passport = scan->passport;
  QInputDialog ask(planner.views.window());
  ask.setObjectName("skin");
  ask.setWindowTitle(Words::tr("Skin"));
  ask.setLabelText(passport.hounsfield ? Words::tr("Skin begins at, HU (air is -1000)")
                                       : Words::tr("Skin begins at, in the scan's values"));
  ask.setInputMode(QInputDialog::DoubleInput);
  ask.setDoubleDecimals(1);
  ask.setDoubleRange(passport.minimum, passport.maximum);
  ask.setDoubleValue(planner.scene.Looks().SkinValue());
  if (ask.exec() == QDialog::Accepted)
    planner.scene.Looks().SetSkinValue(ask.doubleValue());
}

/// Of all that the view shows; plain alone where there is no other.
void AddLight(QMenu& menu, PlanScene& scene)
{
  QMenu* light = menu.addMenu(Words::tr("&Light"));
  light->setObjectName("menu.light");
  auto* modes = new QActionGroup(light);
  const auto add = [&](const QString& text, const char* name, ViewLight::Mode mode)
  {
    QAction* action = light->addAction(text);
    action->setObjectName(name);
    action->setCheckable(true);
    action->setChecked(mode == ViewLight::Plain);
    action->setEnabled(mode == ViewLight::Plain || ViewLight::IsThere());
    modes->addAction(action);
    QObject::connect(
      action, &QAction::triggered, &scene, [&scene, mode] { scene.Looks().Light().SetMode(mode); });
  };
  add(Words::tr("&Plain"), "view.light.plain", ViewLight::Plain);
  add(Words::tr("&Ambient occlusion: darker where surfaces are close"), "view.light.ambient",
    ViewLight::AmbientOcclusion);
  add(Words::tr("&Traced: daylight with shadows"), "view.light.traced", ViewLight::Traced);
}

} // namespace

void AddSceneLooks(QMenu& menu, Planner& planner)
{
  QMenu* looks = menu.addMenu(Words::tr("3D &view"));
  looks->setObjectName("menu.scene");
  AddSwitch(*looks, Words::tr("&Skin over bone"), "view.skin", QKeySequence("Ctrl+K"),
    planner.scene, &ScanLooks::SetSkin);
  QAction* begins = looks->addAction(Words::tr("Skin be&gins at …"));
  begins->setObjectName("view.skin.value");
  QObject::connect(begins, &QAction::triggered, &planner.scene, [&planner] { AskSkin(planner); });
  AddSwitch(*looks, Words::tr("&Brightest values, without bone's surface"), "view.brightest",
    QKeySequence("Ctrl+B"), planner.scene, &ScanLooks::SetBrightest);
  AddLight(*looks, planner.scene);
}

} // namespace hasp
