#include "Window/ViewPresets.h"

#include "Tools/Planner.h"
#include "View/SliceView.h"

#include <QCoreApplication>
#include <QMenu>

namespace hasp
{
namespace
{
struct Words
{
  Q_DECLARE_TR_FUNCTIONS(ViewPresets)
};

struct Side
{
  char side;
  const char* text;
  const char* key; ///< as Blender and F3D have them, of the keypad's digits
};
constexpr Side Sides[] = {
  { 'A', QT_TRANSLATE_NOOP("ViewPresets", "From the f&ront"), "Alt+1" },
  { 'P', QT_TRANSLATE_NOOP("ViewPresets", "From be&hind"), "Alt+Shift+1" },
  { 'L', QT_TRANSLATE_NOOP("ViewPresets", "From the patient's &left"), "Alt+3" },
  { 'R', QT_TRANSLATE_NOOP("ViewPresets", "From the patient's ri&ght"), "Alt+Shift+3" },
  { 'S', QT_TRANSLATE_NOOP("ViewPresets", "From a&bove"), "Alt+7" },
  { 'I', QT_TRANSLATE_NOOP("ViewPresets", "From b&elow"), "Alt+Shift+7" },
};

/// 3D Slicer's, of CT.
struct Grey
{
  const char* text;
  const char* name;
  double window, level;
};
constexpr Grey Greys[] = {
  { QT_TRANSLATE_NOOP("ViewPresets", "Bone"), "bone", 1000.0, 400.0 },
  { QT_TRANSLATE_NOOP("ViewPresets", "Soft tissue"), "soft", 350.0, 40.0 },
  { QT_TRANSLATE_NOOP("ViewPresets", "Brain"), "brain", 100.0, 50.0 },
  { QT_TRANSLATE_NOOP("ViewPresets", "Air"), "air", 1000.0, -426.0 },
  { QT_TRANSLATE_NOOP("ViewPresets", "Metal and teeth"), "metal", 4000.0, 1500.0 },
};
} // namespace

void AddViewPresets(QMenu& menu, Planner& planner)
{
  PlanScene* scene = &planner.scene;
  for (const Side& one : Sides)
  {
    QAction* action = menu.addAction(Words::tr(one.text));
    action->setObjectName(QString("view.from.%1").arg(QChar(one.side).toLower()));
    action->setShortcut(QKeySequence(one.key));
    QObject::connect(
      action, &QAction::triggered, scene, [scene, side = one.side] { scene->LookFrom(side); });
  }
  QAction* all = menu.addAction(Words::tr("&All in sight"));
  all->setObjectName("view.all");
  all->setShortcut(QKeySequence("Ctrl+R"));
  QObject::connect(all, &QAction::triggered, scene, [scene] { scene->ShowAll(); });
  menu.addSeparator();
  QMenu* greys = menu.addMenu(Words::tr("&Window and level"));
  greys->setObjectName("menu.greys");
  ViewGrid* views = &planner.views;
  for (const Grey& one : Greys)
  {
    QAction* action = greys->addAction(
      Words::tr("%1: %2 / %3").arg(Words::tr(one.text)).arg(one.window).arg(one.level));
    action->setObjectName(QString("view.grey.%1").arg(one.name));
    QObject::connect(action, &QAction::triggered, views,
      [views, one] { views->SetWindowLevel(one.window, one.level); });
  }
}

} // namespace hasp
