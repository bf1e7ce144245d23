#include "RandomGuides.h"

#include "Draw.h"
#include "Grid/Phantom.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <limits>

namespace hasp
{
namespace
{

class GuideMaker
{
public:
  explicit GuideMaker(std::uint32_t seed) : Random(seed)
  {
    // Above the ears, in front or behind: where the vault is.
    const double turn = this->Random.From(0.0, 6.283185307179586);
    this->Off =
      glm::normalize(glm::dvec3(std::cos(turn), std::sin(turn), this->Random.From(0.35, 1.6)));
    this->Right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), this->Off));
    this->Up = glm::cross(this->Off, this->Right);
    this->Guide.kind = "plain";
    this->Numbers();
    GuideRecipe& r = this->Guide.recipe;
    const std::size_t landmarks = 2 + this->Random.Below(3);
    for (std::size_t n = 0; n < landmarks; ++n)
      r.landmarks.push_back(this->OnBone(
        7.0 * (double(n) - 0.5 * double(landmarks - 1)), this->Random.From(-3.0, 3.0)));
    this->Cuts();
    this->Scan();
  }

  RandomGuide Make(std::uint32_t kind)
  {
    using Step = void (GuideMaker::*)();
    constexpr std::array<Step, RandomGuideKinds> steps{ &GuideMaker::Plain, &GuideMaker::OffBone,
      &GuideMaker::Collinear, &GuideMaker::Doubled, &GuideMaker::HoleInAir, &GuideMaker::Crossing,
      &GuideMaker::Painted, &GuideMaker::AllAtOnce, &GuideMaker::Nonsense };
    (this->*steps[kind])();
    return this->Guide;
  }

