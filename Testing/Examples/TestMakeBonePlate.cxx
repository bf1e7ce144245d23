#include "ExampleRun.h"

#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"
#include "vtkHaspVolumeView.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

namespace
{

class MakeBonePlate : public ExampleTest
{
protected:
  /// A jaw for the demo's recipe.
  void WriteJaw() const
  {
    hasp::GridGeometry grid;
    grid.spacing = glm::dvec3(1.5);
    grid.origin = { -70, -100, -115 };
    grid.dims = { 95, 67, 40 };
    this->Write("jaw.mha", grid, hasp::SamplePhantom(grid));
  }
};

TEST_F(MakeBonePlate, WrongInputIsAFailureAndLeavesNoFile)
{
  EXPECT_EQ(this->Run("MakeBonePlate"), 1);
  this->WriteJaw();
  EXPECT_EQ(this->Run("MakeBonePlate jaw.mha no.json plate.stl"), 1);
  EXPECT_NE(this->said.find("the file is not there"), std::string::npos) << this->said;
  EXPECT_FALSE(std::filesystem::exists(this->Path("plate.stl")));
}

TEST_F(MakeBonePlate, WritesTheDemosPlateWithItsFiveHoles)
{
  this->WriteJaw();
  ASSERT_EQ(this->Run("MakeBonePlate jaw.mha " HASP_SOURCE "/Data/phantom-plate.json plate.stl"), 0)
    << this->said;
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(this->Path("plate.stl").c_str());
  reader->MergingOff();
  reader->Update();
  const hasp::MeshCheck check =
    hasp::CheckMesh(hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput())));
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1u);
  EXPECT_EQ(1 - (int(check.points) - int(check.triangles / 2)) / 2, 5);
}

} // namespace
