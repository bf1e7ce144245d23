#include "Planning/TransplantPath.h"

#include "Planning/PlanLists.h"
#include "Planning/ValueChecks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
const PlanPose Still{};

const PlanPose& PoseOf(const Plan& plan, PlanId fragment)
{
  const PlanFragment* found = FindPlanObject<PlanFragment>(plan, fragment);
  return found ? found->scanToPlanned : Still;
}

/// The blade where the plan puts its stump; without a cut one whose face is square at the path's
/// end.
BoneCut EndCut(
  const Plan& plan, const JawFace& face, const glm::dvec3& inner, const glm::dvec3& end)
{
  BoneCut cut;
  if (const PlanCut* found = FindPlanObject<PlanCut>(plan, face.cut))
  {
    const PlanPose& pose = PoseOf(plan, face.fragment);
    cut.blade = found->blade;
    cut.blade.point = pose.Place(cut.blade.point);
    cut.blade.normal = glm::normalize(pose.orientation * cut.blade.normal);
    cut.blade.along = glm::normalize(pose.orientation * cut.blade.along);
    return cut;
  }
  const glm::dvec3 way = glm::normalize(end - inner);
  const glm::dvec3 aside = std::abs(way.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  cut.blade.normal = way;
  cut.blade.along = glm::normalize(glm::cross(way, aside));
  cut.blade.point = end - 0.5 * cut.blade.kerfMm * way;
  return cut;
}

/// "resection.cuts[0]" as the plan calls it.
std::string NamingCuts(std::string text, const PlanTransplant& transplant)
{
  const auto replace = [&](const std::string& key, const std::string& by)
  {
    if (const auto at = text.find(key); at != std::string::npos)
      text.replace(at, key.size(), by);
  };
  const auto called = [](const JawFace& face, const char* end)
  { return face.cut != 0 ? "cut " + std::to_string(face.cut) : std::string(end); };
  replace("transplant recipe: ", "transplant: ");
  replace("resection.cuts[0]", called(transplant.first, "the first end"));
  replace("resection.cuts[1]", called(transplant.last, "the last end"));
  return text;
}

std::vector<TransplantJoint> JointsAlong(const Plan& plan, const PlanTransplant& transplant,
  std::span<const glm::dvec3> path, double leastSegmentMm)
{
  TransplantRecipe recipe;
  recipe.path.assign(path.begin(), path.end());
  recipe.leastSegmentMm = leastSegmentMm;
  recipe.outward = { { 0, 0, 1 } };                   // joints do not depend on it, …
  recipe.donor.axis = { { 0, 0, 0 }, { 0, 0, 100 } }; // … nor on the donor
  const std::size_t last = path.size() - 1;
  recipe.resection.cuts = { EndCut(plan, transplant.first, path[1], path[0]),
    EndCut(plan, transplant.last, path[last - 1], path[last]) };
  try
  {
    return JointsOf(recipe).joints;
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(NamingCuts(error.what(), transplant));
  }
}

/// Ends are kept where their jaw was scanned.
void PutBack(const PlanPose& pose, TransplantJoint& joint)
{
  joint.point = pose.PlaceBack(joint.point);
  joint.normal = glm::normalize(glm::conjugate(pose.orientation) * joint.normal);
}
} // namespace

std::vector<glm::dvec3> PathOf(const Plan& plan, const PlanTransplant& transplant)
{
  std::vector<glm::dvec3> path;
  for (const TransplantJoint& joint : TransplantOf(plan, transplant).joints)
    path.push_back(joint.point);
  return path;
}

