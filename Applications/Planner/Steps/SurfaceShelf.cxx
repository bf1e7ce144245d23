#include "Steps/SurfaceShelf.h"

#include "Model/KeptFiles.h"
#include "Tools/Planner.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspSurfaceFile.h"
#include "vtkHaspSurfaceHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

fs::path FileOf(const fs::path& folder, const std::string& hash)
{
  return folder / (hash + ".ply");
}

} // namespace

SurfaceShelf::SurfaceShelf(Planner& planner) : QObject(&planner), With(planner)
{
  connect(
    &planner.plan, &PlanSession::Replaced, this, [this] { this->KeepOnly(this->With.plan.Now()); });
}

SurfaceShelf& SurfaceShelf::Of(Planner& planner)
{
  if (auto* there = planner.findChild<SurfaceShelf*>(QString(), Qt::FindDirectChildrenOnly))
    return *there;
  return *new SurfaceShelf(planner); // the planner's own
}

void SurfaceShelf::Put(const std::string& hash, Mesh mesh)
{
  this->With.scene.PutSurface(hash, MakePolyData(*mesh));
  this->Meshes.insert_or_assign(hash, std::move(mesh));
  Q_EMIT this->Added();
}

SurfaceShelf::Mesh SurfaceShelf::Find(const std::string& hash) const
{
  const auto found = this->Meshes.find(hash);
  return found == this->Meshes.end() ? nullptr : found->second;
}

std::vector<PlanSurface> SurfaceShelf::Missing(const Plan& plan) const
{
  std::vector<PlanSurface> missing;
  std::copy_if(plan.surfaces.begin(), plan.surfaces.end(), std::back_inserter(missing),
    [&](const PlanSurface& surface) { return !this->Meshes.contains(surface.hash); });
  return missing;
}

void SurfaceShelf::KeepOnly(const Plan& plan)
{
  std::erase_if(this->Meshes,
    [&](const auto& mesh)
    {
      const bool named = std::any_of(plan.surfaces.begin(), plan.surfaces.end(),
        [&](const PlanSurface& surface) { return surface.hash == mesh.first; });
      if (!named)
        this->With.scene.PutSurface(mesh.first, nullptr);
      return !named;
    });
}

fs::path SurfaceShelf::Folder() const
{
  return this->With.folders.state / "surfaces";
}

bool SurfaceShelf::IsKept(const std::string& hash) const
{
  std::error_code ignored; // then it is not
  return fs::exists(FileOf(this->Folder(), hash), ignored);
}

void SurfaceShelf::Keep(const fs::path& folder, const std::string& hash, const TriangleMesh& mesh)
{
  const fs::path file = FileOf(folder, hash);
  std::error_code error;
  if (fs::exists(file, error))
    return;
  fs::create_directories(folder, error);
  try
  {
    WriteSurface(MakePolyData(mesh), file.string());
    DropOldestFiles(folder, MostBytes);
  }
  catch (const std::exception&) // as the header says
  {
  }
}

SurfaceShelf::Mesh SurfaceShelf::ReadKept(
  const fs::path& folder, const std::string& hash, const ProgressFunction& progress)
{
  const fs::path file = FileOf(folder, hash);
  std::error_code error;
  if (!fs::exists(file, error))
    return nullptr;
  try
  {
    auto mesh = std::make_shared<const TriangleMesh>(
      MakeTriangleMesh(LoadSurface(file.string(), {}, progress).surface));
    if (SurfaceHash(*mesh) == hash)
    {
      fs::last_write_time(file, fs::file_time_type::clock::now(), error); // it is the newest again
      return mesh;
    }
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception&) // damaged: as if it were not there
  {
  }
  fs::remove(file, error);
  return nullptr;
}

} // namespace hasp
