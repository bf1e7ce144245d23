#pragma once
// A window with one pointshell, and what its pixels show: depth as points in the world.
#include "Haptics/ShellDisc.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspPointShellMapper.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace hasp::testing
{

/// On a spiral from pole to pole: even per area, each disc with its share.
inline std::shared_ptr<std::vector<ShellDisc>> SphereDiscs(
  int count, double radius, const glm::dvec3& center = glm::dvec3(0.0))
{
  auto discs = std::make_shared<std::vector<ShellDisc>>();
  for (int n = 0; n < count; ++n)
  {
    const double z = 1.0 - 2.0 * (n + 0.5) / count, ring = std::sqrt(1.0 - z * z);
    const double turn = 2.0 * std::numbers::pi * n / std::numbers::phi;
    const glm::dvec3 normal(ring * std::cos(turn), ring * std::sin(turn), z);
    discs->push_back({ center + radius * normal,
      static_cast<float>(4.0 * std::numbers::pi * radius * radius / count), normal, 0 });
  }
  return discs;
}

/// A square in the plane z = 0 around the origin, one disc a mm^2.
inline std::shared_ptr<std::vector<ShellDisc>> PlaneDiscs(int side)
{
  auto discs = std::make_shared<std::vector<ShellDisc>>();
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      discs->push_back({ glm::vec3(x + 0.5F, y + 0.5F, 0) - glm::vec3(0.5F * side, 0.5F * side, 0),
        1.0F, { 0, 0, 1 }, 0 });
  return discs;
}

/// One pixel: the ray through its centre, from the near plane on, and what was drawn.
struct Pixel
{
  glm::dvec3 from, direction; ///< unit
  std::optional<glm::dvec3> hit;
  double mm; ///< size of the pixel at the hit, or at the focal point

  /// The nearest of the ray's two points on a sphere.
  std::optional<glm::dvec3> OnSphere(double radius) const
  {
    const double along = -glm::dot(this->from, this->direction);
    const glm::dvec3 nearest = this->from + along * this->direction;
    const double rest = radius * radius - glm::dot(nearest, nearest);
    if (rest < 0.0)
      return {};
    return nearest - std::sqrt(rest) * this->direction;
  }
  /// How close the ray comes to the origin.
  double Miss() const
  {
    return glm::length(this->from - glm::dot(this->from, this->direction) * this->direction);
  }
};

struct DiscScene
{
  const bool Headless = hasp::UseHeadlessWindows(); // before the first window
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkHaspPointShellMapper> Mapper;
  vtkNew<vtkActor> Actor;
  std::vector<std::string> Errors; ///< of the mapper
  int Size;

  explicit DiscScene(int size = 200) : Size(size)
  {
    this->Window->SetSize(size, size);
    this->Window->SetMultiSamples(0);
    this->Window->AddRenderer(this->Renderer);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Hear(this->Mapper);
    this->Look({ 0, 0, 100 });
  }

  void Hear(vtkObject* from)
  {
    vtkNew<vtkCallbackCommand> hear;
    hear->SetClientData(&this->Errors);
    hear->SetCallback(
      [](vtkObject*, unsigned long, void* all, void* text) {
        static_cast<std::vector<std::string>*>(all)->emplace_back(static_cast<const char*>(text));
      });
    from->AddObserver(vtkCommand::ErrorEvent, hear);
  }

  void Look(const glm::dvec3& eye, const glm::dvec3& up = { 0, 1, 0 })
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(up.x, up.y, up.z);
    camera->SetClippingRange(0.5 * glm::length(eye), 1.5 * glm::length(eye));
  }

  std::vector<Pixel> Draw()
  {
    this->Window->Render();
    vtkNew<vtkFloatArray> depth;
    this->Window->GetZbufferData(0, 0, this->Size - 1, this->Size - 1, depth);
    vtkMatrix4x4* matrix =
      this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0);
    const glm::dmat4 toWorld = glm::inverse(glm::transpose(glm::make_mat4(matrix->GetData())));
    const auto world = [&](double x, double y, double z)
    {
      const glm::dvec4 point = toWorld * glm::dvec4(x, y, z, 1.0);
      return glm::dvec3(point) / point.w;
    };
    std::vector<Pixel> pixels;
    for (int row = 0; row < this->Size; ++row)
      for (int column = 0; column < this->Size; ++column)
      {
        const double x = 2.0 * (column + 0.5) / this->Size - 1.0;
        const double y = 2.0 * (row + 0.5) / this->Size - 1.0;
        const double z = 2.0 * depth->GetValue(row * this->Size + column) - 1.0;
        const glm::dvec3 from = world(x, y, -1.0);
        Pixel pixel{ from, glm::normalize(world(x, y, 1.0) - from), {}, 0.0 };
        if (z < 1.0)
          pixel.hit = world(x, y, z);
        const double w = z < 1.0 ? z : 0.0;
        pixel.mm = glm::distance(world(x, y, w), world(x + 2.0 / this->Size, y, w));
        pixels.push_back(pixel);
      }
    return pixels;
  }

  /// Of the whole window.
  std::vector<glm::ivec3> Colors()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> rgb;
    this->Window->GetPixelData(0, 0, this->Size - 1, this->Size - 1, 1, rgb);
    std::vector<glm::ivec3> colors;
    for (vtkIdType n = 0; n < rgb->GetNumberOfTuples(); ++n)
      colors.emplace_back(
        rgb->GetComponent(n, 0), rgb->GetComponent(n, 1), rgb->GetComponent(n, 2));
    return colors;
  }

  /// The normal that each pixel was shaded with, read from the light of three axes; 0 if black.
  std::vector<glm::dvec3> Normals()
  {
    this->Actor->GetProperty()->SetColor(1, 1, 1);
    this->Actor->GetProperty()->SetAmbient(0);
    this->Actor->GetProperty()->SetDiffuse(1);
    this->Renderer->SetBackground(0, 0, 0);
    this->Renderer->AutomaticLightCreationOff();
    std::vector<glm::dvec3> normals(this->Size * this->Size, glm::dvec3(0.0));
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Renderer->RemoveAllLights();
      for (int side = 0; side < 2; ++side)
      {
        glm::dvec3 from(0.0);
        from[axis] = side == 0 ? 1.0 : -1.0;
        vtkNew<vtkLight> light;
        light->SetLightTypeToSceneLight();
        light->SetPosition(from.x, from.y, from.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetColor(side == 0, side == 1, 0);
        this->Renderer->AddLight(light);
      }
      const std::vector<glm::ivec3> colors = this->Colors();
      for (std::size_t n = 0; n < colors.size(); ++n)
        normals[n][axis] = (colors[n].x - colors[n].y) / 255.0;
    }
    return normals;
  }
};

} // namespace hasp::testing
