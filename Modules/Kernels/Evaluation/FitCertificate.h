#pragma once
#include "Evaluation/GuideGap.h"
#include "Evaluation/HoleFit.h"
#include "Evaluation/Insertion.h"
#include "Evaluation/MeshCheck.h"
#include "Evaluation/MeshPieces.h"
#include "Evaluation/PartClaims.h"
#include "Evaluation/ShellThickness.h"
#include "Evaluation/SlotFit.h"
#include "Evaluation/WallThickness.h"
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// Why a part must not be used.
enum class FitFaultKind
{
  NotClosed,
  NotManifold,
  Turned, ///< triangles, against their neighbours or all of them
  NoArea,
  MeetsItself,
  NotChecked, ///< for what could not be measured
  Pieces,
  ThinWall,
  Gap,
  TouchesBone,
  Slot,
  Hole,
  Undercut, ///< cannot be put on
  Mirrored,
  Units,
  Space,  ///< of another patient space, such as RAS
  SaidRed ///< its file says itself that it does not hold: for programs that read files
};

/// Stable and lower case, for files: "thin-wall".
const char* FitFaultName(FitFaultKind kind);

struct FitFault
{
  FitFaultKind kind;
  std::string text; ///< what, which object ("slots[0]", as recipes name it), what it must be
  std::optional<glm::dvec3> at; ///< mm
};

/// All that was measured on a part, and why it must not be used.
struct FitCertificate
{
  PartClaims claims; ///< what it was held to
  MeshCheck mesh;
  std::vector<MeshPiece> pieces;
  glm::dvec3 low{ 0.0 }, high{ 0.0 };           ///< its box
  std::size_t slivers = 0;                      ///< triangles lower than SliverMm; no fault
  std::optional<std::size_t> selfIntersections; ///< pairs of triangles; none: not measured
  WallThickness wall;
  std::optional<WallThickness> uncut; ///< of the walls that no slot or hole ends, where claimed
  std::optional<GuideGap> gap;        ///< and shell: where one is claimed
  std::optional<ShellThickness> shell;
  std::vector<SlotFit> slots;         ///< one for each that is claimed, in that order
  std::vector<HoleFit> holes;         ///< likewise
  std::optional<Insertion> insertion; ///< where a withdrawal direction is claimed
  std::vector<FitFault> faults;

  bool Holds() const { return this->faults.empty(); }
};

/// Pairs of triangles that meet; see SelfIntersections.h, which is a library of its own.
using FindSelfIntersectionsFunction =
  std::function<std::vector<std::array<std::uint32_t, 2>>(const TriangleMesh&)>;

/// Measures a part as it was written and holds it to its claims: give the mesh read back from its
/// file, welded (WeldPoints). It shares nothing with what makes parts (Kernels/Distance), and knows
/// nothing of how this one was made.
///
/// Where the limits come from:
///  - closed, 2-manifold, outward, no triangle without area, not meeting itself, `pieces`:
///  absolute.
///    Without `selfIntersections`, or where it throws std::invalid_argument: NotChecked, never
///    green
///  - walls: claims.leastWallMm, what the printer can do, all over (WallThickness);
///  leastUncutMm on
///    those neither of whose sides lies in a claimed slot or hole; a shell's thickness less its
///    tolerance all over (ShellThickness) but where it ends in a claimed cut
///  - gap: its tolerance, on leastGapShare of the inner wall; at least InnerShare of the wall that
///    a shell of this volume (less besideMm3) and thickness has must face bone; nothing of the part
///    in bone
///  - slots: nothing in the way, the narrowest place no narrower than claimed by the tolerance, the
///    fitted width no wider, flat and in place within it; so is its tilt, at the ends of its height
///  - holes: likewise, by the fitted cylinder
///  - withdrawal: no bone is met more than InsertionSettings::toleranceMm deep
/// If gap, slots or holes fail, it is tried whether the part fits in other units, mirrored (about
/// 0, its own box or the volume's, along each axis) or in RAS: then that is the first fault.
///
/// Limits: a part that fits as well mirrored cannot be told from its mirror image. See the headers
/// of what is measured for theirs. Throws std::invalid_argument on bad claims, a bad volume, or a
/// triangle whose points are not there; Cancelled. Any thread; all cores, the same result on any
/// number of them. About a second for 100,000 triangles on two cores.
FitCertificate CertifyFit(const TriangleMesh& mesh, const AnyGridView& bone,
  const PartClaims& claims, const FindSelfIntersectionsFunction& selfIntersections,
  const ProgressFunction& progress = {});

inline constexpr double InnerShare = 0.25;

} // namespace hasp
