#include "Window/MeasureScenes.h"

#include "Grid/Phantom.h"
#include "Steps/SurfaceShelf.h"
#include "Studies/FractureCases.h"
#include "Window/MeasureWindow.h"
#include "Window/PlannerWindow.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspSurfaceHash.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace hasp
{
namespace
{
constexpr int SmallSize = 64;
constexpr double BoneHU = 226.0;
const glm::dvec3 InJaw{ -20.0, -67.0, -96.0 }; ///< of the phantom

ShelfScan ScanOf(const GridGeometry& grid, std::vector<std::int16_t> samples)
{
  ShelfScan scan;
  scan.passport.geometry = grid;
  scan.passport.modality = "CT";
  scan.passport.hounsfield = true;
  scan.passport.hash = VolumeHash(GridView<const std::int16_t>{ samples.data(), grid });
  scan.image = MakeImage(grid, std::move(samples));
  return scan;
}

void LookFromFront(PlannerWindow& window)
{
  WaitSettled(window);
  window.Parts().scene.LookFrom('A');
  WaitSettled(window);
}

std::string WholeFile(const std::filesystem::path& path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(text).str();
}

/// A label map as the plan keeps it.
std::string StoreLabelMap(PlanSession& plan, vtkImageData* labels)
{
  const std::filesystem::path file = plan.Folder() / "measured.nrrd";
  WriteVolume(labels, file.string());
  const std::string hash = plan.StoreBlob(WholeFile(file));
  std::filesystem::remove(file);
  return hash;
}

/// Shown and kept. Its hash.
std::string PutBall(Planner& parts)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.0, -150.0, 0.0);
  ball->SetRadius(15.0);
  ball->Update();
  const auto mesh = std::make_shared<const TriangleMesh>(MakeTriangleMesh(ball->GetOutput()));
  const std::string hash = SurfaceHash(*mesh);
  SurfaceShelf& shelf = SurfaceShelf::Of(parts);
  SurfaceShelf::Keep(shelf.Folder(), hash, *mesh);
  shelf.Put(hash, mesh);
  return hash;
}
} // namespace

void ShowPhantom(PlannerWindow& window, int size)
{
  const GridGeometry grid = PhantomGridOfSize(glm::ivec3(size));
  ShelfScan scan = ScanOf(grid, SamplePhantom(grid));
  Planner& parts = window.Parts();
  parts.plan.BeginNew();
  const std::string hash = scan.passport.hash;
  parts.scans.Put(std::move(scan));
  parts.plan.Do(AddObject<PlanVolume>{ { parts.plan.NewId(), "phantom", hash } });
  LookFromFront(window);
}

void ShowSmallCase(PlannerWindow& window)
{
  ShowPhantom(window, SmallSize);
  Planner& parts = window.Parts();
  const PlanId volume = parts.scene.ShownVolume();
  ScanShelf::Keep(parts.scans.Folder(), *parts.scans.OfVolume(parts.plan.Now(), volume));
  PlanId id = parts.plan.NewId();
  PlanFragment jaw;
  jaw.id = id++;
  jaw.source = ComponentSource{ volume, BoneHU, InJaw, 2.0 };
  PlanCut cut;
  cut.id = id++;
  cut.fragments = { jaw.id };
  cut.blade.point = { 0.0, -80.0, -96.0 };
  cut.blade.normal = { 1.0, 0.0, 0.0 };
  cut.blade.along = { 0.0, 0.0, 1.0 };
  PlanSurface surface{ id++, "ball", PutBall(parts) };
  PlanFragment ball;
  ball.id = id++;
  ball.source = SurfaceSource{ surface.id };
  parts.plan.Do(std::vector<PlanEdit>{ AddObject<PlanFragment>{ jaw }, AddObject<PlanCut>{ cut },
    AddObject<PlanSurface>{ surface }, AddObject<PlanFragment>{ ball } });
  LookFromFront(window);
}

void ShowBrokenJaw(PlannerWindow& window)
{
  const FractureCase jaw = BrokenMandible({ .spacingMm = 0.8 });
  FracturedScan broken = BreakPhantom(jaw.geometry, jaw.settings);
  Planner& parts = window.Parts();
  parts.plan.BeginNew();
  const std::string labels = StoreLabelMap(parts.plan, MakeImage(broken.geometry, broken.truth));
  ShelfScan scan = ScanOf(broken.geometry, std::move(broken.samples));
  PlanId id = parts.plan.NewId();
  const PlanId volume = id++, map = id++;
  std::vector<PlanEdit> edits{ AddObject<PlanVolume>{ { volume, "jaw", scan.passport.hash } },
    AddObject<PlanSegmentation>{ { map, "pieces", volume, labels } } };
  for (std::size_t n = 0; n < broken.names.size(); ++n)
  {
    PlanFragment fragment;
    fragment.id = id++;
    fragment.name = broken.names[n];
    fragment.source = LabelSource{ map, std::uint32_t(2 + n), BoneHU, 0.8 };
    fragment.locked = n == 0;
    edits.push_back(AddObject<PlanFragment>{ fragment });
  }
  parts.scans.Put(std::move(scan));
  parts.plan.Do(std::move(edits));
  LookFromFront(window);
}

} // namespace hasp
