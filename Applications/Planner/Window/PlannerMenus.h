#pragma once
#include <QKeySequence>
#include <QString>

#include <functional>

class QAction;
class QMenu;

namespace hasp
{

class PlannerWindow;

/// Fills the window's menu bar; every action of the window is in a menu, with its key, so that the
/// keyboard reaches all of it. Threads: RENDER.
class PlannerMenus
{
public:
  explicit PlannerMenus(PlannerWindow& window) : Window(window) {}
  void Add();

private:
  void AddFile();
  void AddEdit();
  void AddView();
  void AddMeasure();
  void AddHelp();
  QAction* AddAction(QMenu* menu, const QString& text, const char* name, const QKeySequence& key,
    std::function<void()> act);
  void AddChoice(QMenu* menu, const QString& text, const char* name, const QKeySequence& key,
    bool checked, std::function<void(bool)> act);
  void FillRecent(QMenu* menu);
  void AddPutAway(QMenu* menu);

  PlannerWindow& Window;
};

} // namespace hasp
