#include "Devices/HandIntention.h"

#include "Devices/SettingsCheck.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hasp
{

namespace
{
constexpr double TwoPi = 2.0 * std::numbers::pi;
constexpr const char* What = "hand";
constexpr double MostMm = 10'000.0;

/// From where a motion began, `t` seconds into it.
IntendedPose Follow(const HoldMotion&, const RigidPose& from, double) noexcept
{
  return { from };
}

IntendedPose Follow(const MinimumJerkMotion& m, const RigidPose& from, double t) noexcept
{
  const double s = t / m.forS;
  const double way = s * s * s * (10.0 + s * (6.0 * s - 15.0));
  const double speed = 30.0 * s * s * (1.0 + s * (s - 2.0)) / m.forS;
  const glm::dvec3 apart = m.to.position - from.position;
  const glm::dvec3 turn = RotationVector(m.to.orientation * glm::conjugate(from.orientation));
  return { { from.position + way * apart, TurnBy(way * turn) * from.orientation }, speed * apart,
    speed * turn };
}

IntendedPose Follow(const ChirpMotion& m, const RigidPose& from, double t) noexcept
{
  const double slope = (m.toHz - m.fromHz) / m.forS;
  const double phase = TwoPi * t * (m.fromHz + 0.5 * slope * t);
  const double speed = TwoPi * (m.fromHz + slope * t) * std::cos(phase), way = std::sin(phase);
  return { { from.position + way * m.reachMm, TurnBy(way * m.reachRad) * from.orientation },
    speed * m.reachMm, speed * m.reachRad };
}

IntendedPose Follow(const ImpactMotion& m, const RigidPose& from, double t) noexcept
{
  return { { from.position + t * m.velocityMmPerS, from.orientation }, m.velocityMmPerS };
}

void Check(const HoldMotion&) {}
void Check(const MinimumJerkMotion& m)
{
  CheckPose(What, m.to);
}
void Check(const ChirpMotion& m)
{
  CheckVector(What, "reachMm", m.reachMm, MostMm);
  CheckVector(What, "reachRad", m.reachRad, 3.0);
  CheckRange(What, "fromHz", m.fromHz, 0.0, 200.0);
  CheckRange(What, "toHz", m.toHz, 0.0, 200.0);
}
void Check(const ImpactMotion& m)
{
  CheckVector(What, "velocityMmPerS", m.velocityMmPerS, 1e5);
}

/// The same numbers everywhere, which std::uniform_real_distribution does not promise. Vigna's
/// splitmix64.
class Uniform
{
public:
  explicit Uniform(std::uint64_t seed) : State(seed) {}
  double operator()() noexcept // in [0, 1)
  {
    std::uint64_t z = this->State += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

private:
  std::uint64_t State;
};
} // namespace

HandIntention::HandIntention(
  const RigidPose& start, std::vector<HandMotion> motions, const TremorSettings& tremor)
  : StartPose(start),
    EndPose(start),
    Trembles(tremor.reachMm > 0.0 || tremor.reachRad > 0.0)
{
  CheckPose(What, start);
  CheckRange(What, "tremor.reachMm", tremor.reachMm, 0.0, 10.0);
  CheckRange(What, "tremor.reachRad", tremor.reachRad, 0.0, 1.0);
  for (HandMotion& motion : motions)
  {
    const double forS = std::visit(
      [](const auto& m)
      {
        CheckRange(What, "forS", m.forS, 1e-9, 1e6);
        Check(m);
        return m.forS;
      },
      motion);
    this->Parts.push_back({ motion, this->EndPose, this->EndS, forS });
    this->EndS += forS;
    this->EndPose =
      std::visit([&](const auto& m) { return Follow(m, this->EndPose, forS).pose; }, motion);
  }
  Uniform uniform(tremor.seed);
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (Wave& wave : this->Tremor[axis])
      wave = { (axis < 3 ? tremor.reachMm : tremor.reachRad) / Waves,
        TwoPi * (8.0 + 4.0 * uniform()), TwoPi * uniform() };
}

IntendedPose HandIntention::At(double timeS) const noexcept
{
  IntendedPose intended{ timeS < 0.0 || this->Parts.empty() ? this->StartPose : this->EndPose };
  if (timeS >= 0.0 && timeS < this->EndS)
  {
    const auto after = std::upper_bound(this->Parts.begin(), this->Parts.end(), timeS,
      [](double t, const Part& part) { return t < part.beginS; });
    const Part& part = *std::prev(after);
    intended = std::visit(
      [&](const auto& m) { return Follow(m, part.from, timeS - part.beginS); }, part.motion);
  }
  if (this->Trembles)
    this->AddTremor(timeS, intended);
  return intended;
}

void HandIntention::AddTremor(double timeS, IntendedPose& intended) const noexcept
{
  std::array<double, 6> way{}, speed{};
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (const Wave& wave : this->Tremor[axis])
    {
      if (wave.reach == 0.0)
        break; // moves without turns, or turns without moves
      const double phase = wave.radPerS * timeS + wave.phase;
      way[axis] += wave.reach * std::sin(phase);
      speed[axis] += wave.reach * wave.radPerS * std::cos(phase);
    }
  intended.pose.position += glm::dvec3(way[0], way[1], way[2]);
  intended.pose.orientation = TurnBy({ way[3], way[4], way[5] }) * intended.pose.orientation;
  intended.velocityMmPerS += glm::dvec3(speed[0], speed[1], speed[2]);
  // Small turns: that about the trembling axes is taken for that of the vector.
  intended.turnRadPerS += glm::dvec3(speed[3], speed[4], speed[5]);
}

} // namespace hasp
