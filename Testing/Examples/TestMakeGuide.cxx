#include "ExampleRun.h"

#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"
#include "vtkHaspVolumeView.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

#include <glm/geometric.hpp>

#include <fstream>

namespace
{

class MakeGuide : public ExampleTest
{
protected:
  /// A coarse head, and a recipe for a band over its left frontal bone.
  void WriteHeadAndRecipe() const
  {
    const hasp::PhantomSettings settings;
    const hasp::GridGeometry grid = hasp::PhantomGrid({ 2.0, 2.0, 2.5 }, settings);
    this->Write("head.mha", grid, hasp::SamplePhantom(grid, settings));
    std::ofstream recipe(this->Path("recipe.json"));
    glm::dvec3 outward(0.0);
    recipe << R"({ "format": "hasp-guide-recipe-1", "isovalue": 226, "outline": "open",
      "gapMm": 0.4, "thicknessMm": 3, "widthMm": 14, "spacingMm": 0.8, "ignoreBelowMm3": 100,
      "slots": [], "holes": [], "landmarks": [)";
    for (const double left : { 0.25, 0.40, 0.55 })
    {
      const glm::dvec3 direction = glm::normalize(glm::dvec3(left, -1.0, 0.6));
      const glm::dvec3 p = hasp::PhantomOuterTable(settings, direction);
      recipe << (left > 0.25 ? ", [" : "[") << p.x << "," << p.y << "," << p.z << "]";
      outward += direction;
    }
    outward = glm::normalize(outward);
    recipe << "], \"withdrawal\": [" << outward.x << "," << outward.y << "," << outward.z << "] }";
  }
};

TEST_F(MakeGuide, WrongInputIsAFailureAndLeavesNoFile)
{
  EXPECT_EQ(this->Run("MakeGuide"), 1);
  this->WriteHeadAndRecipe();
  EXPECT_EQ(this->Run("MakeGuide head.mha no.json guide.stl"), 1);
  EXPECT_NE(this->said.find("the file is not there"), std::string::npos) << this->said;
  EXPECT_EQ(this->Run("MakeGuide no.mha recipe.json guide.stl"), 1);
  EXPECT_FALSE(std::filesystem::exists(this->Path("guide.stl")));
}

TEST_F(MakeGuide, WritesASoundMesh)
{
  this->WriteHeadAndRecipe();
  ASSERT_EQ(this->Run("MakeGuide head.mha recipe.json guide.stl"), 0) << this->said;
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(this->Path("guide.stl").c_str());
  reader->MergingOff();
  reader->Update();
  const hasp::MeshCheck check =
    hasp::CheckMesh(hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput())));
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1u);
}

} // namespace
