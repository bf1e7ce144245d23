#include "RandomPlates.h"

#include "Draw.h"

#include <glm/geometric.hpp>

#include <array>
#include <limits>
#include <vector>

namespace hasp
{
namespace
{

std::string Key(const char* list, std::size_t n)
{
  return std::string(list) + "[" + std::to_string(n) + "]";
}

/// Draws a plate that is sound, on the smooth left half of the vault, and what can be wrong with
/// it.
class PlateMaker
{
public:
  PlateMaker(std::uint32_t seed, const PhantomSettings& head) : Head(head), Random(seed)
  {
    PlateRecipe& r = this->Plate.recipe;
    r.spacingMm = this->Random.From(0.6, 0.75);
    r.gapMm = this->Random.From(0.1, 0.5);
    r.thicknessMm = this->Random.From(2.0, 3.5);
    r.widthMm = this->Random.From(7.5, 10.0);
    r.bevelMm = this->Random.Below(3) == 0 ? 0.0 : this->Random.From(r.spacingMm, 1.2);
    this->LayOnVault();
  }

  RandomPlate Make(std::uint32_t kind)
  {
    using Step = void (PlateMaker::*)();
    constexpr std::array<Step, RandomPlateKinds> steps{ &PlateMaker::Plain, &PlateMaker::OnJaw,
      &PlateMaker::OffBone, &PlateMaker::Straight, &PlateMaker::Doubled, &PlateMaker::HoleInAir,
      &PlateMaker::Clash, &PlateMaker::AtTheEdge, &PlateMaker::Nonsense, &PlateMaker::Anywhere,
      &PlateMaker::ThereAndBack };
    (this->*steps[kind])();
    return this->Plate;
  }

private:
  glm::dvec3 Direction(double degreesLeft, double degreesUp) const
  {
    const double left = degreesLeft * 0.017453292519943295, up = degreesUp * 0.017453292519943295;
    return { std::sin(left) * std::cos(up), -std::cos(left) * std::cos(up), std::sin(up) };
  }
  glm::dvec3 OnVault(double degreesLeft, double degreesUp) const
  {
    return PhantomOuterTable(this->Head, this->Direction(degreesLeft, degreesUp));
  }
  glm::dvec3 Outward(const glm::dvec3& p) const { return glm::normalize(p - this->Head.center); }

  /// Landmarks 7 to 11 mm apart, some with a screw; all that a plate needs to be sound.
  void LayOnVault()
  {
    const std::size_t count = 2 + this->Random.Below(4);
    const double step = this->Random.From(6.0, 8.0); // of about 80 mm radius: 8 to 11 mm
    double left = this->Random.From(25.0, 80.0), up = this->Random.From(25.0, 45.0);
    const double turn = this->Random.From(-0.5, 0.5);
    for (std::size_t n = 0; n < count; ++n)
    {
      this->Plate.recipe.landmarks.push_back(this->OnVault(left, up));
      left += step * std::cos(turn) / std::cos(0.017453292519943295 * up);
      up += step * std::sin(turn) + this->Random.From(-0.7, 0.7);
      if (this->Random.Below(4) != 0)
        this->AddScrew(this->Plate.recipe.landmarks.back());
    }
  }
  void AddScrew(const glm::dvec3& point)
  {
    PlateScrew screw{ point };
    screw.diameterMm = this->Random.From(1.5, 2.7);
    this->Plate.recipe.screws.push_back(screw);
  }
  std::size_t AnyLandmark() { return this->Random.Below(this->Plate.recipe.landmarks.size()); }
  /// One screw alone, at a landmark, so that nothing else is told first.
  PlateScrew& OneScrew()
  {
    this->Plate.recipe.screws.clear();
    this->AddScrew(this->Plate.recipe.landmarks[this->AnyLandmark()]);
    return this->Plate.recipe.screws.front();
  }
  void Expect(const char* kind, PlateOutcome outcome, const std::string& words = {})
  {
    this->Plate.kind = kind;
    this->Plate.outcome = outcome;
    this->Plate.words = words;
  }

  void Plain() { this->Expect("plain", PlateOutcome::Sound); }

  /// Through teeth and over the ramus' edge, too.
  void OnJaw()
  {
    PlateRecipe& r = this->Plate.recipe;
    r.landmarks.clear();
    r.screws.clear();
    const AnalyticSolid jaw = PhantomSolid(this->Head, PhantomPart::Mandible);
    const glm::dvec3 middle = this->Head.center + glm::dvec3(0, -30, this->Random.From(-101, -88));
    const std::size_t count = 2 + this->Random.Below(4);
    double degrees = this->Random.From(-75, 30);
    for (std::size_t n = 0; n < count; ++n, degrees += this->Random.From(7, 14))
    {
      const glm::dvec3 out = this->Direction(degrees, 0.0);
      double t = 90.0; // from outside; steps of distances do not overshoot by more than half
      for (int k = 0; k < 400; ++k)
        t -= 0.5 * jaw.Distance(middle + t * out).mm;
      r.landmarks.push_back(middle + t * out);
      this->AddScrew(r.landmarks.back());
    }
    this->Expect("along the jaw", PlateOutcome::Either);
  }

  void OffBone()
  {
    const std::size_t n = this->AnyLandmark();
    glm::dvec3& p = this->Plate.recipe.landmarks[n];
    p += this->Random.From(4.5, 30.0) * this->Outward(p);
    this->Expect("landmark off the bone", PlateOutcome::Refused, Key("landmarks", n));
  }

