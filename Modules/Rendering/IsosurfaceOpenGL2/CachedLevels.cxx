#include "CachedLevels.h"

#include "Grid/Stopwatch.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkCommand.h"
#include "vtkNew.h"

struct CachedLevels::Level
{
  vtkNew<vtkHaspClusteredCells> cells;
  vtkNew<vtkHaspClusteredCellMapper> mapper;
};

CachedLevels::CachedLevels(vtkCommand* hearsErrors) : HearsErrors(hearsErrors) {}
CachedLevels::~CachedLevels() = default;

void CachedLevels::Clear()
{
  this->Levels.clear();
}

void CachedLevels::Set(std::size_t n, std::shared_ptr<const hasp::ClusteredCells> cells)
{
  if (this->Levels.size() <= n)
    this->Levels.resize(n + 1);
  std::unique_ptr<Level>& level = this->Levels[n];
  if (cells->Count() == 0)
    return level.reset();
  if (!level)
  {
    level = std::make_unique<Level>();
    level->mapper->AddObserver(vtkCommand::ErrorEvent, this->HearsErrors);
    level->mapper->SetInputDataObject(level->cells);
    level->mapper->OcclusionCullingOff(); // rays met what is there: little of it is hidden
  }
  if (level->cells->GetCells() != cells)
    level->cells->SetCells(std::move(cells));
}

void CachedLevels::Draw(vtkHaspRayCachingMapper* mapper, vtkRenderer* renderer, vtkActor* actor)
{
  const hasp::Stopwatch watch;
  for (const auto& level : this->Levels)
    if (level)
    {
      level->mapper->SetClippingPlanes(mapper->GetClippingPlanes());
      level->mapper->SetRenderer(mapper->GetRenderer());
      level->mapper->Render(renderer, actor);
    }
  this->DrawMilliseconds = watch.Milliseconds();
}

void CachedLevels::Release(vtkWindow* window)
{
  for (const auto& level : this->Levels)
    if (level)
      level->mapper->ReleaseGraphicsResources(window);
}

std::string CachedLevels::RendererText() const
{
  std::size_t most = 0;
  std::string text = "it is empty";
  for (const auto& level : this->Levels)
    if (level && level->cells->GetCells()->Count() > most)
    {
      most = level->cells->GetCells()->Count();
      text = level->mapper->GetRendererChoice();
    }
  return text;
}

std::size_t CachedLevels::DrawingBytes() const
{
  hasp::ResourceList all;
  for (const auto& level : this->Levels)
    if (level)
      level->mapper->ListResources(all);
  std::size_t bytes = 0;
  for (const hasp::ResourceUse& use : all)
    if (use.resource != "active cells, host" && use.resource != "min-max blocks")
      bytes += use.bytes;
  return bytes;
}

std::size_t CachedLevels::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& level : this->Levels)
    bytes += level ? level->cells->GetCells()->Bytes() : 0;
  return bytes;
}
