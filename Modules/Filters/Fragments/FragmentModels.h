#ifndef FragmentModels_h
#define FragmentModels_h

#include "Grid/GridView.h"                 // for AnyGridView
#include "Grid/Progress.h"                 // for ProgressFunction
#include "Grid/ResourceUse.h"              // for ResourceList
#include "Grid/TriangleMesh.h"             // for TriangleMesh
#include "Haptics/DistanceMap.h"           // for DistanceMap
#include "Haptics/PointShell.h"            // for PointShell
#include "Isosurface/ClusteredCells.h"     // for ClusteredCells
#include "vtkHaspFiltersFragmentsModule.h" // for export macro

#include <cstdint> // for labels
#include <memory>  // for shared_ptr
#include <span>    // for labels
#include <vector>  // for labels

/// From labels to what a scene needs, and no more. Free of VTK but for the export macro;
/// vtkHaspFragmentScan.h makes a FragmentScan of VTK's images.
namespace hasp
{

/// A scan and whose each of its voxels is.
struct FragmentScan
{
  AnyGridView grey;                      ///< at least 2 samples along each axis
  GridView<const std::uint16_t> labels;  ///< on the same grid; 0 is nothing
  std::shared_ptr<const void> greyOwner; ///< of the samples: held as long as they are read
  std::shared_ptr<const void> labelOwner;
  double isovalue = 226.0; ///< bone is value >= isovalue; finite
};

struct FragmentSettings
{
  /// Of the grids on which fragments are measured, the same along the scan's three axes, mm; 0: the
  /// scan's smallest.
  double spacingMm = 0.0;
  /// Of distance maps: how far distances are known on either side of the surface; 0: 16 spacings.
  double rangeMm = 0.0;
  int shellPoints = 16'384;                             ///< of a pointshell, at most
  std::size_t mostSamples = std::size_t{ 200'000'000 }; ///< of a fragment's grid: 25 bytes each
};

/// What is asked for of fragments.
struct FragmentWants
{
  bool map = false;     ///< DistanceMap: it can be touched
  bool shell = false;   ///< PointShell: it can be moved, and felt
  bool surface = false; ///< a closed mesh: it can be cut, measured and printed
  bool cells = false; ///< ClusteredCells: it can be seen; of all bone at once, whatever the labels
};
constexpr FragmentWants AllOfFragment{ true, true, true, false };

/// What there is of a fragment; null where it was not asked for. All lie in the scan's world, mm.
struct FragmentModel
{
  /// Of the body's own axes, those of the world: the middle of its voxels' box. The pose
  /// fragmentToWorld of a fragment that stands where it was scanned is this place, not turned.
  glm::dvec3 origin{ 0.0 };
  std::shared_ptr<const DistanceMap> map;
  std::shared_ptr<const PointShell> shell;
  std::shared_ptr<const TriangleMesh> surface; ///< closed 2-manifold that does not meet itself
};

/// A label of the map.
struct FragmentLabel
{
  std::uint16_t label = 0;
  glm::ivec3 low{ 0 }, high{ 0 }; ///< first and last sample along each axis
  std::size_t voxels = 0;
  glm::dvec3 origin{ 0.0 }; ///< of the fragment's own axes, world: see FragmentModel
};

/// Models that are to be made, as FragmentModels::Begin gives it. It has copies of what it reads of
/// the label map, one byte for each sample of a fragment's box, so that labels may be painted while
/// it runs; what was painted over is then not kept (Outdated).
///
/// Threads: Run on a WORKER, or anywhere, once. It outlives the FragmentModels that it came from.
class VTKHASPFILTERSFRAGMENTS_EXPORT FragmentBaking
{
public:
  ~FragmentBaking();
  FragmentBaking(const FragmentBaking&) = delete;
  FragmentBaking& operator=(const FragmentBaking&) = delete;

  /// Makes them; several fragments side by side, large ones one after the other. Each is handed to
  /// the FragmentModels when all that was asked of it is done, and never in part; after Cancelled
  /// those that were done stay. Same bytes on any number of threads. Progress is told, and cancel
  /// asked for, from this thread: between fragments and within those that it works on, at
  /// worst a small fragment's time apart.
  /// Throws Cancelled; std::runtime_error if some could not be made, when all others are: "label 7:
  /// none of its 12 voxels is >= 226 …", and how many more.
  void Run(const ProgressFunction& progress = {});

