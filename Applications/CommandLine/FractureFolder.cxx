#include "FractureFolder.h"

#include "PlanFragmentLabels.h"
#include "PlanFragments.h"
#include "VerbWork.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"

#include "Planning/PlanFile.h"
#include "Planning/SeedsFile.h"
#include "Segmentation/LabelSplit.h"
#include "Studies/SimulatedStrokes.h"
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

/// As if a user had made it.
void WritePlan(const MadeFractureCase& made, vtkImageData* scan, const fs::path& folder)
{
  const fs::path plan = folder / "plan.hasp";
  FragmentLabels labels{ VolumeHash(ViewImage(scan)), {}, NamesOf(made.fractured) };
  labels.blob = StoreLabels(plan.string(), MakeImage(made.truth.geometry, made.fractured.truth));
  labels.isovalue = made.truth.damage.coneBeam ? -1e6 : CaseBoneHU; // grey values tell nothing
  labels.spacingMm = FragmentSpacing(made.truth.geometry.spacing);
  labels.locked.assign(made.truth.fixed.begin(), made.truth.fixed.end());
  PlanHistory history;
  history.Do(SetCaseLabel{ "made" });
  history.Do(FragmentEdits(history.Current(), history.NewId(), labels));
  SavePlan(plan, { history, {} });
}

/// A user's who knows about where each fragment is, looks at the split and corrects it.
void WriteStrokes(const MadeFractureCase& made, int most, const fs::path& folder)
{
  const GridGeometry& grid = made.truth.geometry;
  const GridView<const std::int16_t> grey{ made.fractured.samples.data(), grid };
  std::vector<Label> bone(grid.Size());
  ThresholdLabels(grey, CaseBoneHU, 1e6, { bone.data(), grid });
  const GridView<const Label> mask{ bone.data(), grid };
  LabelSplit split(grey, mask, 1);
  const SimulatedUser user =
    SimulateUser(mask, CoarseTruth({ made.fractured.truth.data(), grid }), { most },
      [&](const std::vector<BrushStroke>& drawn)
      {
        std::vector<SeedVoxels> seeds;
        for (const BrushStroke& stroke : drawn)
          seeds.push_back({ stroke.label, RasterizeStroke(grid, stroke.points, stroke.radiusMm) });
        std::vector<Label> labels = bone;
        split.Share(seeds, { labels.data(), grid });
        return labels;
      });
  Seeds seeds;
  for (const LabelEntry& entry : NamesOf(made.fractured))
    seeds.names.push_back({ entry.value, entry.name, entry.colour });
  seeds.strokes = user.strokes;
  WriteSeeds((folder / FractureCaseFiles::Strokes).string(), seeds);
}

void WriteInto(const MadeFractureCase& made, int strokes, const fs::path& folder)
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
  if (strokes > 0)
    WriteStrokes(made, strokes, folder);
}

} // namespace

void WriteFractureFolder(const MadeFractureCase& made, int strokes, const std::string& folder)
{
  Try(ExitCode::WrongUse, "",
    [&]
    {
      WriteInspected(
        folder,
        [&](const std::string& pending)
        {
          fs::create_directory(pending);
          WriteInto(made, strokes, pending);
        },
        [](const std::string&) {});
    });
}

} // namespace hasp
