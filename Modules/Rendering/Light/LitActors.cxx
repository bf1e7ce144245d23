#include "LitActors.h"

#include "CellLabels.h"
#include "Grid/Stopwatch.h"
#include "Isosurface/ClusteredCells.h"
#include "LitMeshes.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{

constexpr float Smoothest = 0.03F; // of SurfaceMaterial

glm::vec3 Albedo(const double* color, double share, bool linear)
{
  glm::vec3 albedo;
  for (int c = 0; c < 3; ++c)
  {
    const double v = std::clamp(color[c] * share, 0.0, 1.0);
    albedo[c] = linear ? LinearOf(v) : static_cast<float>(v);
  }
  return albedo;
}

hasp::SurfaceMaterial MaterialOf(vtkProperty* property, bool linear)
{
  hasp::SurfaceMaterial material;
  if (property->GetInterpolation() == VTK_PBR)
  {
    material.albedo = Albedo(property->GetColor(), 1.0, linear);
    material.metallic = static_cast<float>(std::clamp(property->GetMetallic(), 0.0, 1.0));
    material.roughness = std::clamp(static_cast<float>(property->GetRoughness()), Smoothest, 1.0F);
    const double index = property->GetBaseIOR();
    material.specular =
      static_cast<float>(std::clamp(std::pow((index - 1.0) / (index + 1.0), 2.0), 0.0, 1.0));
    return material;
  }
  material.albedo = Albedo(property->GetDiffuseColor(), property->GetDiffuse(), linear);
  // A coat as of plastic where Specular is 0.5; and the roughness whose highlight falls off as
  // Phong's power does: alpha^2 = 2 / (power + 2).
  material.specular = static_cast<float>(0.08 * std::clamp(property->GetSpecular(), 0.0, 1.0));
  material.roughness = std::clamp(
    static_cast<float>(std::pow(2.0 / (std::max(0.0, property->GetSpecularPower()) + 2.0), 0.25)),
    Smoothest, 1.0F);
  return material;
}

} // namespace

LitActors::Entry& LitActors::EntryOf(vtkActor* actor)
{
  for (Entry& entry : this->Entries)
    if (entry.actor == actor)
      return entry;
  Entry& entry = this->Entries.emplace_back();
  entry.actor = actor;
  return entry;
}

/// False: it takes no part.
bool LitActors::UpdateSurface(Entry& entry, vtkActor* actor, bool linear)
{
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  if (!mapper || property->GetRepresentation() != VTK_SURFACE || !property->GetLighting())
    return false;
  if (entry.mapper != mapper)
  {
    entry.mapper = mapper;
    entry.body = {};
    entry.cells = nullptr;
    entry.time = 0;
  }
  const hasp::Stopwatch watch;
  if (auto* isosurface = vtkHaspClusteredCellMapper::SafeDownCast(mapper))
  {
    if (!isosurface->UpdateCells())
      return false;
    const auto cells = isosurface->ShareCells();
    if (cells->Count() == 0 || (!cells->labels.empty() && !isosurface->GetLabels().empty()))
      return false;
    if (entry.body.cells && entry.cells == cells) // edits in place make others, for these are kept
      return true;
    entry.body.cells = std::make_shared<const hasp::CellTracer>(cells);
    entry.cells = cells;
    this->Milliseconds = watch.Milliseconds();
    return true;
  }
  auto* triangles = vtkPolyDataMapper::SafeDownCast(mapper);
  if (!triangles || !triangles->GetInput() ||
      triangles->GetInput()->GetNumberOfPolys() + triangles->GetInput()->GetNumberOfStrips() == 0)
    return false;
  const vtkMTimeType time = std::max(triangles->GetInput()->GetMTime(), mapper->GetMTime());
  const bool smooth = property->GetInterpolation() != VTK_FLAT;
  if (entry.body.mesh && entry.time == time && entry.smooth == smooth)
    return true;
  entry.body.mesh =
    std::make_shared<const hasp::TriangleTracer>(LitMeshOf(triangles, smooth, linear));
  entry.time = time;
  entry.smooth = smooth;
  this->Milliseconds = watch.Milliseconds();
  return true;
}

void LitActors::UpdateMaterial(Entry& entry, vtkActor* actor, bool linear, double glow)
{
  const hasp::SurfaceMaterial material = MaterialOf(actor->GetProperty(), linear);
  if (!entry.body.material || entry.body.material->Material() != material)
    entry.body.material = std::make_shared<const hasp::SurfaceScattering>(material);
  vtkProperty* property = actor->GetProperty();
  entry.body.glow =
    static_cast<float>(glow) * Albedo(property->GetAmbientColor(), property->GetAmbient(), linear);
  entry.body.bodyToWorld = glm::transpose(glm::make_mat4(actor->GetMatrix()->GetData()));
}

void LitActors::Update(vtkPropCollection* props, bool linear, double glow)
{
  if (linear != this->Linear) // colours of meshes are others
    std::erase_if(this->Entries, [](const Entry& entry) { return entry.body.mesh != nullptr; });
  this->Linear = linear;
  this->LastBodies.clear();
  this->LeftOutCount = 0;
  std::erase_if(this->Entries,
    [&](const Entry& entry) { return !entry.actor || props->IsItemPresent(entry.actor) == 0; });
  vtkCollectionSimpleIterator next;
  props->InitTraversal(next);
  while (vtkProp* prop = props->GetNextProp(next))
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    if (!actor || !actor->GetVisibility() || !actor->HasOpaqueGeometry())
      continue;
    Entry& entry = this->EntryOf(actor);
    if (this->UpdateSurface(entry, actor, linear))
    {
      this->UpdateMaterial(entry, actor, linear, glow);
      this->LastBodies.push_back(entry.body);
    }
    else
      ++this->LeftOutCount;
  }
}

std::size_t LitActors::TreeBytes() const
{
  std::size_t bytes = 0;
  for (const Entry& entry : this->Entries)
    bytes += entry.body.cells  ? entry.body.cells->Bytes()
             : entry.body.mesh ? entry.body.mesh->Bytes()
                               : 0;
  return bytes;
}

bool AreSame(const std::vector<hasp::LitBody>& a, const std::vector<hasp::LitBody>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const hasp::LitBody& x, const hasp::LitBody& y)
    {
      return x.cells == y.cells && x.mesh == y.mesh && x.bodyToWorld == y.bodyToWorld &&
             x.material == y.material && x.glow == y.glow;
    });
}
