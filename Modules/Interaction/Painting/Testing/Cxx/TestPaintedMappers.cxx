// One ball, drawn by different mappers: the same stroke.
#include "PaintScene.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double R = 20.0, SpacingMm = 1.0;

/// Samples of R - r: the isosurface of 0 is the ball, less the trilinear sag of spacing^2 / 8R and
/// what its corners add.
vtkSmartPointer<vtkImageData> GreyBall()
{
  constexpr int side = 49;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  image->SetOrigin(-24, -24, -24);
  image->SetSpacing(SpacingMm, SpacingMm, SpacingMm);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType n = 0; n < side * side * side; ++n)
  {
    double p[3];
    image->GetPoint(n, p);
    values->InsertNextValue(static_cast<float>(R - std::hypot(p[0], p[1], p[2])));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

struct Painted
{
  std::vector<BrushStroke> pieces;
  std::vector<glm::dvec3> places; ///< of some pixels about it
  double pixelMm = 0.0;
};

Painted PaintOn(const vtkSmartPointer<vtkActor>& actor)
{
  PaintScene scene;
  scene.renderer->AddActor(actor);
  scene.Enable();
  Painted painted{ scene.Drag({ { 75, 90 }, { 130, 105 } }), {}, scene.PixelMm(Distance - R) };
  for (int y = 60; y <= 140; y += 8)
    for (int x = 60; x <= 140; x += 8)
    {
      double at[3] = {};
      EXPECT_TRUE(scene.painter->GetPlace(x, y, at));
      painted.places.push_back({ at[0], at[1], at[2] });
    }
  return painted;
}

/// The largest distance of a point of one from the line of the other.
double Apart(const BrushStroke& one, const BrushStroke& other)
{
  double most = 0.0;
  for (const glm::dvec3& point : one.points)
  {
    double least = 1e9;
    for (std::size_t n = 1; n < other.points.size(); ++n)
    {
      const glm::dvec3 from = other.points[n - 1], along = other.points[n] - from;
      const double share =
        glm::clamp(glm::dot(point - from, along) / glm::dot(along, along), 0., 1.);
      least = std::min(least, glm::length(point - from - share * along));
    }
    most = std::max(most, least);
  }
  return most;
}

template <class Mapper>
vtkSmartPointer<vtkActor> IsosurfaceActor(void (*setUp)(Mapper*))
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(GreyBall());
  mapper->SetIsoValue(0.0);
  setUp(mapper);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void ExpectSame(const vtkSmartPointer<vtkActor>& isosurface)
{
  const Painted mesh = PaintOn(BallActor(R)), cells = PaintOn(isosurface);
  // Sag of the trilinear surface, up to 0.02 mm along the view here, and the mesh's facets.
  for (std::size_t n = 0; n < mesh.places.size(); ++n)
    EXPECT_LT(glm::length(mesh.places[n] - cells.places[n]), 0.03);
  ASSERT_EQ(mesh.pieces.size(), 1u);
  ASSERT_EQ(cells.pieces.size(), 1u);
  const BrushStroke &one = mesh.pieces[0], &other = cells.pieces[0];
  EXPECT_LT(glm::length(one.points.front() - other.points.front()), 0.03);
  EXPECT_LT(glm::length(one.points.back() - other.points.back()), 0.03);
  // Points are middles of pixels, and which ones depends on the last bits: lines a pixel apart.
  EXPECT_LT(Apart(one, other), mesh.pixelMm);
  EXPECT_LT(Apart(other, one), mesh.pixelMm);
}

TEST(PaintedMappers, ClusteredCellsGiveTheStrokeThatAMeshDoes)
{
  ExpectSame(IsosurfaceActor<vtkHaspClusteredCellMapper>(
    [](vtkHaspClusteredCellMapper* mapper) { mapper->SetRendererToRasterize(); }));
}

TEST(PaintedMappers, CellsOfAnyRendererGiveTheStrokeThatAMeshDoes)
{
  ExpectSame(IsosurfaceActor<vtkHaspClusteredCellMapper>(
    [](vtkHaspClusteredCellMapper* mapper) { mapper->SetRendererToAutomatic(); }));
}

TEST(PaintedMappers, RayCachingGivesTheStrokeThatAMeshDoes)
{
  ExpectSame(IsosurfaceActor<vtkHaspRayCachingMapper>([](vtkHaspRayCachingMapper*) {}));
}

} // namespace