private:
  glm::dvec3 OnBone(double right, double up) const
  {
    const PhantomSettings head;
    const glm::dvec3 middle = PhantomOuterTable(head, this->Off);
    return PhantomOuterTable(head, middle + right * this->Right + up * this->Up - head.center);
  }
  glm::dvec3 Tilted(double most)
  {
    return glm::normalize(this->Off + this->Random.From(-most, most) * this->Right +
                          this->Random.From(-most, most) * this->Up);
  }

  void Numbers()
  {
    GuideRecipe& r = this->Guide.recipe;
    r.spacingMm = this->Random.From(0.5, 0.7);
    r.gapMm = this->Random.From(0.15, 0.5);
    r.thicknessMm = this->Random.From(2.5, 4.5);
    r.widthMm = this->Random.From(9.0, 16.0);
    r.edgeRadiusMm = this->Random.Below(3) == 0 ? 0.0 : this->Random.From(0.2, 1.0);
    r.clearanceMm = this->Random.Below(2) == 0 ? SlaClearanceMm : FdmClearanceMm;
    r.withdrawal = this->Tilted(0.3);
    if (this->Random.Below(10) == 0)
      r.axisSearchDeg = this->Random.From(5.0, 25.0);
  }
  void Cuts()
  {
    GuideRecipe& r = this->Guide.recipe;
    const double above = r.gapMm + r.thicknessMm; // what stands on the guide comes out of it
    const double turn = this->Random.From(0.0, 3.14159265358979);
    const glm::dvec3 normal =
      glm::normalize(std::cos(turn) * this->Right + std::sin(turn) * this->Up +
                     this->Random.From(-0.15, 0.15) * this->Off);
    if (this->Random.Below(4) > 0)
      r.slots.push_back({ this->OnBone(this->Random.From(-4, 4), this->Random.From(-2, 2)), normal,
        this->Random.From(0.9, 1.6), this->Random.From(4.0, 12.0), this->Random.From(2.0, 20.0),
        this->Random.Below(2) == 0 ? 0.0 : above + this->Random.From(2.0, 8.0) });
    for (std::size_t n = this->Random.Below(3); n > 0; --n)
      r.holes.push_back({ this->OnBone(this->Random.From(-9, 9), this->Random.From(-5, 5)),
        this->Tilted(0.25), this->Random.From(1.5, 3.2), this->Random.From(3.0, 20.0),
        this->Random.Below(2) == 0 ? 0.0 : above + this->Random.From(0.5, 4.0) });
    if (this->Random.Below(6) == 0)
      r.flanges.push_back(
        { this->OnBone(this->Random.From(-8, 8), 0.0), this->Right, this->Random.From(0.9, 1.6),
          this->Random.From(6.0, 14.0), above + this->Random.From(2.0, 8.0),
          this->Random.From(2.0, 20.0), this->Random.From(3.0, 10.0) });
    if (this->Random.Below(6) == 0)
      r.labels.push_back({ "R-" + std::to_string(this->Random.Below(90)),
        this->OnBone(0.0, this->Random.From(-2, 2)), this->Right, 12.2 * r.spacingMm,
        2.1 * r.spacingMm, r.thicknessMm > 4.3 * r.spacingMm && this->Random.Below(2) == 0 });
  }
  /// Of the phantom, where the guide is and where it would be if it were pushed off.
  void Scan()
  {
    GridGeometry& scan = this->Guide.scan;
    scan.spacing = { this->Random.From(0.5, 0.9), 0.0, this->Random.From(0.6, 1.2) };
    scan.spacing.y = scan.spacing.x;
    scan.direction = glm::dmat3(
      glm::rotate(glm::dmat4(1.0), this->Random.From(0.0, 0.5), this->Random.Direction()));
    scan.dims = glm::ivec3(glm::ceil(52.0 / scan.spacing)) + 1;
    scan.origin = this->OnBone(0, 0) - 8.0 * this->Off -
                  scan.direction * (0.5 * scan.spacing * glm::dvec3(scan.dims - 1));
  }

  void Plain() {}
  void OffBone()
  {
    this->Guide.kind = "landmark off the bone";
    const double mm = this->Random.From(0.5, 9.0);
    this->Guide.recipe.landmarks[0] += mm * this->Off;
    if (mm > 3.5)
      this->Refuse("landmarks[0]");
  }
  void Collinear()
  {
    this->Guide.kind = "collinear";
    std::vector<glm::dvec3>& points = this->Guide.recipe.landmarks;
    points = { this->OnBone(-8, 0), {}, this->OnBone(8, 0) };
    points[1] = 0.5 * (points[0] + points[2]); // a chord: below the bone
    if (this->Random.Below(2) == 0)
      this->Guide.recipe.outline = GuideOutline::Closed;
  }
  void Doubled()
  {
    this->Guide.kind = "doubled";
    GuideRecipe& r = this->Guide.recipe;
    if (this->Random.Below(2) == 0)
    {
      r.landmarks.push_back(r.landmarks.front()); // there and back
      return;
    }
    r.landmarks.push_back(r.landmarks.back());
    this->Refuse("landmarks");
  }
  void HoleInAir()
  {
    this->Guide.kind = "hole in air";
    GuideRecipe& r = this->Guide.recipe;
    r.holes = { { this->OnBone(0, 0) + this->Random.From(19.0, 60.0) * this->Up, r.withdrawal, 2.0,
      5.0, 0.0 } };
    this->Refuse("["); // this one, unless a landmark is over a fossa or the defect
  }
  void Crossing()
  {
    this->Guide.kind = "crossing slots";
    const glm::dvec3 at = this->OnBone(0, 0);
    const double turn = this->Random.From(0.2, 1.5);
    this->Guide.recipe.slots = { { at, this->Right, 1.2, this->Random.From(4, 14), 5.0, 0.0 },
      { at, std::cos(turn) * this->Right + std::sin(turn) * this->Up, 1.2, this->Random.From(4, 14),
        5.0, this->Random.Below(2) == 0 ? 0.0 : 10.0 } };
  }
  void Painted()
  {
    this->Guide.kind = "painted";
    GuideRecipe& r = this->Guide.recipe;
    if (this->Random.Below(2) == 0)
      r.landmarks.clear();
    r.strokes = { { { this->OnBone(-6, -3), this->OnBone(0, 4), this->OnBone(7, -2) },
                    this->Random.From(3.0, 6.0), false },
      { { this->OnBone(this->Random.From(-6, 6), this->Random.From(-3, 3)) },
        this->Random.From(1.5, 3.0), true } };
  }
  void AllAtOnce()
  {
    this->Collinear();
    this->Crossing();
    this->Guide.kind = "all at once";
    this->Guide.recipe.landmarks[2] += this->Random.From(0.0, 2.5) * this->Off;
    this->Guide.recipe.outline = GuideOutline::Filled;
  }
  void Nonsense()
  {
    this->Guide.kind = "nonsense";
    GuideRecipe& r = this->Guide.recipe;
    switch (this->Random.Below(8))
    {
      case 0:
        r.gapMm = std::numeric_limits<double>::quiet_NaN();
        return this->Refuse("gapMm");
      case 1:
        r.thicknessMm = -this->Random.From(0.0, 5.0);
        return this->Refuse("thicknessMm");
      case 2:
        r.withdrawal = {};
        return this->Refuse("withdrawal");
      case 3:
        r.landmarks[1].x = std::numeric_limits<double>::infinity();
        return this->Refuse("landmarks[1]");
      case 4:
        r.landmarks.resize(1);
        return this->Refuse("landmarks");
      case 5:
        r.spacingMm = 1e-9;
        return this->Refuse("spacingMm");
      case 6:
        r.landmarks = { { 900, 900, 900 }, { 910, 900, 900 } };
        return this->Refuse("landmarks[0]");
      default:
        r.slots = { { this->OnBone(0, 0), r.withdrawal, 1.2, 8.0, 5.0, 0.0 } };
        return this->Refuse("slots[0]");
    }
  }
  void Refuse(const std::string& words)
  {
    this->Guide.outcome = GuideOutcome::Refused;
    this->Guide.words = words;
  }

  Draw Random;
  RandomGuide Guide{};
  glm::dvec3 Off, Right, Up; ///< of the place on the vault
};

} // namespace

RandomGuide RandomGuideRecipe(std::uint32_t seed)
{
  return GuideMaker(seed).Make(seed % RandomGuideKinds);
}

} // namespace hasp
