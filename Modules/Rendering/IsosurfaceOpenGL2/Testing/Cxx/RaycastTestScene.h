#pragma once
// An isosurface by a ray a pixel, and each pixel held against a ray in long double.
#include "CellTestScene.h"
#include "Evaluation/TrilinearTruth.h"
#include "HaspGL.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkCallbackCommand.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace hasp::testing
{

constexpr int RaycastModes[] = { vtkHaspRayCachingMapper::Raycast,
  vtkHaspRayCachingMapper::RaycastSkipping };

inline ResourceUse Find(vtkHaspRayCachingMapper* mapper, const std::string& name)
{
  ResourceList list;
  mapper->ListResources(list);
  for (const auto& use : list)
    if (use.resource == name)
      return use;
  ADD_FAILURE() << "no resource " << name;
  return {};
}

/// How many buffers, textures and vertex arrays there are in the window's context.
inline std::array<int, 3> Names(vtkRenderWindow* window)
{
  window->MakeCurrent();
  std::array<int, 3> count{};
  for (GLuint name = 1; name < 1000; ++name)
  {
    count[0] += glIsBuffer(name);
    count[1] += glIsTexture(name);
    count[2] += glIsVertexArray(name);
  }
  return count;
}

/// What a picture shows against what is true.
struct Judgement
{
  int surface = 0;    ///< pixels whose ray meets a surface
  int missed = 0;     ///< of these, where the picture shows none, or one that lies farther
  int invented = 0;   ///< where the picture shows one that is not there, or lies nearer
  double error = 0.0; ///< largest distance along the ray elsewhere, where it does not graze; voxels
};

struct RaycastScene : CellTestScene
{
  static constexpr int PixelsX = 160, PixelsY = 120;
  vtkNew<vtkHaspRayCachingMapper> Raycaster;
  std::vector<std::string> Errors; ///< what the mapper said

  RaycastScene() : CellTestScene(PixelsX, PixelsY)
  {
    this->Raycaster->SetIsoValue(0.0);
    this->Raycaster->SetModeToRaycast();
    this->Actor->SetMapper(this->Raycaster);
    vtkNew<vtkCallbackCommand> hear;
    hear->SetClientData(this);
    hear->SetCallback([](vtkObject*, unsigned long, void* scene, void* text)
      { static_cast<RaycastScene*>(scene)->Errors.emplace_back(static_cast<const char*>(text)); });
    this->Raycaster->AddObserver(vtkCommand::ErrorEvent, hear);
    this->Look({ 60, -80, 40 }, { 0, 0, 0 }, 20, 200);
  }

  template <typename T>
  void Show(const AnalyticVolume& shape, const GridGeometry& geometry, double scale = 100,
    double offset = 0)
  {
    this->Raycaster->SetInputData(
      MakeImage(geometry, SampleAnalytic<T>(shape, geometry, scale, offset)));
    this->Raycaster->SetIsoValue(offset);
  }

  bool Shows(int x = PixelsX / 2, int y = PixelsY / 2)
  {
    this->Draw();
    return this->Point(x, y).has_value();
  }

  std::vector<std::optional<glm::dvec3>> Points()
  {
    this->Draw();
    std::vector<std::optional<glm::dvec3>> points;
    for (int pixel = 0; pixel < PixelsX * PixelsY; ++pixel)
      points.push_back(this->Point(pixel % PixelsX, pixel / PixelsX));
    return points;
  }

  std::vector<unsigned char> Colors()
  {
    this->Draw();
    vtkNew<vtkUnsignedCharArray> rgb;
    this->Window->GetPixelData(0, 0, PixelsX - 1, PixelsY - 1, 0, rgb);
    return { rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues() };
  }

  /// What the rays of all pixels meet first; they start on the near plane, or so far along as
  /// `start` says, in mm. The camera must have been drawn with.
  std::vector<std::optional<TrilinearHit>> Truth(
    const std::function<double(const glm::dvec3&, const glm::dvec3&)>& start = {}) const
  {
    const AnyGridView grid = ViewImage(this->Raycaster->GetImage());
    std::vector<std::optional<TrilinearHit>> truth;
    for (int pixel = 0; pixel < PixelsX * PixelsY; ++pixel)
    {
      const auto [nearest, direction] = this->Ray(pixel % PixelsX, pixel / PixelsX);
      const glm::dvec3 origin = nearest + (start ? start(nearest, direction) : 0.0) * direction;
      truth.push_back(FirstTrilinearHit(grid, this->Raycaster->GetIsoValue(), origin, direction));
    }
    return truth;
  }

  Judgement Judge(const std::vector<std::optional<TrilinearHit>>& truth) const
  {
    const GridGeometry g = GeometryOf(ViewImage(this->Raycaster->GetImage()));
    const auto inVoxels = [&](const glm::dvec3& way)
    { return glm::transpose(g.direction) * way / g.spacing; };
    Judgement result;
    for (int pixel = 0; pixel < PixelsX * PixelsY; ++pixel)
    {
      const auto& met = truth[pixel];
      const int x = pixel % PixelsX, y = pixel / PixelsX;
      const auto shown = this->Point(x, y);
      result.surface += met.has_value();
      if (!met && !shown)
        continue;
      const glm::dvec3 direction = glm::normalize(inVoxels(this->Ray(x, y).second));
      double behind = shown ? -1e9 : 1e9;
      if (met && shown)
        behind = glm::dot(inVoxels(*shown - met->position), direction);
      const bool grazes =
        met &&
        std::abs(glm::dot(glm::normalize(g.spacing * (glm::transpose(g.direction) * met->gradient)),
          direction)) < 0.1;
      // Where a ray grazes, root and rounding are far apart; a fiftieth voxel is another root.
      if (std::abs(behind) > 0.02)
        ++(behind > 0.0 ? result.missed : result.invented);
      else if (!grazes)
        result.error = std::max(result.error, std::abs(behind));
    }
    return result;
  }
};

/// A ball in the middle of the window, drawn in one of the mapper's modes.
struct RaycastBall : RaycastScene
{
  explicit RaycastBall(int mode)
  {
    this->Raycaster->SetMode(mode);
    this->Show<std::int16_t>(AnalyticSphere({ 0, 0, 0 }, 15), ObliqueGrid(40, { 1, 1, 1 }));
  }
  int FramesToRest(int most = 300)
  {
    int frame = 0;
    do
      this->Window->Render();
    while (++frame < most && this->Raycaster->IsRefining());
    return frame;
  }
  int SurfacePixels()
  {
    int count = 0;
    for (const auto& point : this->Points())
      count += point.has_value();
    return count;
  }
};

} // namespace hasp::testing
