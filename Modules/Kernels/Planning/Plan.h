#pragma once
#include "Planning/GuideRecipe.h"
#include "Planning/ImplantRecipe.h"
#include "Planning/Osteotomy.h"
#include "Planning/PlanPose.h"
#include "Planning/PlateRecipe.h"
#include "Planning/SegmentationRecipe.h"
#include "Planning/TransplantRecipe.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a surgeon decides, as plain values: no sample, triangle or path of a file. World = patient
/// LPS of the scan, mm; "planned" is the same space after the reduction. Everything else is made of
/// this (DerivedPart.h). Changed by edits alone (PlanEdits.h); kept by PlanFile.h.
namespace hasp
{

/// Names one object of a plan, of whatever kind: 1, 2, … in the order in which they were made, and
/// never used again. 0 names none.
using PlanId = std::uint32_t;
constexpr PlanId MaxPlanId = 1'000'000'000;

/// A scan. By what it holds, not by where it lies: paths name patients.
struct PlanVolume
{
  PlanId id = 0;
  std::string name; ///< the user's
  std::string hash; ///< VolumeHash: 64 hexadecimal digits, lower case

  bool operator==(const PlanVolume&) const noexcept = default;
};

/// A volume's voxels sorted into labels. Without steps the label map is `labels`, from elsewhere.
/// With steps it is made of the volume, of `labels` and of the recipe, and kept beside the plan as
/// what is made from it (LabelMapOf in DerivedPart.h): it goes out of date with each of the three,
/// and is found again when an edit is undone.
struct PlanSegmentation
{
  PlanId id = 0;
  std::string name;
  PlanId volume = 0; ///< whose voxels
  /// The blob that holds the label map that the steps begin with: its SHA-256. Empty: label 0
  /// everywhere.
  std::string labels;
  SegmentationRecipe recipe{};

  bool operator==(const PlanSegmentation&) const noexcept = default;
};

/// Triangles that stand for a body of their own: a sherd, a dental scan, a plate. By what they are,
/// not by where the file lies. They lie in the scan's world, or are a world of their own.
struct PlanSurface
{
  PlanId id = 0;
  std::string name;
  std::string hash; ///< SurfaceHash: 64 hexadecimal digits, lower case

  bool operator==(const PlanSurface&) const noexcept = default;
};

/// A fragment that is a label of a segmentation.
struct LabelSource
{
  PlanId segmentation = 0;
  std::uint32_t label = 1; ///< [1, 65535]
  double isovalue = 226.0; ///< bone is value >= isovalue there, too, [-1e6, 1e6]
  double spacingMm = 0.5;  ///< of its mesh's grid, [0.1, 2]; its pieces' too

  bool operator==(const LabelSource&) const noexcept = default;
};

/// A fragment that is all bone connected with a seed.
struct ComponentSource
{
  PlanId volume = 0;
  double isovalue = 226.0; ///< bone is value >= isovalue, [-1e6, 1e6]
  glm::dvec3 seed{ 0.0 };  ///< in that bone, or within 3 mm of it
  double spacingMm = 0.5;  ///< of its mesh's grid, [0.1, 2]; its pieces' too

  bool operator==(const ComponentSource&) const noexcept = default;
};

/// A fragment that is what the cuts through another leave around a seed. By a point and not by a
/// number: it stays the same piece when the cuts move.
struct PieceSource
{
  PlanId fragment = 0;    ///< older than the piece
  glm::dvec3 seed{ 0.0 }; ///< in the piece, or within 3 mm of it

  bool operator==(const PieceSource&) const noexcept = default;
};

/// Where the material of an open surface is.
enum class SheetSide
{
  Behind, ///< the face that its winding shows is outside
  Both    ///< half of the thickness on either side
};

/// A fragment that is a surface: a closed one with what it encloses, or an open one as a sheet.
struct SurfaceSource
{
  PlanId surface = 0;
  double thicknessMm = 0.0; ///< of an open surface's sheet, (0, 50]; 0: it is closed
  SheetSide side = SheetSide::Behind;
  double spacingMm = 0.5; ///< of the grid that it is measured on, [0.1, 2]

