#include "FragmentTable.h"

#include <numeric>
#include <string>
#include <utility>

namespace hasp
{

namespace
{
constexpr const char* NotAsked = "not asked for";
constexpr const char* Asked = "asked for";
constexpr const char* Released = "released";
constexpr const char* Outdated = "its voxels changed";

std::size_t BytesOf(const TriangleMesh& mesh)
{
  return mesh.points.size() * sizeof(mesh.points[0]) +
         mesh.triangles.size() * sizeof(mesh.triangles[0]);
}

/// Of one that lists itself.
std::size_t BytesOf(const auto& model)
{
  ResourceList own;
  model.ListResources(own);
  return std::accumulate(own.begin(), own.end(), std::size_t{ 0 },
    [](std::size_t sum, const ResourceUse& use) { return sum + use.bytes; });
}
} // namespace

FragmentModel FragmentTable::Find(std::uint16_t label) const
{
  const std::lock_guard lock(this->Guard);
  const auto at = this->Entries.find(label);
  return at != this->Entries.end() ? at->second.model : FragmentModel{};
}

FragmentWants FragmentTable::Missing(std::uint16_t label, const FragmentWants& wants) const
{
  const FragmentModel there = this->Find(label);
  return { wants.map && !there.map, wants.shell && !there.shell, wants.surface && !there.surface,
    wants.cells && !this->FindCells().cells };
}

std::uint64_t FragmentTable::Version(std::uint16_t label) const
{
  const std::lock_guard lock(this->Guard);
  const auto at = this->Entries.find(label);
  return at != this->Entries.end() ? at->second.version : 0;
}

bool FragmentTable::Put(std::uint16_t label, std::uint64_t version, BakedFragment baked)
{
  const std::lock_guard lock(this->Guard);
  Entry& entry = this->Entries[label];
  if (entry.version != version)
    return false;
  const auto take = [&](FragmentModelKind kind, auto& there, auto& made)
  {
    if (there || !made)
      return;
    there = std::move(made);
    entry.milliseconds[kind] = baked.milliseconds[kind];
    entry.why[kind] = Asked;
  };
  entry.model.origin = baked.model.origin;
  take(MapKind, entry.model.map, baked.model.map);
  take(ShellKind, entry.model.shell, baked.model.shell);
  take(SurfaceKind, entry.model.surface, baked.model.surface);
  return true;
}

void FragmentTable::Drop(Entry& entry, const FragmentWants& what, const char* why)
{
  const auto drop = [&](FragmentModelKind kind, bool wanted, auto& model)
  {
    if (!wanted || !model)
      return;
    model.reset();
    entry.milliseconds[kind] = 0.0;
    entry.why[kind] = why;
  };
  drop(MapKind, what.map, entry.model.map);
  drop(ShellKind, what.shell, entry.model.shell);
  drop(SurfaceKind, what.surface, entry.model.surface);
}

void FragmentTable::Release(std::uint16_t label, const FragmentWants& what)
{
  const std::lock_guard lock(this->Guard);
  if (const auto at = this->Entries.find(label); at != this->Entries.end())
    Drop(at->second, what, Released);
}

void FragmentTable::Change(
  std::span<const std::uint16_t> labels, const glm::ivec3& low, const glm::ivec3& high)
{
  const std::lock_guard lock(this->Guard);
  for (const std::uint16_t label : labels)
  {
    Entry& entry = this->Entries[label];
    ++entry.version;
    Drop(entry, AllOfFragment, Outdated);
  }
  if (labels.empty())
    return;
  this->Kept.labelled = false;
  this->Kept.low = glm::min(this->Kept.low, low);
  this->Kept.high = glm::max(this->Kept.high, high);
}

FragmentTable::Cells FragmentTable::FindCells() const
{
  const std::lock_guard lock(this->Guard);
  return this->Kept;
}

void FragmentTable::PutCells(std::shared_ptr<const ClusteredCells> cells, double milliseconds)
{
  const std::lock_guard lock(this->Guard);
  if (this->Kept.cells)
    return;
  this->Kept = { std::move(cells), false };
  this->CellsMilliseconds = milliseconds;
  this->WhyCells = Asked;
}

void FragmentTable::PutLabelled(std::shared_ptr<const ClusteredCells> cells, double milliseconds)
{
  const std::lock_guard lock(this->Guard);
  this->Kept = { std::move(cells), true };
  this->CellsMilliseconds += milliseconds;
  this->WhyCells = Asked;
}

void FragmentTable::ReleaseCells()
{
  const std::lock_guard lock(this->Guard);
  if (!this->Kept.cells)
    return;
  this->Kept = {};
  this->CellsMilliseconds = 0.0;
  this->WhyCells = Released;
}

void FragmentTable::List(std::uint16_t label, const Entry& entry, ResourceList& list)
{
  const auto add = [&](FragmentModelKind kind, const char* what, const auto& model)
  {
    const char* why = entry.why[kind];
    list.push_back({ "fragment " + std::to_string(label) + " " + what, model ? BytesOf(*model) : 0,
      entry.milliseconds[kind], why ? why : NotAsked });
  };
  add(MapKind, "distance map", entry.model.map);
  add(ShellKind, "pointshell", entry.model.shell);
  add(SurfaceKind, "closed surface", entry.model.surface);
}

void FragmentTable::ListResources(std::span<const FragmentLabel> labels, ResourceList& list) const
{
  const std::lock_guard lock(this->Guard);
  list.push_back({ "fragment cells", this->Kept.cells ? this->Kept.cells->Bytes() : 0,
    this->CellsMilliseconds, this->WhyCells ? this->WhyCells : NotAsked });
  for (const FragmentLabel& there : labels)
  {
    const auto at = this->Entries.find(there.label);
    List(there.label, at != this->Entries.end() ? at->second : Entry{}, list);
  }
}

} // namespace hasp