  void Straight()
  {
    PlateRecipe& r = this->Plate.recipe;
    r.screws.clear();
    const glm::dvec3 a = r.landmarks.front(),
                     b = a + this->Random.From(5, 60) * this->Random.Direction();
    const std::size_t count = 2 + this->Random.Below(4);
    r.landmarks.clear();
    for (std::size_t n = 0; n < count; ++n)
      r.landmarks.push_back(a + (double(n) / double(count)) * (b - a));
    this->Expect("straight through the air or bone", PlateOutcome::Either);
  }

  void Doubled()
  {
    auto& marks = this->Plate.recipe.landmarks;
    const std::size_t n = this->AnyLandmark();
    const bool same = this->Random.Below(2) == 0;
    const glm::dvec3 again =
      same ? marks[n] : marks[n] + this->Random.From(0.01, 2.0) * this->Outward(marks[n]);
    marks.insert(marks.begin() + std::ptrdiff_t(n) + 1, again);
    if (same)
      this->Expect(
        "doubled", PlateOutcome::Refused, Key("landmarks", n + 1) + " is the same point");
    else
      this->Expect("doubled", PlateOutcome::Either);
  }

  void HoleInAir()
  {
    PlateScrew& screw = this->OneScrew();
    screw.point += this->Random.From(4.5, 25.0) * this->Outward(screw.point);
    this->Expect("hole in air", PlateOutcome::Refused, "screws[0] is ");
  }

  void Clash()
  {
    PlateRecipe& r = this->Plate.recipe;
    const auto first = std::size_t(this->Random.Below(r.landmarks.size() - 1));
    const glm::dvec3 a = r.landmarks[first], b = r.landmarks[first + 1];
    r.screws.clear();
    this->AddScrew(a);
    this->AddScrew(a + this->Random.From(0.0, 4.0) * glm::normalize(b - a));
    this->Expect("clashing screws", PlateOutcome::Refused, "screws[0] and screws[1] clash");
  }

  void AtTheEdge()
  {
    PlateRecipe& r = this->Plate.recipe;
    PlateScrew& screw = this->OneScrew();
    const glm::dvec3 along = glm::normalize(r.landmarks.back() - r.landmarks.front());
    const glm::dvec3 across = glm::normalize(glm::cross(this->Outward(screw.point), along));
    // 0.5 to 2 mm too far out; half of the width is still bone that it is laid on.
    const double most = 0.5 * r.widthMm - r.edgeDistanceMm - 0.5 * screw.headDiameterMm;
    const double side = this->Random.Below(2) == 0 ? 1.0 : -1.0;
    screw.point += side * (most + this->Random.From(0.5, 2.0)) * across;
    this->Expect("screw at the edge", PlateOutcome::Refused, "mm from the plate's edge");
  }

  void Nonsense()
  {
    PlateRecipe& r = this->Plate.recipe;
    PlateScrew& screw = this->OneScrew();
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::array<std::pair<double*, const char*>, 8> numbers{ { { &r.widthMm, "widthMm" },
      { &r.thicknessMm, "thicknessMm" }, { &r.gapMm, "gapMm" }, { &r.spacingMm, "spacingMm" },
      { &screw.diameterMm, "screws[0].diameterMm" }, { &screw.lengthMm, "screws[0].lengthMm" },
      { &screw.headDepthMm, "screws[0].headDepthMm" }, { &r.landmarks[0].y, "landmarks[0]" } } };
    const auto& [number, name] = numbers[this->Random.Below(numbers.size())];
    const std::array<double, 3> values{ none, -1e9, 1e12 };
    *number = values[this->Random.Below(values.size())];
    this->Expect("nonsense", PlateOutcome::Refused, name);
  }

  /// Whatever a hand that slips may click: on the head's front, defect, orbits and teeth.
  void Anywhere()
  {
    PlateRecipe& r = this->Plate.recipe;
    const AnalyticSolid bone = PhantomSolid(this->Head);
    const std::size_t count = 2 + this->Random.Below(5);
    r.landmarks.clear();
    r.screws.clear();
    glm::dvec3 at = this->Head.center + glm::dvec3(this->Random.From(-60, 60),
                                          this->Random.From(-95, -40), this->Random.From(-100, 60));
    for (std::size_t n = 0; n < count; ++n)
    {
      r.landmarks.push_back(bone.Distance(at).nearest);
      if (this->Random.Below(2) == 0)
        this->AddScrew(r.landmarks.back() + this->Random.From(0, 3) * this->Random.Direction());
      at = r.landmarks.back() + this->Random.From(2, 14) * this->Random.Direction();
    }
    r.widthMm = this->Random.From(2.0, 14.0);
    r.edgeDistanceMm = r.holeDistanceMm = 0.0;
    r.bridgeMm = this->Random.Below(4) == 0 ? this->Random.From(1.0, 5.0) : 0.0;
    r.bevelMm = 0.0;
    this->Expect("anywhere", PlateOutcome::Either);
  }

  void ThereAndBack()
  {
    PlateRecipe& r = this->Plate.recipe;
    r.screws.clear();
    for (std::size_t n = r.landmarks.size() - 1; n-- > 0;)
      r.landmarks.push_back(
        r.landmarks[n] + this->Random.From(0.0, 3.0) * this->Random.Direction());
    this->Expect("there and back", PlateOutcome::Either);
  }

  PhantomSettings Head;
  Draw Random;
  RandomPlate Plate{ {}, "", PlateOutcome::Either, {} };
};

} // namespace

RandomPlate RandomPlateRecipe(std::uint32_t seed, const PhantomSettings& head)
{
  return PlateMaker(seed, head).Make(seed % RandomPlateKinds);
}

} // namespace hasp
