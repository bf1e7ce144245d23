#include "MitreGuide.h"

#include "Grid/Trilinear.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr double StepMm = 0.25;      ///< of rays to the bone
constexpr double OutsideRadii = 1.5; ///< where they begin
constexpr double LandmarkEveryMm = 8.0;
constexpr double SleeveAboveMm = 2.0;  ///< of a pin's sleeve, out of the shell
constexpr double LeastWallSteps = 2.0; ///< as of all that a guide's grid must show

[[noreturn]] void Fail(const std::string& text)
{
  throw std::runtime_error("mitre guide: " + text);
}

/// Where a ray from outside meets bone on its way to a place in it.
std::optional<glm::dvec3> SurfaceTowards(const AnyGridView& donor, double isovalue,
  const glm::dvec3& inside, const glm::dvec3& outward, double farthestMm)
{
  const GridGeometry& ct = GeometryOf(donor);
  const auto isBone = [&](double out)
  {
    const glm::dvec3 index = ct.WorldToIndex(inside + out * outward);
    return std::visit(
      [&](const auto& grey)
      {
        const std::optional<double> value = SampleTrilinear(grey, index);
        return value && *value >= isovalue;
      },
      donor);
  };
  double far = farthestMm;
  while (far > 0.0 && !isBone(far))
    far -= StepMm;
  if (!(far > 0.0))
    return std::nullopt;
  double near = far;
  far += StepMm;
  for (int n = 0; n < 20; ++n)
    (isBone(0.5 * (near + far)) ? near : far) = 0.5 * (near + far);
  return inside + near * outward;
}

/// Everything that the parts of the guide are placed by.
struct Site
{
  const Transplant& plan;
  std::vector<DonorSegment> segments;
  std::vector<Osteotomy> cuts; ///< two a segment
  const AnyGridView& donor;
  double isovalue;
  const MitreGuideChoices& choices;
  glm::dvec3 withdrawal; ///< unit
  double first, last;    ///< of the cuts, along the donor's axis

  glm::dvec3 Surface(const glm::dvec3& inside, const glm::dvec3& outward) const
  {
    const double farthest = OutsideRadii * this->plan.donor.radiusMm;
    const auto found = SurfaceTowards(this->donor, this->isovalue, inside, outward, farthest);
    if (found)
      return *found;
    std::ostringstream text;
    text << "there is no bone on the donor's lateral side of (" << inside.x << ", " << inside.y
         << ", " << inside.z << ") within 1.5 donor.radiusMm; are lateral and axis right?";
    Fail(text.str());
  }
  glm::dvec3 OnBone(double way) const
  {
    return this->Surface(PlaceOnAxis(this->plan.donor, way), this->withdrawal);
  }
};

Site SiteOf(const Transplant& plan, const AnyGridView& donor, double isovalue,
  const MitreGuideChoices& choices)
{
  std::vector<DonorSegment> segments = LayOutSegments(plan);
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const DonorSegment& segment : segments)
    for (const double way : { segment.fromMm, segment.toMm })
    {
      first = std::min(first, way);
      last = std::max(last, way);
    }
  const glm::dvec3 along =
    glm::normalize(PlaceOnAxis(plan.donor, last) - PlaceOnAxis(plan.donor, first));
  const glm::dvec3& lateral = plan.donor.lateral;
  std::vector<Osteotomy> cuts = DonorCuts(plan, segments);
  return { plan, std::move(segments), std::move(cuts), donor, isovalue, choices,
    glm::normalize(lateral - glm::dot(lateral, along) * along), first, last };
}

GuideSlot SlotOf(const Site& site, const Osteotomy& blade)
{
  const glm::dvec3 up = SawAxes(blade.normal, site.withdrawal)[2];
  GuideSlot slot;
  slot.point = site.Surface(blade.point, up);
  slot.normal = blade.normal;
  slot.kerfMm = blade.kerfMm;
  slot.lengthMm = site.choices.slotLengthMm;
  // All of the guide that hangs over the bone's sides, and none of what is behind it.
  slot.depthMm = glm::distance(slot.point, blade.point) + site.plan.donor.radiusMm;
  slot.guidingHeightMm = site.choices.guidingHeightMm;
  return slot;
}

/// The least distance of one slot's middle plane, as far as it goes in the guide, from another's.
double NearestMm(
  const GuideSlot& slot, const GuideSlot& other, const glm::dvec3& withdrawal, double belowMm)
{
  const glm::dmat3 axes = SawAxes(slot.normal, withdrawal);
  const double side = glm::dot(slot.point - other.point, other.normal) < 0.0 ? -1.0 : 1.0;
  double least = std::numeric_limits<double>::infinity();
  for (const double y : { -0.5 * slot.lengthMm, 0.5 * slot.lengthMm })
    for (const double z : { -belowMm, slot.guidingHeightMm })
      least = std::min(
        least, side * glm::dot(slot.point + y * axes[1] + z * axes[2] - other.point, other.normal));
  return least;
}

