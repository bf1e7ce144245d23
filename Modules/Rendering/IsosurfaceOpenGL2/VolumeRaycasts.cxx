#include "VolumeRaycasts.h"

#include "vtkActor.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

void VolumeRaycasts::Draw(const RaycastVolume& volume, const RaycastSettings& settings,
  vtkMapper* mapper, vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  std::erase_if(this->Contexts, [](const auto& context) { return context->IsLost(); });
  if (std::isnan(volume.isovalue))
    throw std::runtime_error("the isovalue is not a number");
  if (actor->IsRenderingTranslucentPolygonalGeometry())
    throw std::runtime_error("raycasting draws opaque surfaces; vtkHaspClusteredCellMapper draws "
                             "translucent ones");
  auto found = std::find_if(this->Contexts.begin(), this->Contexts.end(),
    [&](const auto& context) { return context->IsOf(window); });
  if (found == this->Contexts.end())
    found = this->Contexts.insert(found, std::make_unique<VolumeRaycast>(window));
  (*found)->Draw(volume, settings, mapper, renderer, actor);
}

void VolumeRaycasts::MarkModified(const glm::ivec3& low, const glm::ivec3& high)
{
  for (const auto& context : this->Contexts)
    context->MarkModified(low, high);
}

void VolumeRaycasts::Release(vtkOpenGLRenderWindow* window)
{
  for (const auto& context : this->Contexts)
    if (context->IsOf(window))
      context->Free(window);
  std::erase_if(this->Contexts, [](const auto& context) { return context->IsLost(); });
}

void VolumeRaycasts::Clear()
{
  this->Contexts.clear();
}

void VolumeRaycasts::ListResources(hasp::ResourceList& list) const
{
  const std::string unused = "no raycast was asked for";
  hasp::ResourceUse samples{ "raycast samples, GPU", 0, 0.0, unused };
  hasp::ResourceUse blocks{ "raycast min-max blocks, GPU", 0, 0.0,
    this->Contexts.empty() ? unused : "no block is skipped" };
  hasp::ResourceUse shader{ "shader: raycast", 0, 0.0, unused };
  for (const auto& context : this->Contexts)
  {
    const VolumeTextures& textures = context->Textures();
    samples.bytes += textures.SampleBytes();
    samples.milliseconds += context->SamplesMilliseconds;
    samples.reason = std::to_string(textures.Parts().size()) + " textures in the last window of " +
                     std::to_string(this->Contexts.size());
    blocks.bytes += textures.BlockBytes();
    if (textures.BlockBytes() > 0)
    {
      blocks.milliseconds += context->BlocksMilliseconds;
      blocks.reason = "rays skip blocks without surface";
    }
    shader.milliseconds += context->ShaderMilliseconds;
    shader.reason = "compiled at the first frame";
  }
  list.push_back(samples);
  list.push_back(blocks);
  list.push_back(shader);
}
