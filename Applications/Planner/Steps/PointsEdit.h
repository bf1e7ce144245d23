#pragma once
#include "Tools/LandmarkTool.h"

#include <QWidget>

#include <vector>

class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace hasp
{

struct Planner;

/// A list of touched places: touched in the views, at the crosshair, or typed.
///
/// Widgets: NAME (takes the tool in hand, and puts it away), NAME.list (x, y, z, mm, where the plan
/// keeps them), NAME.crosshair, NAME.remove, NAME.up, NAME.down.
/// Threads: RENDER. Cost: a LandmarkTool's that shows, while the list is shown.
class PointsEdit : public QWidget
{
  Q_OBJECT
public:
  enum class Space
  {
    Scan,
    Planned
  };
  PointsEdit(Planner& planner, const QString& name, const QString& text, LandmarkPurpose purpose,
    Space space = Space::Scan, QWidget* parent = nullptr);

  LandmarkTool& Tool() { return this->Hand; }
  const std::vector<TouchedPlace>& Places() const { return this->Hand.Places(); }
  std::vector<glm::dvec3> Points() const; ///< in its space
  /// As the plan has them; nobody is told. Places that stay keep what is known of them.
  void SetPoints(const std::vector<glm::dvec3>& points, PlanId object);
  void SetPlaces(std::vector<TouchedPlace> places);
  void Take(); ///< the tool in hand
  void PutAway();

Q_SIGNALS:
  void Edited(); ///< by hand or by typing

protected:
  void showEvent(QShowEvent* event) override; ///< its places are seen, in hand or not
  void hideEvent(QHideEvent* event) override; ///< puts it away: another page is turned to

private:
  void Build(const QString& name, const QString& text);
  glm::dvec3 PointOf(const TouchedPlace& place) const;
  void Fill();
  void ShowSelected(int place);
  void Type(QTableWidgetItem* item);
  void Swap(int by);

  Planner& Of;
  Space In;
  LandmarkTool Hand;
  QTableWidget* List;
  QPushButton *Touch, *Crosshair, *Remove, *Up, *Down;
  bool Filling = false;
};

} // namespace hasp
