#pragma once
#include "Segmentation/LabelMap.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

/// What a user is taken to know of a fracture, and no more. World = patient LPS, mm.
namespace hasp
{

/// "There, about, is that fragment": all that a stroke is made from, besides the bone itself.
struct CoarseHint
{
  Label label = 2;
  glm::dvec3 near{ 0.0 };  ///< about a place of the fragment; off by up to errorMm
  glm::dvec3 along{ 0.0 }; ///< unit: which way the fragment is long there
  double reachMm = 0.0;    ///< so far around, about, nothing else is: no user draws across a crack
  /// Where a line may go, about: middles of cells of that fragment alone, each next to the one
  /// before, off as `near` is; `near` is beside one of them. Empty: no further than reachMm.
  std::vector<glm::dvec3> way{};
};

struct CoarseTruthSettings
{
  double cellMm = 5.0;     ///< what a user tells apart: a truth of cubes of this side, [1, 20]
  double errorMm = 2.0;    ///< how far a place is off at most, and half of reachMm at most; [0, 20]
  double wrongShare = 0.2; ///< of a cell's bone that must be wrong for a user to see it, (0, 1]
  std::uint64_t seed = 1;  ///< of errors
};

/// The truth in cubes of some millimetres: each knows its one label where it holds bone of that
/// alone, else nothing. Voxels are not kept, so nothing finer can be asked of it, and no stroke can
/// be made from what a user does not know. Immutable; any thread.
class CoarseTruth
{
public:
  /// truth   0: nothing
  /// Throws std::invalid_argument with the field, its value and the legal range. O(voxels).
  explicit CoarseTruth(GridView<const Label> truth, const CoarseTruthSettings& settings = {});

  /// One for each label, by number: of its cells that are farthest from other labels' (four fifths
  /// of that, and 40 mm, are as good) in the one around which most of its bone is. A label without
  /// a cell of its own, smaller than about two cells, is hinted at by its middle voxels' mean with
  /// reachMm of a quarter of a cell.
  std::vector<CoarseHint> Hints() const;

  /// Where a user who looks at the result sees the largest region of a wrong label: cells of one
  /// label that touch, of whose bone in the result more than wrongShare has another label (bone
  /// that has label 1 or none, too). The place is the middle of what is wrong in the region's cell
  /// farthest from other labels' (of equal ones the worst), which the user sees in the result, off
  /// as hints are; the way goes where the region is long. Nothing if no cell is wrong.
  ///
  /// result, bone   on the truth's grid; bone is not 0 where there is bone to be labelled
  /// round          of correction: draws another error
  std::optional<CoarseHint> LargestError(
    GridView<const Label> result, GridView<const Label> bone, int round) const;

  const std::vector<Label>& Labels() const { return this->All; }

private:
  struct Mark
  {
    Label label;
    glm::dvec3 sum;
    std::size_t count;
  };
  glm::ivec3 CellOf(const glm::ivec3& voxel) const;
  std::size_t Number(const glm::ivec3& cell) const;
  glm::ivec3 Place(std::size_t number) const;
  glm::dvec3 Middle(std::size_t number) const;
  double NearestOtherMm(std::size_t number) const;
  glm::dvec3 LongWay(
    std::size_t number, double withinMm, const std::vector<std::size_t>& cells) const;
  /// Cells of the number's label that follow each other about along a direction, so far from others
  /// at least; without the first.
  std::vector<std::size_t> Follow(
    std::size_t number, const glm::dvec3& along, double leastMm) const;
  CoarseHint HintAt(
    std::size_t number, const glm::dvec3& place, const glm::dvec3& along, std::uint64_t draw) const;
  std::size_t SolidCell(const Mark& mark) const;

  static constexpr Label Mixed = MaxLabel;

  CoarseTruthSettings Settings;
  GridGeometry Grid;
  glm::ivec3 VoxelsPerCell, Cells;
  std::vector<Label> Known;        ///< of each cell: 0 no bone, Mixed several labels
  std::vector<std::uint32_t> Bone; ///< of each cell: voxels
  std::vector<Label> All;
  std::vector<Mark> Marks; ///< the middle of each label's cells; of its voxels where it has none
};

} // namespace hasp
