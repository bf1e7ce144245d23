#pragma once
#include "Grid/RigidPose.h"
#include "Planning/Plan.h"
#include "Tools/DistanceBody.h"
#include "Tools/PropCover.h"
#include "View/SceneJob.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QObject>

#include <map>
#include <memory>
#include <vector>

class vtkActor;
class vtkDiscretizableColorTransferFunction;
class vtkScalarBarActor;

namespace hasp
{

struct Planner;

/// Colours fragments by how far each place of their surface is from all others as they stand now:
/// from -3 mm, which is inside (blue), to 3 mm (red), whatever the data, with a scale beside. Live:
/// each frame asks where the props stand, in hand or not.
///
/// Surfaces are meshes of the fragments' own voxels; what they are held against are sampled
/// distances of the others, each in its own axes, so that nothing is made anew when one moves.
/// Error: 0.05 of the sampling's spacing (DistanceTo: 0.02 to 0.1 mm), more at sharp edges. Where
/// two others overlap the least of their distances counts.
///
/// Threads: RENDER; meshes and distances are made on the WORKER. Cost: nothing while it is off;
/// then 8 MB a fragment, and 4 ms a frame for 200,000 points before each fragment that is near.
class DistanceColours : public QObject
{
  Q_OBJECT
public:
  static constexpr double RangeMm = 3.0;

  explicit DistanceColours(Planner& planner, QObject* parent = nullptr);
  ~DistanceColours() override;

  void SetOn(bool on);
  bool IsOn() const { return this->Scale != nullptr; }
  /// Which are coloured: in hand, or selected. None: no colours.
  void SetFragments(std::vector<PlanId> fragments);
  /// The coloured surface of a fragment, point scalars "SignedDistance" in mm, NEGATIVE INSIDE, as
  /// of the last Update; nullptr: it is off, or not made yet.
  vtkPolyData* SurfaceOf(PlanId fragment) const;
  /// To where the props stand now; each frame begins with it.
  void Update();

private:
  struct Coloured
  {
    vtkSmartPointer<vtkPolyData> surface;
    vtkSmartPointer<vtkActor> actor;
    std::vector<RigidPose> poses; ///< that its distances are of: its own, the others'
  };

  void Follow();
  void MakeMissing();
  void Take(const std::vector<MadeDistance>& made);
  void ShowColours();
  void Colour(PlanId fragment, Coloured& coloured);
  bool IsColoured(PlanId fragment) const;

  Planner& Of;
  std::vector<PlanId> Fragments;
  std::map<PlanId, MadeDistance> Known;
  SceneJob Job;
  std::map<PlanId, Coloured> Shown;
  PropCover Covered;
  vtkSmartPointer<vtkDiscretizableColorTransferFunction> Colours;
  vtkSmartPointer<vtkScalarBarActor> Scale; ///< null: it is off
  vtkNew<vtkCallbackCommand> Command;
  unsigned long FrameTag = 0;
};

} // namespace hasp
