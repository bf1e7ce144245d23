#pragma once
// What the pictures of all modes show: a gyroid of bone and a ball of titanium over a matt floor.
#include "HaspRenderTest.h"
#include "LightTestScene.h"

#include <algorithm>

namespace hasp::testing
{

inline int DrawLightPicture(int mode, int frames, int argc, char* argv[])
{
  LightTestScene scene(400, 300);
  const GridGeometry g{ glm::ivec3(44), glm::dvec3(-21.5), glm::dvec3(1), glm::dmat3(1) };
  const auto gyroid = AnalyticGyroid(14);
  const AnalyticVolume block{ "block", [&](const glm::dvec3& p)
    {
      return std::min(
        gyroid.value(p) * 3.0, 18.0 - std::max({ std::abs(p.x), std::abs(p.y), std::abs(p.z) }));
    } };
  const auto image = MakeImage(g, SampleAnalytic<std::int16_t>(block, g, 100, 0));
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetIsoValue(0.0);
  mapper->SetRendererToTrace();
  scene.Add(mapper, { -16, 0, 0 })->GetProperty()->SetColor(0.93, 0.87, 0.76);
  vtkProperty* metal = scene.AddMeshBall(16, { 24, -4, -2 })->GetProperty();
  metal->SetColor(0.85, 0.85, 0.88);
  metal->SetInterpolationToPBR();
  metal->SetMetallic(1.0);
  metal->SetRoughness(0.35);
  scene.AddFloor(90, -18, 0.7);
  scene.AddLamp({ -80, -90, 120 });
  scene.Look({ 30, -130, 80 }, { 2, 0, -6 });
  scene.Pass->SetMode(mode);
  scene.Pass->SetSamplesPerPixel(64);
  scene.Pass->WaitForSamplesOn();
  scene.Pass->TemporalAccumulationOff();
  for (int frame = 0; frame < frames; ++frame)
    scene.Window->Render();
  return CheckPicture(scene.Window, argc, argv);
}

} // namespace hasp::testing
