#include "Planning/GuideRecipe.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
std::string Key(const char* list, std::size_t n, const char* key)
{
  return std::string(list) + "[" + std::to_string(n) + "]." + key;
}

[[noreturn]] void Refuse(const std::string& key, double value, const std::string& must)
{
  std::ostringstream text;
  text << "guide recipe: " << key << " is " << value << ", must be " << must;
  throw std::invalid_argument(text.str());
}

void CheckRange(const std::string& key, double value, double low, double high, bool lowIncluded)
{
  if ((lowIncluded ? value >= low : value > low) && value <= high)
    return;
  std::ostringstream range;
  range << "in " << (lowIncluded ? '[' : '(') << low << ", " << high << "]";
  Refuse(key, value, range.str());
}

void CheckPoint(const std::string& key, const glm::dvec3& p)
{
  for (int a = 0; a < 3; ++a)
    if (!(std::abs(p[a]) <= 4000.0)) // an STL's float32 still tells 0.0003 mm apart there
      Refuse(key + "[" + std::to_string(a) + "]", p[a], "in [-4000, 4000] mm");
}

void CheckUnit(const std::string& key, const glm::dvec3& v)
{
  if (const double length = glm::length(v); !(std::abs(length - 1.0) <= 1e-3))
    Refuse(key + "'s length", length, "1 within 0.001");
}

void CheckShown(const std::string& key, double size, double spacing)
{
  if (size < 2.0 * spacing)
  {
    std::ostringstream must;
    must << "at least two grid spacings (spacingMm is " << spacing << ")";
    Refuse(key, size, must.str());
  }
}

void CheckLandmarks(const GuideRecipe& r)
{
  const std::size_t least = r.outline == GuideOutline::Open ? 2 : 3, count = r.landmarks.size();
  if (count < least)
    Refuse("the number of landmarks", double(count), "at least " + std::to_string(least));
  if (count > 1000)
    Refuse("the number of landmarks", double(count), "at most 1000");
  for (std::size_t n = 0; n < count; ++n)
  {
    CheckPoint("landmarks[" + std::to_string(n) + "]", r.landmarks[n]);
    const std::size_t next = (n + 1) % count;
    if (next > 0 || r.outline != GuideOutline::Open)
      if (const double apart = glm::length(r.landmarks[n] - r.landmarks[next]); apart < 0.01)
        Refuse("the distance of landmarks[" + std::to_string(n) + "] and landmarks[" +
                 std::to_string(next) + "]",
          apart, "at least 0.01 mm");
  }
}
} // namespace

void ValidateGuideRecipe(const GuideRecipe& r)
{
  CheckRange("isovalue", r.isovalue, -1e6, 1e6, true);
  CheckLandmarks(r);
  CheckUnit("withdrawal", r.withdrawal);
  CheckRange("gapMm", r.gapMm, 0.0, 10.0, true);
  CheckRange("thicknessMm", r.thicknessMm, 0.0, 50.0, false);
  CheckRange("widthMm", r.widthMm, 0.0, 200.0, false);
  CheckRange("spacingMm", r.spacingMm, 0.05, 2.0, true);
  CheckRange("ignoreBelowMm3", r.ignoreBelowMm3, 0.0, 1e6, true);
  CheckShown("thicknessMm", r.thicknessMm, r.spacingMm);
  CheckShown("widthMm", r.widthMm, r.spacingMm);
  for (std::size_t n = 0; n < r.slots.size(); ++n)
  {
    const GuideSlot& slot = r.slots[n];
    CheckPoint(Key("slots", n, "point"), slot.point);
    CheckUnit(Key("slots", n, "normal"), slot.normal);
    if (const double along = std::abs(glm::dot(slot.normal, r.withdrawal)); along > 0.9)
      Refuse(Key("slots", n, "normal") + ": its cosine with withdrawal", along,
        "at most 0.9; the saw must come in along the withdrawal direction");
    CheckRange(Key("slots", n, "widthMm"), slot.widthMm, 0.0, 20.0, false);
    CheckRange(Key("slots", n, "lengthMm"), slot.lengthMm, 0.0, 500.0, false);
    CheckShown(Key("slots", n, "widthMm"), slot.widthMm, r.spacingMm);
  }
  for (std::size_t n = 0; n < r.holes.size(); ++n)
  {
    const GuideHole& hole = r.holes[n];
    CheckPoint(Key("holes", n, "point"), hole.point);
    CheckUnit(Key("holes", n, "axis"), hole.axis);
    CheckRange(Key("holes", n, "diameterMm"), hole.diameterMm, 0.0, 20.0, false);
    CheckShown(Key("holes", n, "diameterMm"), hole.diameterMm, r.spacingMm);
  }
}

} // namespace hasp
