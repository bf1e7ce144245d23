// A bone in hand, pressed across another: the force as an arrow, and the points of its dynamic
// shell, which is drawn where the bones may touch. A simulated hand in virtual time, no thread.
#include "HapticDrawing.h"

#include "HapticRenderScene.h"

#include "Grid/AnalyticVolumes.h"
#include "HaspRenderTest.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkShortArray.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double Grey = 1000.0, GreyPerMm = 100.0; // of the surface; inside is brighter

/// A long bone along x: a shaft with two ends that are thicker. mm, negative inside.
double BoneDistance(const glm::dvec3& p)
{
  const auto blend = [](double a, double b, double width)
  {
    const double near = std::max(width - std::abs(a - b), 0.0) / width;
    return std::min(a, b) - 0.25 * width * near * near;
  };
  const glm::dvec3 axis(std::clamp(p.x, -22.0, 22.0), 0, 0), side(0, 4, 0), end(24, 0, 0);
  const double shaft = glm::length(p - axis) - 5.0;
  const glm::dvec3 one(std::abs(p.x), p.y, p.z);
  const double knobs = blend(glm::length(one - end - side), glm::length(one - end + side), 2.0);
  return blend(shaft, knobs - 6.0, 6.0);
}

const AnalyticVolume Bone{ "bone", [](const glm::dvec3& p) { return -BoneDistance(p); }, 1.0 };

GridGeometry BoneGrid()
{
  return { glm::ivec3(85, 41, 33), glm::dvec3(-42, -20, -16), glm::dvec3(1.0), glm::dmat3(1) };
}

/// As a scanner would make it.
vtkSmartPointer<vtkImageData> BoneImage()
{
  const GridGeometry grid = BoneGrid();
  const auto samples = SampleAnalytic<std::int16_t>(Bone, grid, GreyPerMm, Grey);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(grid.dims.x, grid.dims.y, grid.dims.z);
  image->SetOrigin(&grid.origin.x);
  vtkNew<vtkShortArray> values;
  values->SetNumberOfValues(static_cast<vtkIdType>(samples.size()));
  std::copy(samples.begin(), samples.end(), values->GetPointer(0));
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkActor> BoneActor(vtkImageData* image, const glm::dvec3& color)
{
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetIsoValue(Grey);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
  return actor;
}

/// The bone as a tool before the bone as a map.
std::unique_ptr<HapticSceneOffer> Bones(vtkImageData* image)
{
  const GridGeometry grid = BoneGrid();
  auto source = std::make_shared<DynamicShellSource>();
  const auto* values = static_cast<const std::int16_t*>(image->GetScalarPointer());
  source->volume.grid = GridView<const std::int16_t>{ values, grid };
  source->volume.blocks = std::make_shared<const MinMaxBlocks>(source->volume.grid);
  source->volume.isovalue = Grey;
  const auto distance = SampleAnalytic<float>(Bone, grid, -1.0, 0.0);
  auto map = std::make_shared<const DistanceMap>(GridView<const float>{ distance.data(), grid });
  auto offer = std::make_unique<HapticSceneOffer>();
  offer->scene = std::make_unique<HapticScene>(std::vector<HapticShell>{ { nullptr, {}, source } },
    std::vector<HapticBody>{ { std::move(map), {} } });
  offer->number = 1;
  return offer;
}

} // namespace

int TestTouchPicture(int argc, char* argv[])
{
  // In hand across the other, from where nothing touches; the hand wants it 8 mm into the shaft.
  const glm::dquat across = TurnBy({ 0.15, 0, 1.2 });
  HapticChain chain(HandAt({ { 2, 0, 16 }, across },
                      { HoldMotion{ 0.05 }, MinimumJerkMotion{ { { 2, 0, 2 }, across }, 0.3 } }),
    Settings());
  const vtkSmartPointer<vtkImageData> image = BoneImage();
  chain.OfferScene(Bones(image));
  std::int64_t nowNs = 0;
  Ticks(chain, 1000, nowNs);
  auto asked = std::make_unique<HapticDiscRequest>();
  asked->room.resize(4096);
  chain.Discs().Offer(std::move(asked));
  const HapticSnapshot& seen = Ticks(chain, 1, nowNs);
  const auto discs = chain.Discs().Collect();

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.15, 0.2);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(400, 320);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  const auto ground = BoneActor(image, { 0.85, 0.8, 0.7 });
  const auto held = BoneActor(image, { 0.5, 0.7, 0.9 });
  held->GetProperty()->SetOpacity(0.4); // the points are on its far side
  vtkNew<vtkMatrix4x4> place;
  Set(place, seen.tool);
  held->SetUserMatrix(place);
  renderer->AddActor(ground);
  renderer->AddActor(held);
  HapticDrawing drawing;
  drawing.SetRenderer(renderer);
  drawing.forces = drawing.shell = true;
  drawing.mmPerNewton = 60.0; // half a newton is more than the bone's radius
  drawing.Update(seen, discs.get());

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(50, -100, 55);
  camera->SetFocalPoint(0, 0, 14);
  camera->SetViewUp(0, 0, 1);
  renderer->ResetCameraClippingRange();
  window->Render();
  const bool touches = seen.contacts > 0 && discs && discs->count > 0;
  return touches ? hasp::CheckPicture(window, argc, argv) : 1;
}
