// What vtkHaspOpenGLClusteredCellMapper holds, and what it skipped.
#include "OpenGLClusteredCells.h"

#include <string>

void vtkHaspOpenGLClusteredCellMapper::ListResources(hasp::ResourceList& list) const
{
  this->Superclass::ListResources(list);
  hasp::ResourceUse cells{ "active cells, GPU", 0, 0.0, "nothing rasterised" };
  hasp::ResourceUse culling{ "occlusion culling", 0, 0.0,
    this->OcclusionCulling ? "nothing opaque rasterised" : "switched off" };
  hasp::ResourceUse labels{ "cell labels, GPU", 0, 0.0, "nothing was said of a label" };
  hasp::ResourceUse colors{ "cell colours, GPU", 0, 0.0, "no scalars colour the surface" };
  hasp::ResourceUse blending{ "normal blending", 0, 0.0,
    this->BlendNormals ? "nothing opaque rasterised" : "switched off" };
  const CellTracing& tracing = this->GL->Tracing;
  hasp::ResourceUse picture{ "traced picture", tracing.PictureBytes(),
    tracing.PictureMilliseconds(),
    tracing.Ready() ? "in main memory and in each window" : this->GetRendererChoice() };
  hasp::ResourceUse eyes{ "clusters both eyes see", 0, 0.0, "one eye" };
  int passes = 0;
  std::size_t lightTextures = 0;
  double shade = 0.0, select = 0.0, traced = 0.0;
  for (const auto& context : this->GL->Contexts)
  {
    cells.bytes += context->Buffers.Bytes();
    cells.milliseconds += context->UploadMilliseconds;
    if (context->Buffers.Uploaded())
      cells.reason = "drawn in " + std::to_string(this->GL->Contexts.size()) +
                     (this->GL->Contexts.size() == 1 ? " window" : " windows");
    if (context->Culling.Ready())
    {
      culling.bytes += context->Culling.Bytes();
      culling.milliseconds += context->CullingMilliseconds;
      culling.reason = "state and draw command of each cluster";
    }
    eyes.bytes += context->Eyes.Bytes();
    passes += context->Eyes.Passes();
    labels.bytes += context->Attributes.LabelBytes();
    colors.bytes += context->Attributes.ColorBytes();
    blending.bytes += context->Blending.Bytes();
    blending.milliseconds += context->Program.CompileMilliseconds(CellPass::Hits) +
                             context->Program.CompileMilliseconds(CellPass::Splats);
    picture.bytes += context->Traced.Bytes();
    lightTextures += context->Traced.LightBytes();
    picture.milliseconds += context->Traced.UploadMilliseconds();
    traced += context->Program.CompileMilliseconds(CellPass::Traced);
    shade += context->Program.CompileMilliseconds(CellPass::Shade);
    select += context->Program.CompileMilliseconds(CellPass::Select);
  }
  list.push_back(cells);
  list.push_back(culling);
  if (eyes.bytes > 0)
    eyes.reason = std::to_string(passes) + " passes over the clusters so far";
  list.push_back(eyes);
  if (labels.bytes > 0)
    labels.reason = "labels of cells, their colours and poses";
  if (colors.bytes > 0)
    colors.reason = "of the stored corners";
  if (blending.bytes > 0)
    blending.reason = "textures as large as the window, shaders";
  list.push_back(blending);
  list.push_back(labels);
  list.push_back(colors);
  list.push_back({ "ray tracing tree", tracing.TreeBytes(), tracing.TreeMilliseconds(),
    this->GetRendererChoice() });
  list.push_back(picture);
  const CellLight& light = this->GL->Light;
  const char* lit = this->AmbientOcclusion ? "its table, of fixed size"
                    : this->Shadows        ? "shadows are traced anew; nothing is kept"
                                           : "switched off";
  list.push_back({ "light cache", light.CacheBytes(), 0.0, lit });
  list.push_back({ "light of pixels", light.PictureBytes() + lightTextures, light.Milliseconds(),
    light.PictureBytes() > 0 ? "of the last traced picture" : lit });
  list.push_back({ "light of the first eye", light.SharedBytes(), 0.0,
    light.SharedBytes() > 0 ? "the second one takes it where both see" : "one eye, or no light" });
  list.push_back({ "shader: shaded cells", 0, shade,
    shade > 0 ? "compiled at the first frame" : "nothing rasterised" });
  list.push_back({ "shader: traced cells", 0, traced,
    traced > 0 ? "compiled at the first traced frame" : "nothing traced" });
  list.push_back({ "shader: cell selection", 0, select,
    select > 0 ? "a pick was asked for" : "no pick was asked for" });
  list.push_back({ "picking buffers", 0, 0.0, "none of its own: cell ids come from the cells" });
}
