#include "CellContext.h"

#include "HaspGL.h"

#include "vtkCommand.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

namespace
{
double MillisecondsSince(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

/// Does the processor do what a GPU should?
bool IsSoftwareOpenGL()
{
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string renderer = name ? name : "";
  const std::array<const char*, 4> software{ "llvmpipe", "softpipe", "SWR", "swrast" };
  return std::any_of(software.begin(), software.end(),
    [&](const char* part) { return renderer.find(part) != std::string::npos; });
}
}

CellContext::CellContext(vtkOpenGLRenderWindow* window)
  : Version(OpenGLVersion::OfCurrentContext()),
    SoftwareOpenGL(IsSoftwareOpenGL()),
    Home(window),
    FrameObserver(window->AddObserver(vtkCommand::StartEvent, this, &CellContext::BeginFrame))
{
  this->Frame.Modified();
}

CellContext::~CellContext()
{
  this->Free(nullptr);
  if (vtkOpenGLRenderWindow* window = this->Home.Window())
    window->RemoveObserver(this->FrameObserver);
}

void CellContext::BeginFrame()
{
  this->FrameBefore = this->Frame;
  this->Frame.Modified();
  this->Eyes.BeginFrame();
}

void CellContext::Free(vtkOpenGLRenderWindow* window)
{
  this->Home.Leave(window,
    [this]
    {
      this->Buffers.Release();
      this->Attributes.Release();
      this->Blending.Release();
      this->Culling.Release();
      this->Traced.Release();
    });
  this->Buffers = {};
  this->Attributes = {};
  this->Blending = {};
  this->Culling = {};
  this->Eyes = {};
  this->Traced = {};
}

void CellContext::Upload(
  const hasp::ClusteredCells& cells, vtkMTimeType time, std::size_t blockBytes)
{
  this->BuffersUsed.Modified();
  if (time == this->CellsTime)
    return;
  const auto start = std::chrono::steady_clock::now();
  this->CellsTime = 0;
  this->Culling.Release();
  this->Buffers.Upload(cells, blockBytes);
  this->CellsTime = time;
  this->UploadMilliseconds = MillisecondsSince(start);
}

void CellContext::ReleaseUnusedBuffers()
{
  if (this->BuffersUsed > this->FrameBefore)
    return;
  this->Buffers.Release();
  this->Culling.Release();
  this->CellsTime = 0;
}

OcclusionCulling& CellContext::UseCulling(const hasp::ClusteredCells& cells)
{
  if (!this->Culling.Ready())
  {
    const auto start = std::chrono::steady_clock::now();
    this->Culling.Reset(cells);
    this->CullingMilliseconds = MillisecondsSince(start);
  }
  return this->Culling;
}