  bool operator==(const SurfaceSource&) const noexcept = default;
};

enum class FragmentState
{
  Kept,
  Resected ///< taken out of the patient
};

/// What a fragment is. One of a scan stays of a scan, one of a surface of a surface.
using FragmentSource = std::variant<LabelSource, ComponentSource, PieceSource, SurfaceSource>;

/// A piece of bone, or of what else is put together.
struct PlanFragment
{
  PlanId id = 0;
  std::string name;
  FragmentSource source;
  std::array<std::uint8_t, 3> colour{ 227, 218, 201 }; ///< red, green, blue
  FragmentState state = FragmentState::Kept;
  PlanPose scanToPlanned; ///< the reduction
  bool locked = false;    ///< the reference, as the cranium: PoseFragments leaves it where it is

  bool operator==(const PlanFragment&) const noexcept = default;
};

/// Fragments that are moved as one. Each keeps a pose of its own, so that nothing jumps when the
/// group is taken apart.
struct PlanGroup
{
  PlanId id = 0;
  std::string name;
  std::vector<PlanId> fragments; ///< each once

  bool operator==(const PlanGroup&) const noexcept = default;
};

/// A saw's cut through fragments, where they lie in the scan.
struct PlanCut
{
  PlanId id = 0;
  std::string name;
  Osteotomy blade;
  std::vector<PlanId> fragments; ///< that it cuts, of scans; all others are left alone
  double reachMm = 8.0;          ///< as BoneCut's: farther bone of theirs stays whole, [0, 500]

  bool operator==(const PlanCut&) const noexcept = default;
};

/// A cutting guide, where its bone lies in the scan. The planes of `cuts` become slots besides
/// those of the recipe, so that a guide follows the cuts it is for. Labels of the recipe of the
/// kind Case say the plan's case label, the side and the plan's hash.
struct PlanGuide
{
  PlanId id = 0;
  std::string name;
  PlanId bone = 0; ///< the volume or the fragment that it sits on
  GuideRecipe recipe;
  std::vector<PlanId> cuts; ///< each once
  BodySide side = BodySide::None;

  bool operator==(const PlanGuide&) const noexcept = default;
};

/// A bone plate, where the plan puts its bone: on a scan as it is, or on fragments where the
/// reduction has them.
struct PlanPlate
{
  PlanId id = 0;
  std::string name;
  PlanId volume = 0;             ///< the scan; 0: on the fragments
  std::vector<PlanId> fragments; ///< of one scan, each once, at most 100; resected ones are no bone
  PlateRecipe recipe;            ///< its own `fragments` are none: PlateRecipeOf fills them in

  bool operator==(const PlanPlate&) const noexcept = default;
};

/// An implant for a hole in the skull of a scan.
struct PlanImplant
{
  PlanId id = 0;
  std::string name;
  PlanId volume = 0;
  ImplantRecipe recipe;

  bool operator==(const PlanImplant&) const noexcept = default;
};

/// The jaw's face that the first or the last joint of a transplant lies in.
struct JawFace
{
  PlanId cut = 0;      ///< whose face, on the side that stays; 0: the joint is where it is
  PlanId fragment = 0; ///< that has the face and takes the joint along; 0: it does not move

  bool operator==(const JawFace&) const noexcept = default;
};

/// Segments of a donor bone in a defect, recut when the cuts at its ends move. The joints, and so
/// the segments, are where the plan puts the jaw.
struct PlanTransplant
{
  PlanId id = 0;
  std::string name;
  PlanId donor = 0; ///< the fragment that segments are taken from
  JawFace first, last;
  Transplant transplant; ///< TransplantOf puts its joints into the faces
  /// As TransplantRecipe's: what is more is warned of, [0, 10].
  double mostGapMm = 0.5, mostOverlapMm = 0.5;

  bool operator==(const PlanTransplant&) const noexcept = default;
};

/// The guide that leads the saw on a transplant's donor, where that lies in its scan. Its slots are
/// the transplant's cuts, so that it follows them.
struct PlanMitreGuide
{
  PlanId id = 0;
  std::string name;
  PlanId transplant = 0;
  MitreGuideChoices choices;

