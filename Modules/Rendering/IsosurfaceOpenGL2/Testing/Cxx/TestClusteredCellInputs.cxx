// Cells that somebody else made are drawn as the image's are, and the mapper changes between both.
#include "AttributeTestScene.h"
#include "Isosurface/CompactCells.h"
#include "vtkHaspClusteredCells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <vector>

namespace
{

using hasp::testing::CellTestScene;

class CellInputs : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }

  CellInputs() : Scene(60, 60)
  {
    const hasp::GridGeometry g = hasp::testing::ObliqueGrid(30, { 1.0, 0.8, 1.3 });
    this->Image = hasp::MakeImage(
      g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 9.0), g, 100, 0));
    this->Scene.Mapper->SetInputData(this->Image);
    this->Scene.Look({ 0, -40, 0 }, { 0, 0, 0 }, 10, 100);
  }
  using Points = std::vector<glm::dvec3>;
  /// What each pixel shows; the origin where nothing is.
  Points Draw()
  {
    this->Scene.Draw();
    Points points;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 60; ++x)
        points.push_back(this->Scene.Point(x, y).value_or(glm::dvec3(0)));
    return points;
  }

  vtkSmartPointer<vtkImageData> Image;
  CellTestScene Scene;
  vtkNew<vtkHaspClusteredCells> Cells;
};

TEST_F(CellInputs, AreDrawnAsTheImageIs)
{
  const Points truth = this->Draw();
  double bounds[6];
  this->Scene.Mapper->GetBounds(bounds);
  ASSERT_GT(std::count_if(
              truth.begin(), truth.end(), [](const glm::dvec3& at) { return at != glm::dvec3(0); }),
    500);
  this->Cells->SetCells(std::make_shared<hasp::ClusteredCells>(this->Scene.Mapper->GetCells()));
  this->Scene.Mapper->SetInputDataObject(this->Cells);
  this->Scene.Mapper->SetIsoValue(12345.0); // the cells have their own
  EXPECT_EQ(this->Draw(), truth);
  EXPECT_EQ(&this->Scene.Mapper->GetCells(), this->Cells->GetCells().get()) << "no copy";
  EXPECT_EQ(this->Scene.Mapper->GetImage(), nullptr);
  std::ostringstream text;
  this->Scene.Mapper->Print(text);
  EXPECT_NE(text.str().find("IsoValue: 0 (the input's own)"), std::string::npos) << text.str();
  for (int n = 0; n < 6; ++n)
    EXPECT_NEAR(this->Scene.Mapper->GetBounds()[n], bounds[n], 1e-9); // mm: sums in another order
  int ijk[3];
  EXPECT_TRUE(this->Scene.Mapper->GetCellIndex(0, ijk));
}

TEST_F(CellInputs, KeepTheirLabelsTranslucentOnesToo)
{
  hasp::testing::AttributeScene scene;
  scene.Mapper->SetLabelArrayName("label");
  scene.Draw();
  this->Cells->SetCells(std::make_shared<hasp::ClusteredCells>(scene.Mapper->GetCells()));
  scene.Mapper->SetLabelArrayName(nullptr);
  scene.Mapper->SetInputDataObject(this->Cells);
  scene.Mapper->SetLabelColor(1, 1, 0, 0);
  scene.Mapper->SetLabelColor(2, 0, 1, 0, 0.5);
  EXPECT_EQ(scene.ColorAt({ -7, -13, 0 }), (std::array<int, 3>{ 255, 0, 0 }));
  EXPECT_NEAR(scene.ColorAt({ 7, -13, 0 })[1], 191, 3); // two layers of half: 1 - 1/4
  scene.Mapper->SetInputData(this->Image);              // has no labels
  EXPECT_FALSE(scene.Actor->HasTranslucentPolygonalGeometry());
}

TEST_F(CellInputs, ComeGoAndChange)
{
  const Points truth = this->Draw();
  const auto exact = std::make_shared<hasp::ClusteredCells>(this->Scene.Mapper->GetCells());
  this->Scene.Mapper->SetInputDataObject(this->Cells); // none yet
  EXPECT_EQ(this->Draw(), Points(3600));
  this->Cells->SetCells(exact);
  EXPECT_EQ(this->Draw(), truth);
  this->Cells->SetCells(std::make_shared<hasp::ClusteredCells>(hasp::CompactCells(*exact)));
  const Points compact = this->Draw();
  EXPECT_NE(compact, truth);
  for (std::size_t n = 0; n < truth.size(); ++n)
    if (compact[n] != glm::dvec3(0) && truth[n] != glm::dvec3(0))
    {
      // Off the ball's surface by 0.0135 voxel of 1.3 mm along an edge; both by what a trilinear
      // cell is off a sphere besides, 1.3^2 / (8 * 9) mm.
      EXPECT_NEAR(glm::length(compact[n]), glm::length(truth[n]), 0.018 + 2 * 0.024) << n;
    }
  this->Scene.Mapper->SetInputData(this->Image);
  EXPECT_EQ(this->Draw(), truth);
  EXPECT_NE(&this->Scene.Mapper->GetCells(), this->Cells->GetCells().get());
  this->Cells->SetCells(nullptr);
  this->Scene.Mapper->SetInputDataObject(this->Cells);
  EXPECT_EQ(this->Draw(), Points(3600));
}

} // namespace
