#pragma once
#include "Model/JobQueue.h"
#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "Tools/Tool.h"
#include "View/PlanScene.h"
#include "View/SceneView.h"
#include "View/ViewGrid.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>

namespace hasp
{

class HandDevices;
class HapticDevice;

/// Where the planner keeps what is its own (never a patient's): journals, kept scans, the recent
/// list.
struct PlannerFolders
{
  std::filesystem::path state; ///< $XDG_STATE_HOME/hasp-planner, ~/.local/state/hasp-planner
  std::filesystem::path plans; ///< where plans are saved unless said otherwise: ~/Hasp
};

/// Everything that the window's parts share. Made by PlannerWindow. Threads: RENDER.
struct Planner : public QObject
{
  Q_OBJECT
public:
  Planner(const PlannerFolders& folders, const std::filesystem::path& work, ViewGrid& views);

  PlannerFolders folders;
  PlanSession plan;
  ScanShelf scans;
  JobQueue jobs;
  ViewGrid& views;
  PlanScene scene; ///< in views.Scene()
  ToolBox tools;
  /// What moves tools besides the mouse: asked whenever one is taken in hand, and after
  /// DeviceChanged. None, or null: the mouse, and a 6-DOF mouse that the window hears.
  std::function<std::unique_ptr<HapticDevice>()> openDevice;
  HandDevices* devices = nullptr; ///< whose openDevice is; null: nobody's, or a recorded hand

  /// A line to the user, in the message bar until it is closed or another comes; faults stay red.
  void Say(const QString& text) { this->Tell(text, false); }
  void SayFault(const QString& text) { this->Tell(text, true); }

Q_SIGNALS:
  void Said(const QString& text, bool fault);
  /// What was said last is out of date: a job has said it, and the same is tried again.
  void Withdrawn();
  /// openDevice gives another one now, or none any more: what has one is to ask again.
  void DeviceChanged();

private:
  void Tell(const QString& text, bool fault);
  QString SaidBy; ///< the job; empty: none
};

} // namespace hasp
