#include "FragmentModels.h"

#include "FragmentBaking.h"
#include "FragmentTable.h"
#include "Grid/LabelGrid.h"
#include "Grid/Stopwatch.h"
#include "Isosurface/CellAttributes.h"
#include "LabelBlocks.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr double RangeSpacings = 16.0; // DistanceMap's own default
constexpr double MarginSpacings = 5.0; // KeptGrid's, about

void Require(bool holds, const char* name, double value, const char* legal)
{
  if (holds)
    return;
  std::ostringstream text;
  text << "fragments: " << name << " is " << value << ", must be " << legal;
  throw std::invalid_argument(text.str());
}

/// The settings with what stands for 0.
FragmentSettings Checked(const FragmentScan& scan, FragmentSettings settings)
{
  const GridGeometry& grid = GeometryOf(scan.grey);
  grid.Validate();
  CheckLabelGrid("fragments", grid, scan.labels.geometry);
  const int least = std::min({ grid.dims.x, grid.dims.y, grid.dims.z });
  Require(least >= 2, "the scan's least number of samples along an axis", least, "2 or more");
  if (!scan.labels.data || std::visit([](const auto& view) { return !view.data; }, scan.grey))
    throw std::invalid_argument("fragments: the scan or its labels have no samples");
  Require(std::isfinite(scan.isovalue), "the isovalue", scan.isovalue, "finite");
  Require(settings.spacingMm >= 0.0 && std::isfinite(settings.spacingMm), "spacingMm",
    settings.spacingMm, "0 or more, and finite");
  if (settings.spacingMm == 0.0)
    settings.spacingMm = std::min({ grid.spacing.x, grid.spacing.y, grid.spacing.z });
  if (settings.rangeMm == 0.0)
    settings.rangeMm = RangeSpacings * settings.spacingMm;
  Require(settings.rangeMm >= 0.5 * settings.spacingMm && std::isfinite(settings.rangeMm),
    "rangeMm", settings.rangeMm, "half a spacing or more, and finite; or 0");
  Require(settings.shellPoints >= 1, "shellPoints", settings.shellPoints, "1 or more");
  return settings;
}

/// Throws for a label that is not there, and says which are.
const LabelExtent& ExtentOf(const LabelBlocks& blocks, std::uint16_t label)
{
  const auto& extents = blocks.Extents();
  if (const auto at = extents.find(label); at != extents.end())
    return at->second;
  constexpr std::size_t Most = 20;
  std::ostringstream text;
  text << "label " << label << " is not in the label map, which holds ";
  if (extents.empty())
    text << "none";
  std::size_t n = 0;
  for (const auto& [there, extent] : extents)
  {
    if (n == Most)
    {
      text << " ... (" << extents.size() << " in all)";
      break;
    }
    text << (n++ > 0 ? ", " : "") << there;
  }
  throw std::invalid_argument(text.str());
}

/// About as many samples as the grids of a fragment will have.
double SamplesOf(const LabelExtent& extent, const GridGeometry& scan,
  const FragmentSettings& settings, const FragmentWants& wants)
{
  const double margin = MarginSpacings + (wants.map ? settings.rangeMm / settings.spacingMm : 0.0);
  const glm::dvec3 size =
    glm::dvec3(extent.high - extent.low + 1) * scan.spacing / settings.spacingMm + 2.0 * margin;
  return size.x * size.y * size.z;
}
} // namespace

struct FragmentModels::Internals
{
  FragmentScan scan;
  FragmentSettings settings;
  mutable std::mutex guard; ///< of blocks: ListResources may come from any thread
  LabelBlocks blocks;
  std::shared_ptr<FragmentTable> table = std::make_shared<FragmentTable>();

  Internals(const FragmentScan& given, const FragmentSettings& asked)
    : scan(given),
      settings(Checked(given, asked)),
      blocks(given.labels)
  {
    this->scan.labels.geometry = GeometryOf(given.grey); // to the last digits
  }

  glm::dvec3 Middle(const LabelExtent& extent) const
  {
    return this->scan.labels.geometry.IndexToWorld(0.5 * glm::dvec3(extent.low + extent.high));
  }

  FragmentTask TaskOf(std::uint16_t label, const FragmentWants& wants) const
  {
    const LabelExtent& extent = ExtentOf(this->blocks, label);
    const GridGeometry& grid = this->scan.labels.geometry;
    FragmentTask task;
    task.wants = this->table->Missing(label, wants);
    if (!task.wants.map && !task.wants.shell && !task.wants.surface)
      return task;
    task.crop = CropLabel(this->scan.labels, label, extent);
    task.origin = this->Middle(extent);
    task.version = this->table->Version(label);
    task.samples = SamplesOf(extent, grid, this->settings, task.wants);
    return task;
  }
};

