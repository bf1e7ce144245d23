// The skin: VTK's images in, VTK's meshes out.
#include "vtkHaspFragmentSurface.h"

#include "BrokenBall.h"
#include "Evaluation/MeshCheck.h"
#include "vtkHaspFragmentScan.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

namespace
{

using hasp::testing::BrokenBall;

class FragmentSurface : public ::testing::Test
{
protected:
  FragmentSurface()
    : Ball({ 24, 23, 22 }, { 0.5, 0.6, 0.7 }, hasp::testing::SkewAxes(true), 0, 5.0),
      Scan(hasp::MakeImage(this->Ball.scan.Grid, this->Ball.scan.Samples)),
      Labels(hasp::MakeImage(this->Ball.scan.Grid, this->Ball.scan.Labels))
  {
    this->Filter->SetInputData(this->Scan);
    this->Filter->SetLabelData(this->Labels);
    this->Listen->SetClientData(&this->Said);
    this->Listen->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
      { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Listen);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Listen);
  }
  vtkPolyData* Update()
  {
    this->Said.clear();
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  void ExpectError(const std::string& text)
  {
    EXPECT_EQ(this->Update()->GetNumberOfCells(), 0);
    EXPECT_NE(this->Said.find(text), std::string::npos) << this->Said;
  }

  BrokenBall Ball;
  vtkSmartPointer<vtkImageData> Scan, Labels;
  vtkNew<vtkHaspFragmentSurface> Filter;
  vtkNew<vtkCallbackCommand> Listen;
  std::string Said;
};

TEST_F(FragmentSurface, BadInputsAreErrorsAndGiveNothing)
{
  this->Filter->SetLabel(9);
  this->ExpectError("label 9 is not in the label map, which holds 2, 3");
  this->Filter->SetLabel(2);
  this->Filter->SetSpacing(-0.5);
  this->ExpectError("spacingMm is -0.5");
  this->Filter->SetSpacing(0.0);
  this->Filter->SetIsoValue(32767.5);
  this->ExpectError("label 2: none of its");
  this->Filter->SetIsoValue(226.0);
  this->Labels->SetOrigin(1, 2, 3);
  this->ExpectError("the labels are of another grid than the volume");
  this->Labels->AllocateScalars(VTK_SHORT, 1);
  this->ExpectError("of type short, must be unsigned short");
  this->Filter->SetLabelData(nullptr);
  this->ExpectError("Input port 1");
}

TEST_F(FragmentSurface, EachLabelHasAClosedPart)
{
  vtkPolyData* output = this->Update();
  EXPECT_EQ(this->Said, "");
  const auto* labels =
    vtkUnsignedShortArray::SafeDownCast(output->GetCellData()->GetArray("Label"));
  ASSERT_NE(labels, nullptr);
  ASSERT_EQ(labels->GetNumberOfTuples(), output->GetNumberOfCells());
  const hasp::TriangleMesh mesh = hasp::MakeTriangleMesh(output);
  std::map<int, hasp::TriangleMesh> parts;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    hasp::TriangleMesh& part = parts[labels->GetValue(vtkIdType(t))];
    part.points = mesh.points;
    part.triangles.push_back(mesh.triangles[t]);
  }
  ASSERT_EQ(parts.size(), 2U);
  for (const auto& [label, part] : parts)
  {
    EXPECT_TRUE(hasp::CheckMesh(part).Sound()) << label;
    this->Filter->SetLabel(label);
    EXPECT_EQ(this->Update()->GetNumberOfCells(), vtkIdType(part.triangles.size()));
    for (const glm::dvec3& p : hasp::MakeTriangleMesh(this->Filter->GetOutput()).points)
      ASSERT_LT(this->Ball.Half(label).Bound(p).mm, 0.3);
  }
}

TEST_F(FragmentSurface, ACoarserSpacingGivesFewerTriangles)
{
  const vtkIdType fine = this->Update()->GetNumberOfCells();
  this->Filter->SetSpacing(1.0);
  EXPECT_LT(this->Update()->GetNumberOfCells(), fine / 2);
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfCells(), 100);
}

TEST_F(FragmentSurface, AbortedItGivesNothingAndNoError)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* self, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(self)->AbortExecuteOn(); });
  const unsigned long tag = this->Filter->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(this->Update()->GetNumberOfCells(), 0);
  EXPECT_EQ(this->Said, "");
  this->Filter->RemoveObserver(tag);
  this->Filter->Modified();
  EXPECT_GT(this->Update()->GetNumberOfCells(), 0);
}

// The images may go; what is painted into the array in place is seen.
TEST_F(FragmentSurface, ModelsHoldTheArraysAndNotTheImages)
{
  auto* array = vtkUnsignedShortArray::SafeDownCast(this->Labels->GetPointData()->GetScalars());
  vtkSmartPointer<vtkUnsignedShortArray> held = array;
  hasp::FragmentModels models(hasp::FragmentScanOf(this->Scan, this->Labels, 226.0));
  hasp::FragmentModels ofArray(hasp::FragmentScanOf(this->Scan, held, 226.0));
  this->Filter->SetLabelData(nullptr);
  this->Filter->SetInputData(nullptr);
  this->Scan = nullptr;
  this->Labels = nullptr;
  EXPECT_EQ(models.Surface(2)->points, ofArray.Surface(2)->points);
  for (vtkIdType n = 0; n < held->GetNumberOfTuples(); ++n)
    if (held->GetValue(n) == 3)
      held->SetValue(n, 6);
  EXPECT_EQ(
    models.LabelsChanged(glm::ivec3(0), glm::ivec3(100)), (std::vector<std::uint16_t>{ 3, 6 }));
  ofArray.LabelsChanged(glm::ivec3(0), glm::ivec3(100));
  EXPECT_EQ(models.Surface(6)->points, ofArray.Surface(6)->points) << "the same array";
  EXPECT_THROW(hasp::FragmentScanOf(nullptr, held, 226.0), std::invalid_argument);
}

} // namespace
