#pragma once
#include "Tools/Planner.h"
#include "ViewsDesk.h"

#include <QAbstractButton>
#include <QStringList>
#include <QWidget>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

namespace hasp::testing
{

/// A folder that is gone with this; its name is a canary: no text may show it.
class CanaryFolder
{
public:
  static constexpr const char* Canary = "Mustermann";

  CanaryFolder();
  ~CanaryFolder();
  CanaryFolder(const CanaryFolder&) = delete;
  CanaryFolder& operator=(const CanaryFolder&) = delete;
  /// Made, if it is not there.
  std::filesystem::path Folder(const std::string& name) const;
  std::string File(const std::string& name) const { return (this->Place / name).string(); }

private:
  std::filesystem::path Place;
};

/// What the planner's window holds, without the window: views on the screen, and a hand with a
/// mouse.
class StepsOneDesk
{
public:
  /// `state`: as another planner left it, if there was one.
  StepsOneDesk(const CanaryFolder& folder, const std::string& state = "state");

  ViewsDesk desk;
  Planner planner;
  QStringList said, faults;

  const Plan& Now() const { return this->planner.plan.Now(); }
  std::size_t Steps() const { return this->planner.plan.Document().history.Done(); }
  /// Until nothing runs and nothing is to be drawn. False: it goes on after a minute.
  bool Settle();

  template <typename Widget>
  static Widget& Find(QWidget& panel, const char* name)
  {
    if (auto* found = panel.findChild<Widget*>(QLatin1String(name)))
      return *found;
    throw std::logic_error(std::string("no widget ") + name);
  }
  static void Click(QWidget& panel, const char* name)
  {
    Find<QAbstractButton>(panel, name).click();
  }
  /// Where a place of the world is seen in the 3D view.
  QPoint PixelOf(const glm::dvec3& world) const;
};

/// Two balls of bone of 8 mm, `gapMm` apart along x (less than 0: they are one bone), in the middle
/// of the world. 500 a millimetre, bone is 226 and more; 1 mm voxels.
vtkSmartPointer<vtkImageData> TwoBalls(double gapMm);
constexpr double BallMm = 8.0;
/// The middle of the left one (1: patient's left, x > 0) or of the right one (-1).
glm::dvec3 BallMiddle(double gapMm, int side);

} // namespace hasp::testing