FragmentModels::FragmentModels(const FragmentScan& scan, const FragmentSettings& settings)
  : Inside(std::make_unique<Internals>(scan, settings))
{
}
FragmentModels::~FragmentModels() = default;

std::vector<FragmentLabel> FragmentModels::Labels() const
{
  const std::lock_guard lock(this->Inside->guard);
  std::vector<FragmentLabel> labels;
  for (const auto& [label, extent] : this->Inside->blocks.Extents())
    labels.push_back(
      { label, extent.low, extent.high, extent.voxels, this->Inside->Middle(extent) });
  return labels;
}

std::shared_ptr<const ClusteredCells> FragmentModels::Cells(const ProgressFunction& progress)
{
  FragmentTable& table = *this->Inside->table;
  this->Prepare({}, { .cells = true }, progress);
  const FragmentTable::Cells there = table.FindCells();
  if (there.labelled)
    return there.cells;
  const Stopwatch time;
  const auto cells = std::make_shared<ClusteredCells>(*there.cells); // somebody may draw the old
  const GridView<const std::uint16_t> labels(this->Inside->scan.labels);
  if (cells->labels.size() == cells->Count())
    UpdateLabels(*cells, labels, there.low, there.high);
  else
    AddLabels(*cells, labels);
  table.PutLabelled(cells, time.Milliseconds());
  return cells;
}

namespace
{
/// What was prepared. It is not there if the owner's rule was broken, and the labels changed.
template <typename Model>
std::shared_ptr<const Model> Made(std::uint16_t label, std::shared_ptr<const Model> model)
{
  if (!model)
    throw std::runtime_error("label " + std::to_string(label) +
                             ": its voxels were changed while it was measured; ask again");
  return model;
}
} // namespace

std::shared_ptr<const DistanceMap> FragmentModels::Map(
  std::uint16_t label, const ProgressFunction& progress)
{
  this->Prepare({ &label, 1 }, { .map = true }, progress);
  return Made(label, this->Finished(label).map);
}

std::shared_ptr<const PointShell> FragmentModels::Shell(
  std::uint16_t label, const ProgressFunction& progress)
{
  this->Prepare({ &label, 1 }, { .shell = true }, progress);
  return Made(label, this->Finished(label).shell);
}

std::shared_ptr<const TriangleMesh> FragmentModels::Surface(
  std::uint16_t label, const ProgressFunction& progress)
{
  this->Prepare({ &label, 1 }, { .surface = true }, progress);
  return Made(label, this->Finished(label).surface);
}

FragmentModel FragmentModels::Finished(std::uint16_t label) const
{
  return this->Inside->table->Find(label);
}

bool FragmentModels::HasCells() const
{
  return this->Inside->table->FindCells().cells != nullptr;
}

std::unique_ptr<FragmentBaking> FragmentModels::Begin(
  std::span<const std::uint16_t> labels, const FragmentWants& wants)
{
  const Internals& in = *this->Inside;
  auto work = std::make_unique<FragmentBaking::Internals>();
  work->scan = in.scan;
  work->scan.labels = {}; // they may change: what is read of them is copied
  work->scan.labelOwner.reset();
  work->settings = in.settings;
  work->table = in.table;
  work->cells = wants.cells && !this->HasCells();
  for (const std::uint16_t label : std::set(labels.begin(), labels.end()))
    if (FragmentTask task = in.TaskOf(label, wants); task.samples > 0.0)
      work->tasks.push_back(std::move(task));
  return std::unique_ptr<FragmentBaking>(new FragmentBaking(std::move(work)));
}

void FragmentModels::Prepare(std::span<const std::uint16_t> labels, const FragmentWants& wants,
  const ProgressFunction& progress)
{
  this->Begin(labels, wants)->Run(progress);
}

std::vector<std::uint16_t> FragmentModels::LabelsChanged(
  const glm::ivec3& low, const glm::ivec3& high)
{
  Internals& in = *this->Inside;
  std::vector<std::uint16_t> changed;
  {
    const std::lock_guard lock(in.guard);
    changed = in.blocks.Update(in.scan.labels, low, high);
  }
  in.table->Change(changed, low, high);
  return changed;
}

void FragmentModels::Release(std::uint16_t label, const FragmentWants& what)
{
  this->Inside->table->Release(label, what);
  if (what.cells)
    this->ReleaseCells();
}

void FragmentModels::ReleaseCells()
{
  this->Inside->table->ReleaseCells();
}

void FragmentModels::ListResources(ResourceList& list) const
{
  this->Inside->table->ListResources(this->Labels(), list);
}

} // namespace hasp