PlanTransplant AlongPath(const Plan& plan, PlanTransplant transplant,
  std::span<const glm::dvec3> path, double leastSegmentMm)
{
  const ValueChecks check("transplant");
  check.Closed("the number of path's places", double(path.size()), 2.0, double(MostPathPlaces));
  for (std::size_t n = 0; n + 1 < path.size(); ++n)
    if (const double apart = glm::distance(path[n], path[n + 1]); !(apart >= 1.0))
      check.Refuse("the distance of " + ListKey("path", n + 1) + " from the place before it", apart,
        "at least 1 mm");
  transplant.transplant.joints = JointsAlong(plan, transplant, path, leastSegmentMm);
  PutBack(PoseOf(plan, transplant.first.fragment), transplant.transplant.joints.front());
  PutBack(PoseOf(plan, transplant.last.fragment), transplant.transplant.joints.back());
  std::vector<glm::dvec3>& outward = transplant.transplant.outward;
  outward.resize(path.size() - 1, outward.empty() ? glm::dvec3(0, 0, 1) : outward.back());
  return transplant;
}

std::vector<glm::dvec3> PathWithOneMore(std::vector<glm::dvec3> path)
{
  if (path.size() < 2 || path.size() >= MostPathPlaces)
    return path;
  std::size_t longest = 0;
  const auto leg = [&](std::size_t n) { return glm::distance(path[n], path[n + 1]); };
  for (std::size_t n = 1; n + 1 < path.size(); ++n)
    if (leg(n) > leg(longest))
      longest = n;
  path.insert(
    path.begin() + std::ptrdiff_t(longest) + 1, 0.5 * (path[longest] + path[longest + 1]));
  return path;
}

std::vector<glm::dvec3> PathWithOneLess(std::vector<glm::dvec3> path)
{
  if (path.size() < 3)
    return path;
  const auto bend = [&](std::size_t n)
  { return AngleOf(path[n] - path[n - 1], path[n + 1] - path[n]); };
  std::size_t least = 1;
  for (std::size_t n = 2; n + 1 < path.size(); ++n)
    if (bend(n) < bend(least))
      least = n;
  path.erase(path.begin() + std::ptrdiff_t(least));
  return path;
}

PlanId StumpOf(const Plan& plan, const PlanCut& cut, const PlanCut& other)
{
  const auto side = [&](const glm::dvec3& place)
  { return glm::dot(place - cut.blade.point, cut.blade.normal); };
  PlanId nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const PlanFragment& fragment : plan.fragments)
  {
    const auto* piece = std::get_if<PieceSource>(&fragment.source);
    if (!piece || fragment.state != FragmentState::Kept ||
        side(piece->seed) * side(other.blade.point) >= 0.0)
      continue;
    if (const double away = glm::distance(piece->seed, cut.blade.point); away < least)
      least = away, nearest = fragment.id;
  }
  return nearest;
}

std::optional<glm::dvec3> AcrossPath(
  std::span<const glm::dvec3> path, std::size_t place, const glm::dvec3& direction)
{
  const glm::dvec3 line =
    path[std::min(place + 1, path.size() - 1)] - path[place == 0 ? 0 : place - 1];
  const glm::dvec3 along = glm::normalize(line), unit = glm::normalize(direction),
                   across = unit - glm::dot(unit, along) * along;
  if (!(glm::length(across) > 0.5))
    return std::nullopt;
  return glm::normalize(across);
}

glm::dvec3 LateralTowards(std::span<const glm::dvec3> axis, const glm::dvec3& place)
{
  const ValueChecks check("transplant");
  if (axis.size() < 2)
    check.Refuse("the number of donor.axis' places", double(axis.size()), "at least 2");
  glm::dvec3 side(0.0);
  double nearest = -1.0;
  for (std::size_t n = 0; n + 1 < axis.size(); ++n)
  {
    const glm::dvec3 piece = axis[n + 1] - axis[n];
    const double length = glm::length(piece);
    if (!(length > 0.0))
      continue;
    const double share = glm::clamp(glm::dot(place - axis[n], piece) / (length * length), 0.0, 1.0);
    const glm::dvec3 from = place - (axis[n] + share * piece);
    if (const double away = glm::length(from); nearest < 0.0 || away < nearest)
    {
      nearest = away;
      side = from - glm::dot(from, piece) / (length * length) * piece;
    }
  }
  if (!(glm::length(side) > 0.1))
    check.Refuse("the lateral side's place", "must not lie on the donor's axis");
  return glm::normalize(side);
}

} // namespace hasp
