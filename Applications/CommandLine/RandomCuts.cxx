#include "RandomCuts.h"

#include "Draw.h"
#include "FragmentCutter.h"

#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"

#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

/// A piece of the phantom's bone, and its middle.
struct BonePiece
{
  GridGeometry grid;
  std::vector<std::int16_t> samples;
  glm::dvec3 middle;
};

BonePiece RandomPiece(Draw& draw)
{
  PhantomSettings settings;
  const std::size_t which = draw.Below(3);
  if (which == 2)
    settings.anatomy = PhantomAnatomy::Fibula;
  BonePiece piece;
  if (which == 0)
    piece.middle =
      PhantomOuterTable(settings, { draw.From(-1, 1), draw.From(-1, 1), draw.From(0.4, 1.5) });
  else
  {
    std::vector<PhantomLandmark> landmarks = PhantomLandmarks(settings);
    std::erase_if(landmarks, [&](const PhantomLandmark& landmark)
      { return which == 1 && landmark.part != PhantomPart::Mandible; });
    piece.middle = landmarks[draw.Below(landmarks.size())].point;
  }
  piece.grid.spacing = glm::dvec3(draw.From(0.6, 0.9));
  piece.grid.dims = glm::ivec3(int(30.0 / piece.grid.spacing.x));
  piece.grid.origin = piece.middle - 0.5 * piece.grid.spacing * glm::dvec3(piece.grid.dims - 1);
  piece.samples = SamplePhantom(piece.grid, settings);
  return piece;
}

} // namespace

PartLine TryCut(std::uint32_t seed)
{
  Draw draw(seed);
  const BonePiece piece = RandomPiece(draw);
  CutRecipe recipe;
  recipe.spacingMm = draw.From(0.6, 1.0);
  recipe.ignoreBelowMm3 = 20.0;
  for (std::size_t n = 1 + draw.Below(2); n > 0; --n)
  {
    const glm::dvec3 normal = draw.Direction();
    const glm::dvec3 along = glm::normalize(
      glm::cross(normal, std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 at = piece.middle + draw.From(0.0, 6.0) * draw.Direction();
    recipe.cuts.push_back(
      { { at, normal, along, draw.From(10, 60), draw.From(10, 60), draw.From(0.6, 2.0) }, 8.0 });
  }
  PartLine line;
  const auto start = std::chrono::steady_clock::now();
  try
  {
    const CutBone cut = CutFragments(
      { GridView<const std::int16_t>{ piece.samples.data(), piece.grid }, {}, 1 }, recipe);
    line.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    line.figure = cut.UnaccountedShare();
    line.outcome = cut.fragments.empty() ? PartOutcome::Empty : PartOutcome::Sound;
    line.text = std::to_string(cut.fragments.size()) + " fragments";
    for (const BoneFragment& fragment : cut.fragments)
    {
      line.triangles += fragment.mesh.triangles.size();
      if (!CheckMesh(AsWritten(fragment.mesh)).Sound())
        line.outcome = PartOutcome::Open;
    }
  }
  catch (const std::exception& error)
  {
    TriedPart part{ "cut", true, {}, "cut" };
    part.error = error.what();
    line = JudgePart(part);
  }
  return line;
}

} // namespace hasp
