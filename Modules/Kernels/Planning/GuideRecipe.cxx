#include "Planning/GuideRecipe.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

namespace hasp
{

namespace
{
const ValueChecks check("guide recipe");
constexpr std::string_view Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 .-/+:";
constexpr std::size_t MostLetters = 40;
constexpr double StrokesInALetter = 6.0; // heights of letters over that of their strokes
constexpr double LeastStrokeMm = 0.6;    // what resin printers make of a wall (PartClaims)

void CheckShown(const std::string& key, double size, double spacing)
{
  if (size < 2.0 * spacing)
  {
    std::ostringstream must;
    must << "at least two grid spacings (spacingMm is " << spacing << ")";
    check.Refuse(key, size, must.str());
  }
}

void CheckCount(const char* list, std::size_t count, std::size_t most)
{
  if (count > most)
    check.Refuse(
      std::string("the number of ") + list, double(count), "at most " + std::to_string(most));
}

bool IsPainted(const GuideRecipe& r)
{
  return std::any_of(
    r.strokes.begin(), r.strokes.end(), [](const GuideStroke& s) { return !s.erased; });
}

void CheckLandmarks(const GuideRecipe& r)
{
  const std::size_t count = r.landmarks.size();
  const bool open = r.outline == GuideOutline::Open;
  if (open && count == 0 && IsPainted(r))
    return;
  if (const std::size_t least = open ? 2 : 3; count < least)
    check.Refuse("the number of landmarks", double(count), "at least " + std::to_string(least));
  CheckCount("landmarks", count, 1000);
  for (std::size_t n = 0; n < count; ++n)
  {
    check.Point(ListKey("landmarks", n), r.landmarks[n]);
    const std::size_t next = (n + 1) % count;
    if (next > 0 || !open)
      if (const double apart = glm::length(r.landmarks[n] - r.landmarks[next]); apart < 0.01)
        check.Refuse(
          "the distance of " + ListKey("landmarks", n) + " and " + ListKey("landmarks", next),
          apart, "at least 0.01 mm");
  }
}

void CheckStrokes(const GuideRecipe& r)
{
  CheckCount("strokes", r.strokes.size(), 1000);
  for (std::size_t n = 0; n < r.strokes.size(); ++n)
  {
    const GuideStroke& stroke = r.strokes[n];
    const std::string points = ListKey("strokes", n, "points");
    if (stroke.points.empty() || stroke.points.size() > 1000)
      check.Refuse("the number of " + points, double(stroke.points.size()), "in [1, 1000]");
    for (std::size_t p = 0; p < stroke.points.size(); ++p)
      check.Point(ListKey(points.c_str(), p), stroke.points[p]);
    check.AboveUpTo(ListKey("strokes", n, "radiusMm"), stroke.radiusMm, 0.0, 100.0);
    CheckShown(ListKey("strokes", n, "radiusMm"), stroke.radiusMm, r.spacingMm);
  }
}

/// What slots and flanges have in common.
template <typename Blade>
void CheckBlade(const GuideRecipe& r, const char* list, std::size_t n, const Blade& blade)
{
  check.Point(ListKey(list, n, "point"), blade.point);
  check.Unit(ListKey(list, n, "normal"), blade.normal);
  if (const double along = std::abs(glm::dot(blade.normal, r.withdrawal)); along > MostSawCosine)
    check.Refuse(ListKey(list, n, "normal") + ": its cosine with withdrawal", along,
      "at most 0.9; the saw must come in along the withdrawal direction");
  check.AboveUpTo(ListKey(list, n, "kerfMm"), blade.kerfMm, 0.0, 20.0);
  check.AboveUpTo(ListKey(list, n, "lengthMm"), blade.lengthMm, 0.0, 500.0);
  check.AboveUpTo(ListKey(list, n, "depthMm"), blade.depthMm, 0.0, 500.0);
  CheckShown(ListKey(list, n, "lengthMm"), blade.lengthMm, r.spacingMm);
}

/// A box or sleeve must come out of the shell, and its wall bear its round edges.
void CheckWall(const GuideRecipe& r, const std::string& heightKey, double height,
  const char* wallKey, double wall)
{
  const double shell = r.gapMm + r.thicknessMm;
  if (!(height > shell && height <= 100.0))
  {
    std::ostringstream must;
    must << "above gapMm + thicknessMm (" << shell << "), or it would not come out of the guide, "
         << "and at most 100";
    check.Refuse(heightKey, height, must.str());
  }
  CheckShown(wallKey, wall, r.spacingMm);
  if (r.edgeRadiusMm > 0.5 * wall)
    check.Refuse("edgeRadiusMm", r.edgeRadiusMm, std::string("at most half of ") + wallKey);
}

void CheckSlots(const GuideRecipe& r)
{
  CheckCount("slots", r.slots.size(), 100);
  for (std::size_t n = 0; n < r.slots.size(); ++n)
  {
    const GuideSlot& slot = r.slots[n];
    CheckBlade(r, "slots", n, slot);
    CheckShown(
      ListKey("slots", n, "kerfMm") + " and clearance", SlotWidthMm(r, slot.kerfMm), r.spacingMm);
    const std::string height = ListKey("slots", n, "guidingHeightMm");
    check.Closed(height, slot.guidingHeightMm, 0.0, 100.0);
    if (slot.guidingHeightMm > 0.0)
      CheckWall(r, height, slot.guidingHeightMm, "wallMm", r.wallMm);
  }
  CheckCount("flanges", r.flanges.size(), 100);
  for (std::size_t n = 0; n < r.flanges.size(); ++n)
  {
    const GuideFlange& flange = r.flanges[n];
    CheckBlade(r, "flanges", n, flange);
    check.AboveUpTo(ListKey("flanges", n, "freeMm"), flange.freeMm, 0.0, 100.0);
    CheckShown(ListKey("flanges", n, "freeMm"), flange.freeMm, r.spacingMm);
    CheckWall(r, ListKey("flanges", n, "heightMm"), flange.heightMm, "wallMm", r.wallMm);
  }
}

void CheckHoles(const GuideRecipe& r)
{
  CheckCount("holes", r.holes.size(), 100);
  for (std::size_t n = 0; n < r.holes.size(); ++n)
  {
    const GuideHole& hole = r.holes[n];
    check.Point(ListKey("holes", n, "point"), hole.point);
    check.Unit(ListKey("holes", n, "axis"), hole.axis);
    check.AboveUpTo(ListKey("holes", n, "diameterMm"), hole.diameterMm, 0.0, 20.0);
    CheckShown(ListKey("holes", n, "diameterMm"), hole.diameterMm, r.spacingMm);
    check.AboveUpTo(ListKey("holes", n, "depthMm"), hole.depthMm, 0.0, 500.0);
    const std::string height = ListKey("holes", n, "sleeveHeightMm");
    check.Closed(height, hole.sleeveHeightMm, 0.0, 100.0);
    if (hole.sleeveHeightMm > 0.0)
      CheckWall(r, height, hole.sleeveHeightMm, "sleeveWallMm", r.sleeveWallMm);
  }
}

void CheckLabels(const GuideRecipe& r)
{
  CheckCount("labels", r.labels.size(), 100);
  for (std::size_t n = 0; n < r.labels.size(); ++n)
  {
    const GuideLabel& label = r.labels[n];
    const std::string text = ListKey("labels", n, "text");
    const bool written = label.kind == GuideLabelKind::Text;
    if (!written && !label.text.empty())
      check.Refuse(
        text, "must be empty: what a label of the kind case says is told when it is made");
    if (label.text.size() > MostLetters)
      check.Refuse("the length of " + text, double(label.text.size()), "at most 40");
    if (label.text.find_first_not_of(Letters) != std::string::npos)
      check.Refuse(text, "must be of A to Z, 0 to 9, space and . - / + :");
    if (written && label.text.find_first_not_of(' ') == std::string::npos)
      check.Refuse(text, "must have a letter");
    check.Point(ListKey("labels", n, "point"), label.point);
    check.Unit(ListKey("labels", n, "right"), label.right);
    check.Closed(ListKey("labels", n, "heightMm"), label.heightMm, 1.0, 50.0);
    const std::string strokes = "a sixth of " + ListKey("labels", n, "heightMm");
    CheckShown(strokes, label.heightMm / StrokesInALetter, r.spacingMm);
    if (label.heightMm / StrokesInALetter < LeastStrokeMm)
      check.Refuse(strokes, label.heightMm / StrokesInALetter,
        "at least 0.6 mm, so that the strokes and what is between them can be printed");
    const std::string depth = ListKey("labels", n, "depthMm");
    check.AboveUpTo(depth, label.depthMm, 0.0, 5.0);
    CheckShown(depth, label.depthMm, r.spacingMm);
    if (label.engraved && label.depthMm > 0.5 * r.thicknessMm)
      check.Refuse(depth, label.depthMm, "at most half of thicknessMm, since it is engraved");
  }
}
} // namespace

void ValidateGuideRecipe(const GuideRecipe& r)
{
  check.Closed("isovalue", r.isovalue, -1e6, 1e6);
  CheckLandmarks(r);
  check.Unit("withdrawal", r.withdrawal);
  check.Closed("axisSearchDeg", r.axisSearchDeg, 0.0, 60.0);
  check.Closed("gapMm", r.gapMm, 0.0, 10.0);
  check.AboveUpTo("thicknessMm", r.thicknessMm, 0.0, 50.0);
  check.AboveUpTo("widthMm", r.widthMm, 0.0, 200.0);
  check.Closed("edgeRadiusMm", r.edgeRadiusMm, 0.0, 5.0);
  check.Closed("clearanceMm", r.clearanceMm, 0.0, 2.0);
  check.AboveUpTo("wallMm", r.wallMm, 0.0, 20.0);
  check.AboveUpTo("sleeveWallMm", r.sleeveWallMm, 0.0, 20.0);
  check.Closed("spacingMm", r.spacingMm, 0.05, 2.0);
  check.Closed("ignoreBelowMm3", r.ignoreBelowMm3, 0.0, 1e6);
  CheckShown("thicknessMm", r.thicknessMm, r.spacingMm);
  CheckShown("widthMm", r.widthMm, r.spacingMm);
  if (r.edgeRadiusMm > 0.5 * r.thicknessMm)
    check.Refuse("edgeRadiusMm", r.edgeRadiusMm, "at most half of thicknessMm");
  CheckStrokes(r);
  CheckSlots(r);
  CheckHoles(r);
  CheckLabels(r);
}

glm::dmat3 SawAxes(const glm::dvec3& normal, const glm::dvec3& withdrawal)
{
  const glm::dvec3 n = glm::normalize(normal), across = glm::normalize(glm::cross(withdrawal, n));
  return { n, across, glm::cross(n, across) };
}

std::string GuideLabelText(const std::string& caseLabel, BodySide side, const std::string& planHash)
{
  std::string tail = side == BodySide::None ? "" : side == BodySide::Left ? " L" : " R";
  if (!planHash.empty())
    tail += " " + planHash.substr(0, 8);
  std::string text = caseLabel.substr(0, MostLetters - tail.size()) + tail;
  if (caseLabel.empty() && !tail.empty())
    text.erase(0, 1);
  for (char& letter : text)
  {
    if (letter >= 'a' && letter <= 'z')
      letter = static_cast<char>(letter - 'a' + 'A');
    if (Letters.find(letter) == std::string_view::npos)
      letter = '-';
  }
  return text;
}

bool HasCaseLabel(const GuideRecipe& recipe)
{
  return std::any_of(recipe.labels.begin(), recipe.labels.end(),
    [](const GuideLabel& label) { return label.kind == GuideLabelKind::Case; });
}

GuideRecipe WithCaseLabels(
  GuideRecipe recipe, const std::string& caseLabel, BodySide side, const std::string& planHash)
{
  const std::string text = GuideLabelText(caseLabel, side, planHash);
  for (std::size_t n = 0; n < recipe.labels.size(); ++n)
    if (GuideLabel& label = recipe.labels[n]; label.kind == GuideLabelKind::Case)
    {
      if (text.find_first_not_of(' ') == std::string::npos)
        check.Refuse(
          ListKey("labels", n), "is to name the case, and no case, side or plan is known");
      label.text = text;
      label.kind = GuideLabelKind::Text;
    }
  return recipe;
}

} // namespace hasp
