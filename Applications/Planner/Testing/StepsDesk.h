#pragma once
#include "Tools/Planner.h"
#include "ViewsDesk.h"

#include <QString>

#include <filesystem>
#include <functional>
#include <string>

class QWidget;

namespace hasp::testing
{

/// A planner with a scan in its views, a panel beside them, and a hand that touches, types and
/// presses buttons. A folder of its own, gone afterwards.
class StepsDesk
{
public:
  /// The scan is volume 1.
  explicit StepsDesk(vtkSmartPointer<vtkImageData> scan);
  ~StepsDesk();

private:
  std::filesystem::path Folder; ///< before the planner, which works in it

public:
  ViewsDesk views;
  Planner planner;
  QString said; ///< the last fault

  /// Another scan of the plan, in memory. Its id.
  PlanId Add(vtkSmartPointer<vtkImageData> scan);
  void Show(QWidget* panel); ///< in a window of its own; the caller owns it
  /// Until no job runs and all is drawn.
  void Settle();

  const Plan& Now() const { return this->planner.plan.Now(); }
  std::size_t Steps() const { return this->planner.plan.Document().history.Done(); }

  ///@{
  /// Places are of the world.
  QPoint PixelOf(const glm::dvec3& place);
  void Touch(const glm::dvec3& place);                 ///< a click in the 3D view
  void Drag(const glm::dvec3& from, const QPoint& by); ///< in the 3D view
  ///@}
  /// Makes the bar a fragment, if there is none, and cuts it across at x. The cut's id.
  PlanId CutBar(double x);

  ///@{
  /// Widgets of the shown panel, by name. Fail the case where there is none.
  void Press(const char* name);
  void Type(const char* name, const QString& text); ///< and Enter; a box or a line
  void TypePoints(const char* name, const std::vector<glm::dvec3>& points); ///< PointsEdit's rows
  void Choose(const char* name, int row);
  QWidget* Find(const char* name);
  QString TextOf(const char* name); ///< of a label
  ///@}

private:
  void ShowSlices(); ///< of the scan that the 3D view shows, as the window does

  QWidget* Panel = nullptr;
};

/// A bar of radius 6 along x, 60 mm long with its round ends, bone of 1000 HU a mm at its surface,
/// on a grid of 1 mm.
vtkSmartPointer<vtkImageData> ScanOfBar();

/// On the bar's front, as it is seen at first: from anterior, which is -y.
glm::dvec3 Front(double x, double z = 0.0);
/// How far a place is from the bar's surface, mm.
double OffBar(const glm::dvec3& place);
/// Of a click: half a pixel across the view, and the isosurface of samples of 1 mm.
inline constexpr double ClickMm = 0.4, SurfaceMm = 0.1;

/// Where the camera is.
glm::dvec3 EyeOf(FrameView& view);

} // namespace hasp::testing
