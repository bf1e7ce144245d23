#include "View/SceneActor.h"

#include "View/SceneView.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

namespace hasp
{
namespace
{

constexpr double Specular = 0.2, SpecularPower = 20.0;
constexpr double Glow = 0.28; ///< of what is selected
const glm::dvec3 GlowColour{ 1.0, 0.72, 0.10 };

glm::dmat4 DataToWorld(vtkActor* actor)
{
  vtkNew<vtkMatrix4x4> rows;
  actor->GetMatrix(rows);
  glm::dmat4 matrix;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      matrix[c][r] = rows->GetElement(r, c);
  return matrix;
}

} // namespace

glm::dvec3 Mixed(const glm::dvec3& colour, const glm::dvec3& other, double share)
{
  return (1.0 - share) * colour + share * other;
}

SceneActor::SceneActor(SceneView& view) : In(view)
{
  this->Shown->GetProperty()->SetSpecular(Specular);
  this->Shown->GetProperty()->SetSpecularPower(SpecularPower);
  this->In.Renderer()->AddViewProp(this->Shown);
}

SceneActor::~SceneActor()
{
  this->Release();
  this->In.Renderer()->RemoveViewProp(this->Shown);
}

void SceneActor::MakeCurrent() const
{
  this->In.Renderer()->GetRenderWindow()->MakeCurrent();
}

void SceneActor::Release()
{
  if (!this->Shown->GetMapper())
    return;
  this->MakeCurrent();
  this->Shown->ReleaseGraphicsResources(this->In.Renderer()->GetRenderWindow());
}

void SceneActor::SetMapper(vtkMapper* mapper)
{
  if (mapper == this->Shown->GetMapper())
    return;
  this->Release();
  this->Shown->SetMapper(mapper);
}

bool SceneActor::IsVisible() const
{
  return this->Shown->GetVisibility();
}

void SceneActor::SetVisible(bool visible)
{
  if (visible == this->IsVisible())
    return;
  this->Shown->SetVisibility(visible);
  if (!visible)
    this->Release();
}

void SceneActor::SetLook(const SceneLook& look)
{
  vtkProperty* property = this->Shown->GetProperty();
  property->SetColor(look.colour.x, look.colour.y, look.colour.z);
  property->SetAmbientColor(GlowColour.x, GlowColour.y, GlowColour.z);
  property->SetAmbient(look.selected ? Glow : 0.0);
  property->SetOpacity(look.opacity);
}

void SceneActor::SetPose(const PlanPose& pose)
{
  if (pose == this->Posed)
    return;
  this->Posed = pose;
  const glm::dmat3 turn = glm::mat3_cast(pose.orientation);
  vtkNew<vtkMatrix4x4> matrix;
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
      matrix->SetElement(r, c, turn[c][r]);
    matrix->SetElement(r, 3, pose.position[r]);
  }
  this->Shown->SetUserMatrix(matrix);
}

void SceneActor::Pick(PlanId object, const SceneRay& ray, std::optional<SceneHit>& nearest) const
{
  if (!this->IsVisible())
    return;
  const glm::dmat4 toWorld = DataToWorld(this->Shown), toData = glm::inverse(toWorld);
  const glm::dvec3 from(toData * glm::dvec4(ray.from, 1.0)), to(toData * glm::dvec4(ray.to, 1.0));
  const auto hit = this->First(from, to);
  if (!hit || (nearest && nearest->t <= hit->t))
    return;
  glm::dvec3 normal =
    glm::normalize(glm::dmat3(glm::inverseTranspose(glm::dmat3(toWorld))) * hit->normal);
  if (glm::dot(normal, ray.to - ray.from) > 0.0)
    normal = -normal;
  nearest = { object, hit->t, ray.from + hit->t * (ray.to - ray.from), from + hit->t * (to - from),
    normal };
}

void SceneActor::AddBounds(vtkBoundingBox& box) const
{
  double data[6];
  if (!this->IsVisible() || !this->DataBounds(data))
    return;
  const glm::dmat4 toWorld = DataToWorld(this->Shown);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec4 at(
      data[corner & 1], data[2 + (corner >> 1 & 1)], data[4 + (corner >> 2 & 1)], 1.0);
    const glm::dvec3 world(toWorld * at);
    box.AddPoint(world.x, world.y, world.z);
  }
}

void SceneActor::ListResourcesAs(const std::string& called, ResourceList& list) const
{
  ResourceList own;
  this->ListResources(own);
  for (ResourceUse& use : own)
  {
    use.resource = called + ", " + use.resource;
    list.push_back(std::move(use));
  }
}

} // namespace hasp
