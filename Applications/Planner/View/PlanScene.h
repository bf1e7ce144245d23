#pragma once
#include "Grid/ResourceUse.h"
#include "Planning/Plan.h"

#include <QObject>
#include <QString>

#include <glm/vec3.hpp>

#include <memory>
#include <optional>
#include <string>

class vtkBoundingBox;
class vtkImageData;
class vtkPolyData;
class vtkProp3D;

namespace hasp
{

class JobQueue;
class PlanSession;
class ScanLooks;
class ScanShelf;
class SceneView;

/// What is seen of a plan: its objects as props in the 3D view, each in its place after the
/// reduction. Follows the plan (PlanSession::Changed): what is new is made, what has moved is
/// moved, what is gone is released; what takes long (a fragment's voxels, a ghost) is made on the
/// WORKER and is there when it is done. Nothing is made of what is not shown.
///
///   the scan                while it has no fragments: its isosurface, by RayCaching while the
///                           isovalue moves, by active cells when it rests
///   a fragment              the exact isosurface of its own voxels (FragmentImage); resected ones
///                           red and translucent; of a surface, its triangles (PutSurface)
///   a cut                   its blade, translucent, kerf and all; not picked
///   guides, plates, …       the mesh that was made; out of date ones grey and translucent
///   a mirrored ghost        translucent
///   a measure               line or angle with its value; not picked
///   skin, brightest values  of the scan, once they are switched on (Looks); not picked
///
/// It takes the view's `before` and `after`. Threads: RENDER.
class PlanScene : public QObject
{
  Q_OBJECT
public:
  PlanScene(PlanSession& plan, ScanShelf& scans, JobQueue& jobs, SceneView& view);
  ~PlanScene() override;

  ///@{
  /// Of the scan that is shown, and of components that are not said otherwise; each volume has its
  /// own (ScanSurface). `moving`: a slider is held.
  void SetIsovalue(double value, bool moving = false);
  double Isovalue() const;
  ///@}
  ///@{
  /// The volume whose isosurface and slices are shown; 0: none. Default: the plan's first.
  void SetShownVolume(PlanId volume);
  PlanId ShownVolume() const;
  vtkImageData* ShownImage() const; ///< nullptr: not in memory
  ///@}
  ///@{
  /// As the user has it. All is visible until it is hidden; but a volume's isosurface is while it
  /// is the shown one and none of its fragments is there, and showing it makes it the shown one.
  bool IsVisible(PlanId object) const;
  void SetVisible(PlanId object, bool visible);
  PlanId Selected() const;
  void Select(PlanId object); ///< 0: none
  ///@}

  /// How the scan is shown besides its bone.
  ScanLooks& Looks() const;

  /// nullptr: it is not shown, not there yet, or has none.
  vtkProp3D* PropOf(PlanId object) const;
  /// The isosurface of the scan itself: for painting. Its mapper is a vtkHaspClusteredCellMapper
  /// while the isovalue rests. nullptr: it is not shown.
  vtkProp3D* ScanProp() const;
  /// Triangles of a PlanSurface's hash, which no plan holds; nullptr releases them.
  void PutSurface(const std::string& hash, vtkPolyData* mesh);
  /// The voxels of a fragment alone, on a crop of its scan's grid; nullptr: not there yet.
  vtkImageData* ImageOfFragment(PlanId fragment) const;

  /// What lies under a pixel of the view (from its lower left).
  struct Place
  {
    PlanId object = 0; ///< 0: the scan itself
    glm::dvec3 world;  ///< where it is seen, mm
    glm::dvec3 inScan; ///< the same before the reduction
    glm::dvec3 normal; ///< unit, towards the viewer's side, world
  };
  /// Exact: the first surface along the line of sight. Parts and ghosts are picked, too.
  std::optional<Place> PlaceAt(int x, int y) const;

  /// A view from a side: 'A', 'P', 'L', 'R', 'S' or 'I', on what is shown.
  void LookFrom(char side);
  void ShowAll();                ///< as it looks, but all of it
  vtkBoundingBox Bounds() const; ///< around all that is shown, world mm; not valid: nothing is

  void ListResources(ResourceList& list) const;

public Q_SLOTS:
  void Sync();

Q_SIGNALS:
  void PropsChanged(); ///< others than before: tools ask anew
  void SelectedChanged(hasp::PlanId object);
  void IsovalueChanged(double value);
  /// Something of the plan cannot be shown: which, why, and what to do; told once.
  void Refused(const QString& text);

private:
  void Forget();
  void Show();

  struct Internals;
  std::unique_ptr<Internals> Self;
};

} // namespace hasp
