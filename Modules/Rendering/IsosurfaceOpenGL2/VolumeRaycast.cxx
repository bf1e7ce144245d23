#include "VolumeRaycast.h"

#include "CellFrame.h"
#include "CellScene.h"
#include "Grid/Stopwatch.h"
#include "HaspGL.h"
#include "RayRoot.h"
#include "SelectionColor.h"
#include "SelectionScope.h"
#include "ShaderSlots.h"
#include "SurfaceShading.h"
#include "vtkHaspVolumeRaycastFS.h"
#include "vtkHaspVolumeRaycastVS.h"

#include "vtkActor.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace
{

/// The sample that the driver's normalisation makes 1, and how far its numbers are off there.
struct Normalization
{
  double largest, rounding;
};

Normalization NormalizationOf(const hasp::AnyGridView& grid, double isovalue)
{
  constexpr double digits = 4.0 * std::numeric_limits<float>::epsilon();
  return std::visit(
    [&]<typename T>(const hasp::GridView<const T>&) -> Normalization
    {
      if (std::is_same_v<T, float>)
        return { 1.0, digits * std::abs(isovalue) };
      const double largest = std::is_signed_v<T> ? 32767.0 : 65535.0; // uint8 is kept as uint16
      // Flat regions of the next sample below stay outside.
      const double gap = isovalue - (std::ceil(isovalue) - 1.0);
      return { largest, std::min(digits * largest, 0.5 * gap) };
    },
    grid);
}

std::string CornerDefines(const hasp::AnyGridView& grid)
{
  return std::visit(
    []<typename T>(const hasp::GridView<const T>&) -> std::string
    {
      if (std::is_same_v<T, float>)
        return "#define HASP_FLOAT_CORNERS\n";
      return std::is_unsigned_v<T> ? "#define HASP_UNSIGNED_CORNERS\n" : "";
    },
    grid);
}

/// A texture on a unit of its own, while one lives. The active unit changes.
class TextureScope
{
public:
  TextureScope(vtkOpenGLRenderWindow* window, GLuint texture)
    : Window(window),
      Unit(window->GetTextureUnitManager()->Allocate())
  {
    if (this->Unit < 0)
      throw std::runtime_error("no texture unit is left");
    this->Bind(texture);
  }
  ~TextureScope()
  {
    this->Bind(0);
    this->Window->GetTextureUnitManager()->Free(this->Unit);
  }
  TextureScope(const TextureScope&) = delete;
  TextureScope& operator=(const TextureScope&) = delete;

  int Number() const { return this->Unit; }
  void Bind(GLuint texture) const
  {
    this->Window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Unit);
    glBindTexture(GL_TEXTURE_3D, texture);
  }

private:
  vtkOpenGLRenderWindow* Window;
  int Unit;
};

/// A point that is well before the eye, and its clip coordinates: the middle of the volume, unless
/// the eye is in or near it.
std::pair<glm::dvec3, glm::dvec4> PointInView(const CellScene& scene, const glm::ivec3& sampleCount)
{
  const glm::dvec3 half = 0.5 * glm::dvec3(sampleCount - 1);
  const glm::dvec4 row = glm::row(scene.indexToClip, 3); // gives w
  const glm::dvec3 slope(row);
  const double reach = glm::dot(glm::abs(slope), half);
  glm::dvec3 point = half;
  const double w = glm::dot(row, glm::dvec4(point, 1.0));
  if (!scene.parallelProjection && w < reach)
    point += slope * ((reach - w) / glm::dot(slope, slope));
  return { point, scene.indexToClip * glm::dvec4(point, 1.0) };
}

} // namespace

void VolumeRaycast::Free(vtkOpenGLRenderWindow* window)
{
  this->Home.Leave(window,
    [this]
    {
      this->Held.Release();
      if (this->VertexArray)
        glDeleteVertexArrays(1, &this->VertexArray);
    });
  this->Held = {};
  this->VertexArray = 0;
}

void VolumeRaycast::MarkModified(const glm::ivec3& low, const glm::ivec3& high)
{
  const bool first = this->ChangedLow.x > this->ChangedHigh.x;
  this->ChangedLow = first ? low : glm::min(this->ChangedLow, low);
  this->ChangedHigh = first ? high : glm::max(this->ChangedHigh, high);
}

