#pragma once
// A ball, and a small window that it covers in part.
#include "CellTestScene.h"

namespace hasp::testing
{

/// dims^3 samples around the origin; 100 times the signed distance, positive inside.
inline vtkSmartPointer<vtkImageData> Ball(int dims, double spacing, double radius)
{
  GridGeometry g{ glm::ivec3(dims), {}, glm::dvec3(spacing), glm::dmat3(1) };
  g.origin = -0.5 * g.spacing * glm::dvec3(g.dims - 1);
  return MakeImage(g, SampleAnalytic<std::int16_t>(AnalyticSphere({ 0, 0, 0 }, radius), g, 100, 0));
}

/// A ball of radius 8 in the middle of a window of 60 x 60, which it covers in part.
struct BallScene : CellTestScene
{
  BallScene() : CellTestScene(60, 60)
  {
    this->Mapper->SetInputData(Ball(20, 1, 8));
    this->Look({ 0, -40, 0 }, { 0, 0, 0 }, 10, 100);
  }
  bool Shows()
  {
    this->Draw();
    return this->Point(30, 30).has_value();
  }
};

} // namespace hasp::testing
