#include "RandomPlates.h"

namespace hasp
{

GridGeometry RandomPlateScan()
{
  GridGeometry grid;
  grid.spacing = glm::dvec3(1.5);
  grid.origin = { -84, -105, -120 };
  grid.dims = { 113, 129, 130 };
  return grid;
}

TriedPart TriedPlate(const RandomPlate& plate)
{
  TriedPart part;
  part.kind = plate.kind;
  part.mayBeRefused = plate.outcome != PlateOutcome::Sound;
  part.refusal = plate.words;
  part.owner = "plate";
  return part;
}

std::string WrongWithPlate(
  const RandomPlate& plate, const std::string& error, const TriangleMesh& mesh)
{
  TriedPart part = TriedPlate(plate);
  part.error = error;
  part.mesh = mesh;
  const PartLine line = JudgePart(part);
  return line.outcome == PartOutcome::Sound || line.outcome == PartOutcome::Refused
           ? ""
           : std::string(PartOutcomeName(line.outcome)) + ", " + line.text;
}

} // namespace hasp
