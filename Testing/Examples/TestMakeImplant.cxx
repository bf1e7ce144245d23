#include "ExampleRun.h"

#include "Evaluation/MeshCheck.h"
#include "Grid/Phantom.h"
#include "vtkHaspVolumeView.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

namespace
{

class MakeImplant : public ExampleTest
{
protected:
  void WriteHead() const
  {
    const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(2.0));
    this->Write("head.mha", grid, hasp::SamplePhantom(grid));
  }
};

TEST_F(MakeImplant, WrongInputIsAFailureAndLeavesNoFile)
{
  EXPECT_EQ(this->Run("MakeImplant"), 1);
  this->WriteHead();
  EXPECT_EQ(this->Run("MakeImplant head.mha no.json implant.stl"), 1);
  EXPECT_NE(this->said.find("the file is not there"), std::string::npos) << this->said;
  EXPECT_FALSE(std::filesystem::exists(this->Path("implant.stl")));
}

TEST_F(MakeImplant, WritesASoundMeshOfTheRecipeInData)
{
  this->WriteHead();
  ASSERT_EQ(
    this->Run("MakeImplant head.mha " HASP_SOURCE "/Data/phantom-implant.json implant.stl"), 0)
    << this->said;
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(this->Path("implant.stl").c_str());
  reader->MergingOff();
  reader->Update();
  const hasp::MeshCheck check =
    hasp::CheckMesh(hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput())));
  EXPECT_TRUE(check.Sound());
  EXPECT_EQ(check.pieces, 1u);
}

} // namespace