  bool operator==(const PlanMitreGuide&) const noexcept = default;
};

/// A point that goes where its fragment goes.
struct MeasurePoint
{
  PlanId fragment = 0;     ///< 0: does not move
  glm::dvec3 point{ 0.0 }; ///< in the scan

  bool operator==(const MeasurePoint&) const noexcept = default;
};

enum class MeasureKind
{
  Distance, ///< of two points, mm
  Angle     ///< at the second of three points, degrees in [0, 180]
};

struct PlanMeasure
{
  PlanId id = 0;
  std::string name;
  MeasureKind kind = MeasureKind::Distance;
  std::vector<MeasurePoint> points; ///< 2 or 3

  bool operator==(const PlanMeasure&) const noexcept = default;
};

/// What lies mirrored beside the plan, to reduce the other side by: a ghost, which touches nothing
/// and is no part.
struct PlanMirror
{
  PlanId id = 0;
  std::string name;
  PlanId volume = 0;             ///< the scan whose bone is mirrored; 0: the fragments
  std::vector<PlanId> fragments; ///< where they were scanned, each once
  double isovalue = 226.0;       ///< of the volume: bone is value >= isovalue, [-1e6, 1e6]
  /// None: the plane at which that bone is most like its own mirror image, found when it is asked
  /// for.
  std::optional<MirrorPlane> plane;

  bool operator==(const PlanMirror&) const noexcept = default;
};

/// Each list is in the order of its ids, which is the order in which the objects were made.
struct Plan
{
  std::string caseLabel; ///< a pseudonym: it is written on parts and into reports
  PlanId nextId = 1;     ///< all ids below have been given
  std::vector<PlanVolume> volumes;
  std::vector<PlanSegmentation> segmentations;
  std::vector<PlanSurface> surfaces;
  std::vector<PlanFragment> fragments;
  std::vector<PlanGroup> groups;
  std::vector<PlanCut> cuts;
  std::vector<PlanGuide> guides;
  std::vector<PlanPlate> plates;
  std::vector<PlanImplant> implants;
  std::vector<PlanTransplant> transplants;
  std::vector<PlanMitreGuide> mitreGuides;
  std::vector<PlanMeasure> measures;
  std::vector<PlanMirror> mirrors;

  bool operator==(const Plan&) const noexcept = default;
};

/// Throws std::invalid_argument unless ids are given once, ascend in each list and are below
/// nextId, what objects name is there and of the right kind, texts are UTF-8 of at most 200 bytes
/// without control characters, hashes are 64 lower-case hexadecimal digits, a list has at most
/// 10,000 entries, and each number is in its range. Names the key as it stands in the file, never a
/// text of the plan. O(objects log objects).
void ValidatePlan(const Plan& plan);

/// Whether a fragment is of a scan, and so can be cut, guided and plated; false for a surface's,
/// and if there is none.
bool IsOfScan(const Plan& plan, PlanId fragment);
/// The fragment has been cut: there are pieces of it.
bool IsDivided(const Plan& plan, PlanId fragment);
/// The cuts that go through a fragment; those whose planes are a guide's slots. In the plan's order
/// and in the guide's. Of a guide of the plan.
std::vector<PlanId> CutsThrough(const Plan& plan, PlanId fragment);
std::vector<Osteotomy> BladesOf(const Plan& plan, const PlanGuide& guide);

/// The recipe of a plate with its fragments: label n is the n-th that it names, from 1, where the
/// plan puts it; resected ones are left out. Of a plate of the plan.
PlateRecipe PlateRecipeOf(const Plan& plan, const PlanPlate& plate);

/// The transplant with its first and last joint in the faces of their cuts: the plane is the
/// blade's side towards the jaw, the normal the blade's, turned to look as the joint's does, the
/// point the joint's own, upright on the plane; then both go where the fragment goes. Of a
/// transplant of the plan; whether segments can be laid out there is for LayOutSegments to say.
Transplant TransplantOf(const Plan& plan, const PlanTransplant& transplant);

/// Where a point of the scan is after the reduction. Of a valid plan.
glm::dvec3 PlannedPlace(const Plan& plan, const MeasurePoint& point);
/// mm or degrees, of the planned places. 0 for an angle at a point that is one with a neighbour.
double MeasureValue(const Plan& plan, const PlanMeasure& measure);

} // namespace hasp
