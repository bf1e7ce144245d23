#include "CutFixture.h"
#include "FilterFixture.h"
#include "FragmentCutter.h"
#include "vtkHaspOsteotomyFilter.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <string>

using namespace cuttest;

namespace
{

class OsteotomyFilter : public testing::Test
{
protected:
  OsteotomyFilter()
  {
    parttest::KeepWords(this->filter, this->error);
    this->filter->SetInputData(hasp::MakeImage(this->scan.grid, this->scan.samples));
    this->filter->SetRecipe(OneCut({ 5.0, 0.0, 0.0 }));
  }
  vtkImageData* Labels()
  {
    return vtkImageData::SafeDownCast(this->filter->GetOutputDataObject(1));
  }
  double Measure(const char* name, int n)
  {
    return this->filter->GetOutput()->GetFieldData()->GetArray(name)->GetComponent(n, 0);
  }

  BoneScan scan = ScanOfBar();
  vtkNew<vtkHaspOsteotomyFilter> filter;
  std::string error;
};

TEST_F(OsteotomyFilter, AnErrorIsReportedAndLeavesNothing)
{
  this->filter->Update();
  ASSERT_GT(this->filter->GetOutput()->GetNumberOfCells(), 0);
  this->filter->SetRecipe(OneCut({ 5.0, 90.0, 0.0 }));
  this->filter->Update();
  EXPECT_NE(this->error.find("cuts[0] does not meet bone"), std::string::npos) << this->error;
  EXPECT_EQ(this->filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_TRUE(this->filter->GetResult().fragments.empty());
  this->error.clear();
  EXPECT_FALSE(this->filter->ReadRecipe("/nowhere/cuts.json"));
  EXPECT_NE(this->error, "");
  EXPECT_EQ(this->error.find("nowhere"), std::string::npos);
}

TEST_F(OsteotomyFilter, MeshesAndMeasuresAreTheKernels)
{
  this->filter->Update();
  ASSERT_EQ(this->error, "");
  const hasp::CutBone cut =
    hasp::CutFragments({ this->scan.View(), {}, 1 }, this->filter->GetRecipe());
  vtkPolyData* output = this->filter->GetOutput();
  vtkDataArray* number = output->GetCellData()->GetArray("Fragment");
  ASSERT_EQ(number->GetNumberOfTuples(), output->GetNumberOfCells());
  vtkIdType first = 0;
  for (vtkIdType n = 0; n < number->GetNumberOfTuples(); ++n)
    first += number->GetComponent(n, 0) == 1.0;
  EXPECT_EQ(first, vtkIdType(cut.fragments[0].mesh.triangles.size()));
  EXPECT_EQ(output->GetNumberOfCells() - first, vtkIdType(cut.fragments[1].mesh.triangles.size()));
  EXPECT_EQ(this->Measure("FragmentVolumeMm3", 1), cut.fragments[1].volumeMm3);
  EXPECT_EQ(this->Measure("CutKerfMm3", 0), cut.cuts[0].kerfMm3);
  EXPECT_EQ(this->Measure("CutParted", 0), 1.0);
  EXPECT_EQ(this->filter->GetResult().boneMm3, cut.boneMm3);
}

TEST_F(OsteotomyFilter, LabelsAreMadeWhenAskedForAlone)
{
  this->filter->Update();
  EXPECT_EQ(this->Labels()->GetNumberOfPoints(), 0);
  this->filter->LabelImageOn();
  this->filter->Update();
  ASSERT_EQ(this->Labels()->GetNumberOfPoints(), vtkIdType(this->scan.samples.size()));
  EXPECT_EQ(this->Labels()->GetPointData()->GetScalars()->GetRange()[1], 2.0);
}

} // namespace
