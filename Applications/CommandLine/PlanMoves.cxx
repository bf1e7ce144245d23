#include "PlanMoves.h"

#include "Failure.h"
#include "PlanText.h"
#include "Session.h"
#include "VerbWork.h"

#include "Planning/PlanLists.h"

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace hasp
{
namespace
{

glm::dvec3 Vector(const std::array<double, 3>& v)
{
  return { v[0], v[1], v[2] };
}

PlanPose MotionOf(const PlanMove& move)
{
  const glm::dvec3 turn = Vector(move.turn), about = Vector(move.about);
  PlanPose motion;
  if (const double degrees = glm::length(turn); degrees > 0.0)
    motion.orientation = glm::angleAxis(glm::radians(degrees), turn / degrees);
  motion.position = about - motion.orientation * about + Vector(move.shift);
  return motion;
}

} // namespace

void AddMoveOptions(CLI::App& verb, PlanMove& move)
{
  CLI::Option* object =
    verb.add_option("--move", move.object, "The id of a fragment, or of a group, that is to move")
      ->check(CLI::Range(PlanId(1), MaxPlanId));
  const auto add = [&](const char* name, std::array<double, 3>& to, const char* text) {
    verb.add_option(name, to, text)->delimiter(',')->check(Within(-4000.0, 4000.0))->needs(object);
  };
  add("--shift", move.shift, "With --move: x,y,z in mm, after the turn");
  add("--turn", move.turn, "With --move: x,y,z of the axis, as long as the turn has degrees");
  add("--about", move.about, "With --turn: x,y,z, which the turn leaves where it is");
}

std::string MakeMove(PlanDocument& document, const PlanMove& move)
{
  const PlanPose motion = MotionOf(move);
  if (motion == PlanPose{})
    throw Failure(ExitCode::WrongUse, "--move needs a --shift or a --turn, or nothing moves");
  return Try(ExitCode::BadInput, "",
    [&]
    {
      const Plan& plan = document.history.Current();
      const std::vector<PlanEdit> edits{ FindPlanObject<PlanGroup>(plan, move.object)
                                           ? MovedGroup(plan, move.object, motion)
                                           : MovedFragment(plan, move.object, motion) };
      std::string label = TextOf(plan, edits);
      document.history.Do(edits, label);
      return label;
    });
}

} // namespace hasp
