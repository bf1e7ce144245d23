#include "FractureFolder.h"

#include "RunSegments.h"
#include "VerbWork.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"

#include "Planning/PlanFile.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <filesystem>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

LabelTable NamesOf(const FracturedScan& scan)
{
  LabelTable table;
  for (std::size_t n = 0; n < scan.names.size(); ++n)
  {
    table.push_back(UnnamedLabel(static_cast<std::uint16_t>(n + 2)));
    table.back().name = scan.names[n];
  }
  return table;
}

/// One object after the other, as if a user had made them.
Plan PlanOf(const MadeFractureCase& made, const std::string& scanHash, const std::string& labelBlob)
{
  const glm::dvec3& spacing = made.truth.geometry.spacing;
  Plan plan;
  plan.caseLabel = "made";
  plan.volumes = { { 1, "fractured", scanHash } };
  plan.segmentations = { { 2, "fragments", 1, labelBlob } };
  plan.nextId = 3;
  for (const LabelEntry& entry : NamesOf(made.fractured))
  {
    PlanFragment fragment;
    fragment.id = plan.nextId++;
    fragment.name = entry.name;
    LabelSource source;
    source.segmentation = 2;
    source.label = entry.value;
    source.isovalue = made.truth.damage.coneBeam ? -1e6 : CaseBoneHU; // grey values tell nothing
    source.spacingMm = std::clamp(std::min({ spacing.x, spacing.y, spacing.z }), 0.1, 2.0);
    fragment.source = source;
    fragment.locked = std::find(made.truth.fixed.begin(), made.truth.fixed.end(), entry.value) !=
                      made.truth.fixed.end();
    plan.fragments.push_back(std::move(fragment));
  }
  return plan;
}

void WritePlan(const MadeFractureCase& made, vtkImageData* scan, const fs::path& folder)
{
  const fs::path plan = folder / "plan.hasp", labels = folder / "labels.nrrd";
  WriteLabels(MakeImage(made.truth.geometry, made.fractured.truth), {}, labels.string());
  const std::string blob = WriteBlob(plan, ReadWholeFile(labels.string()));
  fs::remove(labels);
  SavePlan(plan, { PlanHistory(PlanOf(made, VolumeHash(ViewImage(scan)), blob)), {} });
}

void WriteInto(const MadeFractureCase& made, const fs::path& folder)
{
  const GridGeometry& grid = made.truth.geometry;
  const auto at = [&](const char* name) { return (folder / name).string(); };
  const vtkSmartPointer<vtkImageData> scan = MakeImage(grid, made.fractured.samples);
  WriteVolume(scan, at(FractureCaseFiles::FracturedScan));
  WriteVolume(MakeImage(grid, made.intact.samples), at(FractureCaseFiles::IntactScan));
  WriteLabels(MakeImage(grid, made.fractured.truth), {}, at(FractureCaseFiles::FracturedLabels));
  WriteLabels(MakeImage(grid, made.intact.truth), {}, at(FractureCaseFiles::IntactLabels));
  WriteFractureCase(folder, made.truth);
  WritePlan(made, scan, folder);
}

} // namespace

void WriteFractureFolder(const MadeFractureCase& made, const std::string& folder)
{
  Try(ExitCode::WrongUse, "",
    [&]
    {
      WriteInspected(
        folder,
        [&](const std::string& pending)
        {
          fs::create_directory(pending);
          WriteInto(made, pending);
        },
        [](const std::string&) {});
    });
}

} // namespace hasp