void CheckSlotsApart(const Site& site, const GuideRecipe& recipe)
{
  std::vector<std::size_t> order(recipe.slots.size());
  for (std::size_t n = 0; n < order.size(); ++n)
    order[n] = n;
  const glm::dvec3 along =
    PlaceOnAxis(site.plan.donor, site.last) - PlaceOnAxis(site.plan.donor, site.first);
  const auto wayOf = [&](std::size_t n) { return glm::dot(site.cuts[n].point, along); };
  std::sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return wayOf(a) < wayOf(b); });
  const double least = LeastWallSteps * recipe.spacingMm;
  for (std::size_t n = 0; n + 1 < order.size(); ++n)
  {
    const GuideSlot &a = recipe.slots[order[n]], &b = recipe.slots[order[n + 1]];
    const double below = site.plan.donor.radiusMm;
    const double apart = std::min(NearestMm(a, b, recipe.withdrawal, below),
                           NearestMm(b, a, recipe.withdrawal, below)) -
                         0.5 * (SlotWidthMm(recipe, a.kerfMm) + SlotWidthMm(recipe, b.kerfMm));
    if (apart >= least)
      continue;
    const double square = std::max(std::abs(glm::dot(glm::normalize(along), a.normal)), 0.1);
    std::ostringstream text;
    text << "slots[" << order[n] << "] and slots[" << order[n + 1] << "] leave a wall of " << apart
         << " mm between them, must be " << least << " mm: ";
    if (n % 2 == 1) // of two segments
      text << "raise donor.betweenMm by " << std::ceil(10.0 * (least - apart) / square) / 10.0
           << " mm, or make guide.slotLengthMm or guide.guidingHeightMm less";
    else
      text << "make the segment longer, or guide.slotLengthMm or guide.guidingHeightMm less";
    Fail(text.str());
  }
}

/// Whether a pin's drill would come into the box of a slot.
bool MeetsBox(const GuideRecipe& recipe, const GuideHole& pin)
{
  for (const GuideSlot& slot : recipe.slots)
  {
    const double clear =
      0.5 * SlotWidthMm(recipe, slot.kerfMm) + recipe.wallMm + 0.5 * pin.diameterMm;
    const glm::dvec3 top = pin.point + slot.guidingHeightMm * pin.axis;
    const double a = glm::dot(pin.point - slot.point, slot.normal),
                 b = glm::dot(top - slot.point, slot.normal);
    if (a * b <= 0.0 || std::min(std::abs(a), std::abs(b)) < clear)
      return true;
  }
  return false;
}

void AddPins(const Site& site, MitreGuide& guide)
{
  const MitreGuideChoices& choices = site.choices;
  if (choices.pinDiameterMm == 0.0)
    return;
  const auto add = [&](double way, const std::string& where)
  {
    GuideHole pin;
    pin.point = site.OnBone(way);
    pin.axis = site.withdrawal;
    pin.diameterMm = choices.pinDiameterMm;
    pin.depthMm = 2.0 * site.plan.donor.radiusMm;
    pin.sleeveHeightMm = choices.gapMm + choices.thicknessMm + SleeveAboveMm;
    if (MeetsBox(guide.recipe, pin))
      guide.warnings.push_back("mitre guide: no pin " + where + ": the slots leave no room for it");
    else
      guide.recipe.holes.push_back(pin);
  };
  add(site.first - choices.beyondMm, "before the first cut");
  for (std::size_t n = 0; n < site.segments.size(); ++n)
  {
    const DonorSegment& cut = site.segments[n];
    add(0.5 * (cut.fromMm + cut.toMm), "in segments[" + std::to_string(n) + "]");
  }
  add(site.last + choices.beyondMm, "after the last cut");
}
} // namespace

MitreGuide MakeMitreGuideRecipe(const Transplant& plan, const AnyGridView& donor, double isovalue,
  const MitreGuideChoices& choices)
{
  const Site site = SiteOf(plan, donor, isovalue, choices);
  MitreGuide guide;
  GuideRecipe& recipe = guide.recipe;
  recipe.isovalue = isovalue;
  recipe.withdrawal = site.withdrawal;
  recipe.gapMm = choices.gapMm;
  recipe.thicknessMm = choices.thicknessMm;
  recipe.widthMm = choices.widthMm;
  recipe.clearanceMm = choices.clearanceMm;
  recipe.wallMm = choices.wallMm;
  recipe.spacingMm = choices.spacingMm;
  const double from = site.first - choices.beyondMm, to = site.last + choices.beyondMm;
  const int pieces = std::max(1, int(std::ceil((to - from) / LandmarkEveryMm)));
  for (int n = 0; n <= pieces; ++n)
    recipe.landmarks.push_back(site.OnBone(from + (to - from) * n / pieces));
  for (const Osteotomy& blade : site.cuts)
    recipe.slots.push_back(SlotOf(site, blade));
  CheckSlotsApart(site, recipe);
  AddPins(site, guide);
  try
  {
    ValidateGuideRecipe(recipe);
  }
  catch (const std::invalid_argument& fault)
  {
    Fail(fault.what());
  }
  return guide;
}

} // namespace hasp
