#include "PartKinds.h"

#include "GuideClaims.h"
#include "RandomCuts.h"
#include "RandomGuides.h"
#include "RandomImplants.h"
#include "RandomPlates.h"
#include "VtkMessages.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspImplantFilter.h"
#include "vtkHaspPlateFilter.h"
#include "vtkHaspVolumeView.h"

#include "Evaluation/SlotFit.h"
#include "Evaluation/TriangleTree.h"
#include "Grid/Phantom.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>

#include <array>
#include <chrono>
#include <cmath>

namespace hasp
{
namespace
{

/// Runs a filter of parts on a scan, fills in what came of it, and judges that.
template <typename Filter>
PartLine TryPart(Filter* filter, vtkImageData* scan, TriedPart& part)
{
  filter->SetInputData(scan);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  part.error = TakeVtkError();
  part.mesh = AsWritten(MakeTriangleMesh(filter->GetOutput()));
  PartLine line = JudgePart(part);
  line.seconds = spent.count();
  return line;
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
void MeasurePlanes(const GuideRecipe& made, const TriangleMesh& mesh, PartLine& line)
{
  line.figure = line.second = -1.0;
  if (line.outcome != PartOutcome::Sound)
    return;
  const TriangleTree tree(mesh);
  constexpr std::size_t LeastPlaces = 30; // of fewer there is no plane to speak of
  for (const ClaimedSlot& slot : ClaimsOf(made).slots)
    if (IsFree(made, slot))
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
  filter->SetRecipe(guide.recipe);
  PartLine line = TryPart(filter.Get(), MakeImage(guide.scan, SamplePhantom(guide.scan)), part);
  MeasurePlanes(filter->GetMadeRecipe(), part.mesh, line);
  return line;
}

PartLine TryPlate(std::uint32_t seed)
{
  static const vtkSmartPointer<vtkImageData> head =
    MakeImage(RandomPlateScan(), SamplePhantom(RandomPlateScan())); // a second: for all seeds
  const RandomPlate plate = RandomPlateRecipe(seed);
  TriedPart part = TriedPlate(plate);
  vtkNew<vtkHaspPlateFilter> filter;
  filter->SetRecipe(plate.recipe);
  return TryPart(filter.Get(), head, part);
}

struct ScannedSkull
{
  ImplantSkull skull;
  vtkSmartPointer<vtkImageData> image;
};

PartLine TryImplant(std::uint32_t seed)
{
  static std::array<ScannedSkull, ImplantSkulls> skulls; // a second each: for all seeds
  auto& [skull, image] = skulls[seed % ImplantSkulls];
  if (!image)
  {
    skull = MakeImplantSkull(seed);
    image = MakeImage(skull.scan, skull.grey);
  }
  const RandomImplant implant = RandomImplantRecipe(seed, skull);
  TriedPart part = TriedImplant(implant);
  vtkNew<vtkHaspImplantFilter> filter;
  filter->SetRecipe(implant.recipe);
  return TryPart(filter.Get(), image, part);
}

} // namespace

const std::vector<PartKind>& PartKinds()
{
  static const std::vector<PartKind> kinds{
    { "guide", 2, TryGuide },
    { "plate", 1, TryPlate },
    { "implant", 1, TryImplant },
    { "cut", 0, TryCut },
  };
  return kinds;
}

} // namespace hasp
