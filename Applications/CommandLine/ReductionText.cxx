#include "ReductionText.h"

#include "VerbWork.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <iostream>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;

double DegreesOf(const RigidPose& motion)
{
  return glm::degrees(glm::length(RotationVector(motion.orientation)));
}

Json PoseJson(const RigidPose& pose)
{
  return { { "position", { pose.position.x, pose.position.y, pose.position.z } },
    { "orientation",
      { pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z } } };
}

Json FitJson(const FractureFit& fit)
{
  return { { "faces_mm2", fit.sums.facesMm2 }, { "faces_rms_mm", fit.FaceRmsMm() },
    { "continued_mm2", fit.sums.continuedMm2 }, { "steps_rms_mm", fit.StepRmsMm() },
    { "deepest_mm", fit.sums.deepestMm }, { "within_95_mm", fit.spread.within95Mm },
    { "within_95_degrees", fit.spread.within95Degrees }, { "settled", fit.settled } };
}

/// Faces are planned to 2 mm.
bool IsWide(const AssembledUnit& made)
{
  return !(made.within95Mm <= 2.0);
}

Json ProposalJson(const FitProposal& proposal)
{
  Json json = FitJson(proposal.fit);
  json["share"] = proposal.share;
  json["from_coarse_mm"] = proposal.startMm;
  json["starts"] = proposal.found;
  json["motion"] = PoseJson(proposal.fit.groupInWorld);
  return json;
}
} // namespace

std::string CalledUnit(const ReducedUnit& unit)
{
  return unit.group != 0 ? "group " + std::to_string(unit.group)
                         : "fragment " + std::to_string(unit.fragments[0]);
}

Json DescribeUnit(const ReducedUnit& unit)
{
  const AssembledUnit& made = unit.assembled;
  Json json{ { "fragments", unit.fragments }, { "placed", made.placed } };
  if (unit.group != 0)
    json["group"] = unit.group;
  json["fixed"] = made.placed && made.turn == 0;
  if (made.turn == 0)
    return json;
  json["turn"] = made.turn;
  json["motion"] = PoseJson(made.groupInWorld);
  json["turned_degrees"] = DegreesOf(made.groupInWorld);
  json["fit"] = FitJson(made.fit);
  json["within_95_mm"] = made.within95Mm;
  json["undecided"] = made.proposals.undecided;
  json["wide"] = IsWide(made);
  json["proposals"] = Json::array();
  for (const FitProposal& proposal : made.proposals.proposals)
    json["proposals"].push_back(ProposalJson(proposal));
  return json;
}

void PrintUnit(const ReducedUnit& unit)
{
  const AssembledUnit& made = unit.assembled;
  std::cout << CalledUnit(unit);
  if (made.turn == 0)
  {
    std::cout << (made.placed ? "  stays where it is\n"
                              : "  not placed: no face is in its reach\n");
    return;
  }
  const auto& proposals = made.proposals.proposals;
  std::cout << Line("  moved %.2f mm and turned %.2f degrees: faces %.0f mm2, %.2f mm rms; steps "
                    "%.2f mm rms\n",
    proposals[0].startMm, DegreesOf(made.groupInWorld), made.fit.sums.facesMm2,
    made.fit.FaceRmsMm(), made.fit.StepRmsMm());
  std::cout << Line("    at 95 %% within %.2f mm and %.2f degrees%s%s\n", made.within95Mm,
    made.fit.spread.within95Degrees, made.proposals.undecided ? "; UNDECIDED, see the next" : "",
    IsWide(made) ? "; WIDE, little holds it: look before you use it" : "");
  for (std::size_t n = 0; n < proposals.size(); ++n)
    std::cout << Line("    proposal %zu: share %.2f, %.2f mm from the coarse pose, faces %.0f mm2 "
                      "at %.2f mm, within %.2f mm\n",
      n + 1, proposals[n].share, proposals[n].startMm, proposals[n].fit.sums.facesMm2,
      proposals[n].fit.FaceRmsMm(), proposals[n].fit.spread.within95Mm);
}

} // namespace hasp
