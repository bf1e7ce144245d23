#pragma once
#include "Planning/Plan.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace hasp
{

/// What of an object a part is made from.
enum class PartFacet
{
  Shape,    ///< all but names, colours and the reduction
  Place,    ///< a fragment's pose and whether it is resected
  CaseLabel ///< the plan's, which is no object: of the id 0
};

/// As in files: "shape".
const char* NameOf(PartFacet facet);

struct PartInput
{
  PlanId id = 0;
  PartFacet facet = PartFacet::Shape;
  std::string hash; ///< SHA-256 of it as it was when the part was made

  bool operator==(const PartInput&) const noexcept = default;
};

enum class PartFormat
{
  Stl,
  ThreeMf,
  Ply,
  Obj,
  Nrrd ///< of a segmentation: its label map
};

/// Something made from a plan, such as a guide's mesh or a segmentation's label map. Kept beside
/// the plan and not in it: undo takes back decisions and not files, and a part that was made before
/// an undo is in date after the redo.
struct DerivedPart
{
  PlanId object = 0; ///< what it is the mesh of: one that IsPartObject, or a segmentation
  PartFormat format = PartFormat::Stl;
  std::vector<PartInput> inputs; ///< PartInputs, or LabelInputs, when it was made
  std::string bytes;             ///< the blob that holds it: its SHA-256
  std::string report; ///< the blob that says what was measured on it, as JSON; empty: none

  bool operator==(const DerivedPart&) const noexcept = default;
};

/// A mesh is made of such an object: a fragment of a scan (there), a group of such (its kept
/// fragments as planned), a guide, a plate, an implant, a transplant (all its segments in the
/// defect; the jaw's fragments are among its inputs, since its joints are measured to them), a
/// mitre guide (on the donor, in its scan).
bool IsPartObject(const Plan& plan, PlanId object);
/// All objects whose meshes are parts, by kind and id: those, but for fragments that are cut into
/// pieces.
std::vector<PlanId> PartObjects(const Plan& plan);

/// What the mesh of `object` depends on, with the hashes of now: itself, and all that its shape
/// comes from, in the order of their ids; and the case label, if it is written on the part. The
/// plan's hash, which is written beside it, is none of them: a part tells which plan it was made
/// of, and stays in date while what it is made from is the same. Needs HASP_ENABLE_JSON and
/// HASP_ENABLE_OPENSSL, as all below. Throws std::invalid_argument if nothing is made from such an
/// object.
std::vector<PartInput> PartInputs(const Plan& plan, PlanId object);

/// The same of a segmentation's label map: itself, but for the names and colours of its labels, and
/// the volume. Without steps it is as before there were recipes. Throws std::invalid_argument if
/// the plan has no such segmentation.
std::vector<PartInput> LabelInputs(const Plan& plan, PlanId segmentation);

/// Why a part must be made anew before it is exported: "guide 8 is out of date: cut 6 has changed".
/// Empty if it is in date.
std::string WhyOutOfDate(const Plan& plan, const DerivedPart& part);

/// The newest of the parts of `object` in that format that is in date; nullptr if none is.
const DerivedPart* PartInDate(const Plan& plan, std::span<const DerivedPart> parts, PlanId object,
  PartFormat format = PartFormat::Stl);
/// Why PartInDate found none: of the newest one, or "guide 8 has not been made". Empty if it did.
std::string WhyNoPart(const Plan& plan, std::span<const DerivedPart> parts, PlanId object,
  PartFormat format = PartFormat::Stl);

/// The blob that holds the label map of a segmentation as it is now: its own `labels` if its recipe
/// has no steps, else the newest of its parts that is in date. Throws std::invalid_argument, which
/// says why there is none.
std::string LabelMapOf(const Plan& plan, std::span<const DerivedPart> parts, PlanId segmentation);

constexpr std::size_t MaxPartsOfObject = 4;
/// Adds a part as the newest. One of the same object, format and inputs goes; of each object in
/// each format MaxPartsOfObject stay, so that what was made before a change need not be made anew
/// when it is undone.
void KeepPart(std::vector<DerivedPart>& parts, DerivedPart part);

/// SHA-256 of all a plan says: equal plans have equal hashes on every machine.
std::string PlanHash(const Plan& plan);

} // namespace hasp
