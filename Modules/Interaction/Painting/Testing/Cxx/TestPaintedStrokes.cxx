// Three fragments' seeds painted on a bone of clustered cells by drags, one across a silhouette,
// and the brush over the third.
#include "PaintScene.h"

#include "HaspRenderTest.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspStrokeActor.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// Two balls that touch and one behind them: what stands for a broken bone. mm, positive inside.
double Bone(const glm::dvec3& p)
{
  return std::max(
    { 14.0 - glm::length(p - glm::dvec3(-12, -4, 4)), 12.0 - glm::length(p - glm::dvec3(13, -3, 6)),
      16.0 - glm::length(p - glm::dvec3(2, 14, -18)) });
}

vtkSmartPointer<vtkImageData> BoneImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(60, 60, 60);
  image->SetOrigin(-29.5, -24.5, -37.5);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    double p[3];
    image->GetPoint(n, p);
    values->InsertNextValue(static_cast<float>(Bone({ p[0], p[1], p[2] })));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

} // namespace

int TestPaintedStrokes(int argc, char* argv[])
{
  PaintScene scene;
  scene.window->SetSize(320, 260);
  scene.renderer->SetBackground(0.1, 0.15, 0.2);
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputData(BoneImage());
  mapper->SetIsoValue(0.0);
  mapper->SetRendererToRasterize();
  vtkNew<vtkActor> bone;
  bone->SetMapper(mapper);
  bone->GetProperty()->SetColor(0.89, 0.85, 0.79);
  scene.renderer->AddActor(bone);
  vtkNew<vtkHaspStrokeActor> seeds;
  scene.renderer->AddViewProp(seeds);
  scene.renderer->ResetCamera();
  scene.renderer->GetActiveCamera()->Zoom(1.7);
  scene.painter->SetRadiusMm(1.5);
  scene.Enable();
  std::vector<BrushStroke> all;
  const std::vector<std::vector<glm::ivec2>> drags{ { { 75, 75 }, { 115, 120 }, { 85, 125 } },
    { { 215, 70 }, { 240, 100 }, { 222, 130 }, { 205, 180 } }, { { 140, 190 }, { 180, 205 } } };
  for (std::size_t n = 0; n < drags.size(); ++n)
  {
    scene.painter->SetLabel(static_cast<int>(n) + 2);
    const auto& pieces = scene.Drag(drags[n]);
    all.insert(all.end(), pieces.begin(), pieces.end());
    seeds->SetStrokes(all);
  }
  scene.painter->SetRadiusMm(4.0);
  scene.Hover({ 130, 165 });
  scene.window->Render();
  const int judged = hasp::CheckPicture(scene.window, argc, argv);
  if (all.size() >= 4) // the second one crosses onto what is behind
    return judged;
  std::cerr << all.size() << " pieces\n";
  return 1;
}