/// Brings the textures up to date.
void VolumeRaycast::Update(const RaycastVolume& volume, bool skipping)
{
  if (volume.volumeTime != this->HeldTime)
  {
    this->HeldTime = 0;
    GLint longestSide = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longestSide);
    const hasp::Stopwatch watch;
    this->Held.UploadSamples(volume.grid, longestSide);
    this->SamplesMilliseconds = watch.Milliseconds();
    this->HeldTime = volume.volumeTime;
  }
  else if (this->ChangedLow.x <= this->ChangedHigh.x)
  {
    const hasp::Stopwatch watch;
    this->Held.UpdateSamples(volume.grid, this->ChangedLow, this->ChangedHigh);
    const auto [first, end] = volume.blocks.Touched(this->ChangedLow, this->ChangedHigh);
    this->Held.UpdateBlocks(volume.blocks, first, end - 1);
    this->SamplesMilliseconds += watch.Milliseconds();
  }
  this->ChangedLow = glm::ivec3(0);
  this->ChangedHigh = glm::ivec3(-1);
  if (!skipping)
    this->Held.ReleaseBlocks();
  else if (!this->Held.Blocks())
  {
    const hasp::Stopwatch watch;
    this->Held.UploadBlocks(volume.blocks);
    this->BlocksMilliseconds = watch.Milliseconds();
  }
}

vtkShaderProgram* VolumeRaycast::Ready(vtkOpenGLRenderWindow* window, const RaycastVolume& volume,
  const CellScene& scene, bool skipping, vtkHardwareSelector* selector)
{
  const hasp::Stopwatch watch;
  std::string vertex = vtkHaspVolumeRaycastVS, fragment = vtkHaspVolumeRaycastFS;
  FillSlot(vertex, "CellFrame", CellFrame);
  FillSlot(fragment, "RayRoot", RayRoot);
  FillSlot(fragment, "CellFrame", CellFrame);
  FillSlot(fragment, "SurfaceShading", SurfaceShading);
  FillSlot(fragment, "SelectionColor", SelectionColor);
  const std::string defines = CornerDefines(volume.grid) + scene.Defines() +
                              (skipping ? "#define HASP_SKIPPING\n" : "") +
                              (selector ? "#define HASP_SELECTION\n" : "");
  FillSlot(vertex, "Defines", defines);
  FillSlot(fragment, "Defines", defines);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
    throw std::runtime_error("the shaders did not compile");
  if (this->ShaderMilliseconds == 0.0)
    this->ShaderMilliseconds = watch.Milliseconds();
  return program;
}

void VolumeRaycast::Draw(const RaycastVolume& volume, const RaycastSettings& settings,
  vtkMapper* mapper, vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState::ScopedglActiveTexture unit(window->GetState());
  this->Update(volume, settings.skipping);
  if (this->Held.Parts().empty())
    return;
  const hasp::GridGeometry& geometry = hasp::GeometryOf(volume.grid);
  const CellScene scene(mapper, geometry, volume.isovalue, renderer, actor);
  vtkHardwareSelector* selector = renderer->GetSelector();
  const glm::ivec3 cells = geometry.dims - 1;
  const SelectionScope selection(selector, vtkIdType{ cells.x } * cells.y * cells.z);
  vtkShaderProgram* program = this->Ready(window, volume, scene, settings.skipping, selector);
  scene.SetUniforms(program);
  if (selector)
    SetSelectionUniforms(program, selector);
  const auto [point, clip] = PointInView(scene, geometry.dims);
  const glm::vec3 viewIndex(point);
  const glm::vec4 viewClip(scene.indexToClip * glm::dvec4(glm::dvec3(viewIndex), 1.0));
  program->SetUniform3f("viewIndex", &viewIndex.x);
  program->SetUniform4f("viewClip", &viewClip.x);
  // Flat regions of samples that are the isovalue are inside: no rounding may lift it above them.
  const Normalization normal = NormalizationOf(volume.grid, volume.isovalue);
  program->SetUniformf(
    "threshold", static_cast<float>((double{ scene.isovalue } - normal.rounding) / normal.largest));
  program->SetUniformf("stepSize", static_cast<float>(settings.stepSize));
  const glm::vec3 cellCount(cells);
  program->SetUniform3f("cellCount", &cellCount.x);
  this->DrawParts(window, program);
}

void VolumeRaycast::DrawParts(vtkOpenGLRenderWindow* window, vtkShaderProgram* program)
{
  vtkOpenGLState::ScopedglEnableDisable cull(window->GetState(), GL_CULL_FACE);
  window->GetState()->vtkglDisable(GL_CULL_FACE); // the vertex shader does
  if (this->VertexArray == 0)
    glGenVertexArrays(1, &this->VertexArray);
  const TextureScope filtered(window, 0), corners(window, 0), blocks(window, this->Held.Blocks());
  program->SetUniformi("filtered", filtered.Number());
  program->SetUniformi("corners", corners.Number());
  if (this->Held.Blocks())
    program->SetUniformi("blocks", blocks.Number());
  glBindVertexArray(this->VertexArray);
  for (const VolumeTextures::Part& part : this->Held.Parts()) // depth says which hit is first
  {
    const glm::vec3 low(part.low), high(part.high);
    program->SetUniform3f("boxLow", &low.x);
    program->SetUniform3f("boxHigh", &high.x);
    filtered.Bind(part.filtered);
    corners.Bind(part.exact);
    glDrawArrays(GL_TRIANGLES, 0, 36);
  }
  glBindVertexArray(0);
}
