#include "PartKinds.h"

#include "Draw.h"
#include "FragmentCutter.h"
#include "GuideClaims.h"
#include "RandomGuides.h"
#include "VtkMessages.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspVolumeView.h"

#include "Evaluation/MeshCheck.h"
#include "Evaluation/SlotFit.h"
#include "Evaluation/TriangleTree.h"
#include "Grid/Phantom.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

double SecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// As a binary STL file keeps it.
TriangleMesh AsWritten(TriangleMesh mesh)
{
  for (glm::dvec3& p : mesh.points)
    p = glm::dvec3(glm::vec3(p));
  return WeldPoints(mesh);
}

/// Runs a filter of parts, and fills in what came of it. Its time, s.
template <typename Filter>
double Make(Filter* filter, TriedPart& part)
{
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const double seconds = SecondsSince(start);
  part.error = TakeVtkError();
  part.mesh = AsWritten(MakeTriangleMesh(filter->GetOutput()));
  return seconds;
}

/// Is there nothing else whose walls could be taken for the slot's?
bool IsFree(const GuideRecipe& recipe, const ClaimedSlot& slot)
{
  if (recipe.slots.size() != 1 || !recipe.flanges.empty() || !recipe.labels.empty())
    return false;
  for (const GuideHole& hole : recipe.holes)
  {
    const glm::dvec3 off = hole.point - slot.point;
    const double reach = 0.5 * hole.diameterMm + recipe.sleeveWallMm + 1.0;
    if (std::abs(glm::dot(off, slot.normal)) < 0.5 * slot.widthMm + reach &&
        std::abs(glm::dot(off, slot.along)) < 0.5 * slot.lengthMm + reach)
      return false;
  }
  return true;
}

/// The saw planes found in what was written: figure: mm off, second: degrees; -1 without any.
void MeasurePlanes(
  const GuideRecipe& recipe, vtkHaspGuideFilter* filter, const TriangleMesh& mesh, PartLine& line)
{
  line.figure = line.second = -1.0;
  if (line.verdict != PartVerdict::Sound)
    return;
  glm::dvec3 axis;
  filter->GetInsertionAxis(&axis.x);
  const TriangleTree tree(mesh);
  constexpr std::size_t LeastPlaces = 30; // of fewer there is no plane to speak of
  for (const ClaimedSlot& slot : ClaimsOf(recipe, 0.95, axis).slots)
    if (IsFree(recipe, slot))
      if (const SlotFit fit = FitSlot(tree, slot); fit.places >= LeastPlaces)
      {
        line.figure = std::max(line.figure, fit.offsetMm);
        line.second = std::max(line.second, fit.tiltDegrees);
      }
}

PartLine TryGuide(std::uint32_t seed)
{
  const RandomGuide guide = RandomGuideRecipe(seed);
  TriedPart part{ guide.kind, true, guide.words, "guide" };
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetInputData(MakeImage(guide.scan, SamplePhantom(guide.scan)));
  filter->SetRecipe(guide.recipe);
  const double seconds = Make(filter.Get(), part);
  PartLine line = JudgePart(part);
  line.seconds = seconds;
  MeasurePlanes(guide.recipe, filter, part.mesh, line);
  return line;
}

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

/// figure: the share of bone that fragments and kerfs do not account for.
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
    line.seconds = SecondsSince(start);
    line.figure = cut.UnaccountedShare();
    line.verdict = cut.fragments.empty() ? PartVerdict::Empty : PartVerdict::Sound;
    line.text = std::to_string(cut.fragments.size()) + " fragments";
    for (const BoneFragment& fragment : cut.fragments)
    {
      line.triangles += fragment.mesh.triangles.size();
      if (!CheckMesh(AsWritten(fragment.mesh)).Sound())
        line.verdict = PartVerdict::Open;
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

} // namespace

const std::vector<PartKind>& PartKinds()
{
  static const std::vector<PartKind> kinds{
    { "guide", TryGuide }, { "cut", TryCut }, // no part: it is counted by itself
  };
  return kinds;
}

} // namespace hasp
