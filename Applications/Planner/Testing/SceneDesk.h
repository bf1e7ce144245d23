#pragma once
#include "Model/JobQueue.h"
#include "Model/PlanSession.h"
#include "Model/ScanShelf.h"
#include "View/PlanScene.h"
#include "View/SceneView.h"

#include "Grid/GridGeometry.h"

#include <QImage>
#include <QStringList>
#include <QTemporaryDir>

#include <filesystem>
#include <functional>
#include <string>

class vtkActor;

namespace hasp::testing
{

/// A plan, its scans and its scene in a window on the screen.
class SceneDesk
{
public:
  SceneDesk();
  ~SceneDesk();

  QTemporaryDir folder;
  PlanSession plan;
  ScanShelf scans{ {} };
  JobQueue jobs;
  SceneView view;
  PlanScene scene;
  QStringList refused; ///< by plan, scene and jobs

  /// The object with a new id, as a step.
  template <typename T>
  PlanId Add(T object)
  {
    object.id = this->plan.NewId();
    this->plan.Do(AddObject<T>{ object });
    return object.id;
  }
  /// A scan in memory and in the plan, of Hounsfield units.
  PlanId AddScan(vtkImageData* image, const std::string& hash);
  /// Jobs and frames.
  void Settle();
  /// As it is seen; kept among the tests' pictures, to be looked at.
  QImage Picture(const char* name);
  /// Pixels where a place of the world is seen, from the lower left.
  QPoint PixelOf(const glm::dvec3& world) const;
  vtkActor* ActorOf(PlanId object) const;
  /// Of that name; a reason alone where there is none.
  ResourceUse UseOf(const std::string& resource) const;
  std::size_t Props() const; ///< in the renderer
};

constexpr double BallValuePerMm = 100.0; ///< grey values around 226

/// Two balls as a scan with 1 mm samples on turned axes.
struct TwoBalls
{
  glm::dvec3 left{ -16.0, 0.0, 1.0 }, right{ 15.0, 3.0, -2.0 };
  double leftRadius = 12.0, rightRadius = 10.0;
  GridGeometry grid;
  vtkSmartPointer<vtkImageData> image;

  TwoBalls();
  /// To the balls' surfaces, NEGATIVE INSIDE.
  double Distance(const glm::dvec3& p) const;
};
extern const std::string BallsHash;

/// A fragment by a seed in volume 1.
PlanFragment Component(const glm::dvec3& seed);
PlanFragment PieceOf(PlanId fragment, const glm::dvec3& seed);
/// Across x.
PlanCut CutAt(double x, PlanId fragment);

} // namespace hasp::testing
