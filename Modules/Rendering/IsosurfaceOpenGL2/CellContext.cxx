#include "CellContext.h"

#include "vtkOpenGLRenderWindow.h"

#include <chrono>

namespace
{
double MillisecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}
}

CellContext::CellContext(vtkOpenGLRenderWindow* window)
  : Window(window),
    CreationTime(window->GetContextCreationTime())
{
}

CellContext::~CellContext()
{
  this->Free(this->Window);
}

bool CellContext::IsOf(vtkOpenGLRenderWindow* window) const
{
  return window && window->GetContextCreationTime() == this->CreationTime;
}

void CellContext::Free(vtkOpenGLRenderWindow* window)
{
  if (this->IsOf(window))
  {
    window->PushContext();
    if (window->IsCurrent())
    {
      this->Buffers.Release();
      this->Culling.Release();
    }
    window->PopContext();
  }
  this->Buffers = {};
  this->Culling = {};
  this->CreationTime = 0;
}

void CellContext::Upload(
  const hasp::ClusteredCells& cells, vtkMTimeType time, std::size_t blockBytes)
{
  if (time == this->CellsTime)
    return;
  const auto start = std::chrono::steady_clock::now();
  this->CellsTime = 0;
  this->Culling.Release();
  this->Buffers.Upload(cells, blockBytes);
  this->CellsTime = time;
  this->UploadMilliseconds = MillisecondsSince(start);
}

OcclusionCulling& CellContext::UseCulling(const hasp::ClusteredCells& cells, std::size_t blockBytes)
{
  if (!this->Culling.Ready())
  {
    const auto start = std::chrono::steady_clock::now();
    this->Culling.Reset(cells, blockBytes);
    this->CullingMilliseconds = MillisecondsSince(start);
  }
  return this->Culling;
}
