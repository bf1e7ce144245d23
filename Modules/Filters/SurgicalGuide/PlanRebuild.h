#ifndef PlanRebuild_h
#define PlanRebuild_h

#include "Evaluation/PartClaims.h"             // for PartClaims
#include "FragmentCutter.h"                    // for CutMeasure
#include "Grid/GridView.h"                     // for AnyGridView
#include "Grid/Progress.h"                     // for ProgressFunction
#include "Grid/TriangleMesh.h"                 // for TriangleMesh
#include "Planning/DerivedPart.h"              // for PartInput
#include "Planning/Plan.h"                     // for Plan
#include "TransplantBuilder.h"                 // for MadeJoint
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <map>      // for images
#include <memory>   // for internals
#include <optional> // for checks
#include <string>   // for warnings
#include <variant>  // for recipes
#include <vector>   // for segments

/// Everything that a plan is for, made of it and its scans; free of VTK but for the export macro.
namespace hasp
{

/// Samples by the ids of the volumes, and of the segmentations, that they are.
using PlanImages = std::map<PlanId, AnyGridView>;

struct PlanCutMeasure
{
  PlanId cut = 0;
  CutMeasure measure; ///< but for `front` and `back`: their numbers are none of the plan's
};

/// One of a transplant's segments as it lies in the defect.
struct PlanSegment
{
  DonorSegment cut;
  double volumeMm3 = 0.0;
  std::size_t triangles = 0; ///< so many of the part's, behind those of the segments before it
};

/// What a part must hold, and the bone that it lies on as it was made: for CertifyFit
/// (Evaluation/FitCertificate.h).
struct PartCheck
{
  PartClaims claims;
  AnyGridView bone; ///< good until the next Make
  /// What the part was made by, its cuts' slots and labels in it and nothing left to search: with
  /// it and the scan anybody can hold the part's file to the same claims. None of a plate on
  /// fragments: bone that was moved is in no scan.
  std::variant<std::monostate, GuideRecipe, PlateRecipe, ImplantRecipe> recipe{};
  PlanId alone = 0; ///< the fragment that `bone` is without the scan's other bone; 0: it has all
};

struct RebuiltPart
{
  PlanId object = 0;
  TriangleMesh mesh; ///< world mm; of a fragment, guide, implant or mitre guide in its scan, else
                     ///< as planned
  std::vector<PartInput> inputs; ///< PartInputs of the plan
  double volumeMm3 = 0.0;
  std::vector<PlanCutMeasure> cuts;  ///< of a fragment that is a piece: all through what it is of
  std::vector<PlanSegment> segments; ///< of a transplant, in the order of its joints
  /// Of a transplant, one more. At the first and last the jaw is the fragment that the plan names
  /// there; where it names none, no bone is.
  std::vector<MadeJoint> joints;
  std::optional<PartCheck> check;    ///< of guides, plates, implants and mitre guides
  std::vector<std::string> warnings; ///< what a surgeon must know, in words and our own keys
};

/// Makes parts of a plan. What several need, such as the pieces of a bone, is made once.
///
///  - a fragment: all bone connected with its seed, or the label's; a piece: what CutFragments
///  leaves
///    around its seed, of all cuts through the fragment that it is of, and through those that this
///    one is a piece of
///  - a group: its kept fragments where the reduction has them, as one body (UniteFragments)
///  - a guide: BuildGuide on the scan, or on one fragment of it, with a slot for each of its cuts
///    and, on labels of the kind Case, the case label, its side and the PlanHash of this plan
///  - a plate: BuildPlate on the scan, or on fragments where the reduction has them
///  - an implant: BuildImplant on the scan
///  - a transplant: TransplantSegments out of its donor, at TransplantOf
///  - a mitre guide: BuildGuide by MakeMitreGuideRecipe on the donor of TransplantOf
///
/// One thread at a time (RENDER, or a WORKER that owns it); uses all cores, the same meshes with
/// any number of them. Memory: the meshes of all fragments asked for, and one to three bytes a
/// sample of their scans. Limit: a plate's fragments are of one scan, so that it does not lie on a
/// transplant's segments.
class VTKHASPFILTERSSURGICALGUIDE_EXPORT PlanRebuild
{
public:
  /// Of a valid plan. The views must outlive this. What an object needs must be among the images
  /// when Make is called, and no sooner.
  PlanRebuild(Plan plan, PlanImages images);
  ~PlanRebuild();

  /// Throws std::invalid_argument (nothing is made of such an object; a recipe, a missing volume or
  /// segmentation) and std::runtime_error (no such part can be made); Cancelled. Messages begin
  /// with the object: "guide 8: holes[0] …", and name cuts by their ids; no text of the plan.
  RebuiltPart Make(PlanId object, const ProgressFunction& progress = {});

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

/// The images that Make(object) needs: ids of volumes and of segmentations.
VTKHASPFILTERSSURGICALGUIDE_EXPORT std::vector<PlanId> ImagesOf(const Plan& plan, PlanId object);

} // namespace hasp

#endif