  /// Labels that were changed meanwhile, so that their models were dropped; after Run.
  const std::vector<std::uint16_t>& Outdated() const;
  /// Samples of all grids that distances were made on: what it costs. After Run.
  std::size_t Samples() const;

private:
  friend class FragmentModels;
  struct Internals;
  explicit FragmentBaking(std::unique_ptr<Internals> made);
  std::unique_ptr<Internals> Inside;
};

/// A scan's fragments as what draws, touches, moves and measures them. Nothing is there before it
/// is asked for; what is there is shared and immutable, kept until it is released or the label's
/// voxels change, and the same whatever was asked for before.
///
/// Cells are those of the whole bone, once, each with a label: vtkHaspClusteredCellMapper draws all
/// fragments in one go, each in its pose (SetLabelPose). They are the scan's own surface: where two
/// fragments touch, inside of bone, there is none. Cells of bone that has no label have label 0.
/// The other models are closed. A point belongs to the label of the heaviest bone sample of its
/// cell (KeepLabel in Coverage.h): the border to a neighbour, or to bone without a label, is half
/// way between their voxels, and what one has the other has not. Bone that goes on beyond the scan
/// ends at its last samples. Fragments are measured on crops of the scan (KeptGrid.h).
///
/// Errors: std::invalid_argument for a label that is not in the map (says which are), and as the
/// functions say; std::runtime_error where a label has no bone or is too thin for the spacing.
/// Threads: one owns this and the label map, say RENDER: it makes, asks, paints and says
/// LabelsChanged. Finished and ListResources are safe on any thread, at any time. FragmentBaking
/// runs on a WORKER beside all that. The scan's samples stay as they are.
/// Cost: a pass over the labels to begin with, O(samples of the box) after an edit; CPU time a
/// sample of a fragment's grid: a map about 0.2 us, a shell 0.5, a mesh 2 (bin/BenchFragments
/// prints it); a DistanceMap is asked for 16 spacings around, the others for 5. Memory: about 50
/// bytes for each label in each 32^3 samples, and what was asked for. While it is made: 25 bytes a
/// sample of the grid, and for a mesh what SharpContour works with, some 25 times the mesh: 193 MiB
/// for one of 8 MiB of 96^3 samples (bin/BenchFragments 96 1).
class VTKHASPFILTERSFRAGMENTS_EXPORT FragmentModels
{
public:
  /// Throws std::invalid_argument unless the labels are of the scan's grid (LabelGrid.h), it has
  /// two samples along each axis, and the isovalue and settings are in their ranges.
  explicit FragmentModels(const FragmentScan& scan, const FragmentSettings& settings = {});
  ~FragmentModels();
  FragmentModels(const FragmentModels&) = delete;
  FragmentModels& operator=(const FragmentModels&) = delete;

  /// Those that have voxels, ascending.
  std::vector<FragmentLabel> Labels() const;

  ///@{
  /// Made now, unless they are there. Throws as above; Cancelled: nothing is kept.
  std::shared_ptr<const ClusteredCells> Cells(const ProgressFunction& progress = {});
  std::shared_ptr<const DistanceMap> Map(
    std::uint16_t label, const ProgressFunction& progress = {});
  std::shared_ptr<const PointShell> Shell(
    std::uint16_t label, const ProgressFunction& progress = {});
  std::shared_ptr<const TriangleMesh> Surface(
    std::uint16_t label, const ProgressFunction& progress = {});
  ///@}

  ///@{
  /// What is there already. Any thread; never waits for work.
  FragmentModel Finished(std::uint16_t label) const;
  bool HasCells() const; ///< Cells has no more to do than to add labels, if these have changed
  ///@}

  /// What is wanted and not there yet, of several labels, as work for another thread; copies these
  /// labels' boxes, 1 byte a sample. What another FragmentBaking is at work on is made twice; the
  /// first that is done is kept.
  std::unique_ptr<FragmentBaking> Begin(
    std::span<const std::uint16_t> labels, const FragmentWants& wants);
  /// Begin and Run.
  void Prepare(std::span<const std::uint16_t> labels, const FragmentWants& wants,
    const ProgressFunction& progress = {});

  /// Labels of samples low to high, clamped, have been changed in place: drops the models of those
  /// whose voxels are others than before, and returns them, ascending; all others stay as they are.
  /// Cells stay, too; those at the box get their labels anew when they are asked for. O(samples in
  /// the box), and of the cells a copy.
  std::vector<std::uint16_t> LabelsChanged(const glm::ivec3& low, const glm::ivec3& high);

  /// Gives up what this holds; who shares a model keeps it. No such label: nothing.
  void Release(std::uint16_t label, const FragmentWants& what = AllOfFragment);
  void ReleaseCells();

  /// The cells, and for each label three models; those that are not there at 0.
  void ListResources(ResourceList& list) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp

#endif
