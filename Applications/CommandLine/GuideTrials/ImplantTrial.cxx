#include "ImplantTrial.h"

#include "RandomImplants.h"

#include <exception>
#include <map>

namespace hasp
{
namespace
{

/// Makes one, and counts it; says what went otherwise.
std::string TryOne(const RandomImplant& random, const ImplantSkull& skull,
  const MakeImplantFunction& make, ImplantTrial& trial)
{
  TriedPart part = TriedImplant(random);
  try
  {
    part.mesh = AsWritten(make(skull.View(), random.recipe));
  }
  catch (const std::exception& error)
  {
    part.error = error.what();
  }
  const PartLine line = JudgePart(part);
  trial.made += line.outcome == PartOutcome::Sound;
  trial.refused += line.outcome == PartOutcome::Refused;
  return line.outcome == PartOutcome::Sound || line.outcome == PartOutcome::Refused
           ? ""
           : std::string(PartOutcomeName(line.outcome)) + ", " + line.text;
}
} // namespace

TriedPart TriedImplant(const RandomImplant& implant)
{
  TriedPart part;
  part.kind = ImplantNonsenseName(implant.nonsense);
  part.mayBeRefused = false; // but for what it must be refused for
  part.refusal = implant.says;
  part.owner = "implant";
  return part;
}

ImplantTrial TryImplants(
  std::uint32_t firstSeed, std::size_t count, std::uint32_t step, const MakeImplantFunction& make)
{
  ImplantTrial trial;
  std::map<std::uint32_t, ImplantSkull> skulls;
  for (std::size_t n = 0; n < count; ++n)
  {
    const auto seed = std::uint32_t(firstSeed + n * step);
    ImplantSkull& skull = skulls[seed % ImplantSkulls];
    if (skull.grey.empty())
      skull = MakeImplantSkull(seed);
    const RandomImplant random = RandomImplantRecipe(seed, skull);
    ++trial.recipes;
    const std::string wrong = TryOne(random, skull, make, trial);
    if (!wrong.empty())
      trial.wrong.push_back("seed " + std::to_string(seed) + ": " + wrong);
  }
  return trial;
}

} // namespace hasp
