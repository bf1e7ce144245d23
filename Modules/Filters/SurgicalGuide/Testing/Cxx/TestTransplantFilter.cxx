#include "FilterFixture.h"
#include "TransplantBuilder.h"
#include "TransplantFixture.h"
#include "vtkHaspTransplantFilter.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <string>

using namespace transplanttest;

namespace
{

class TransplantFilter : public testing::Test
{
protected:
  TransplantFilter()
  {
    parttest::KeepWords(
      this->filter, this->said, { vtkCommand::ErrorEvent, vtkCommand::WarningEvent });
    this->filter->SetInputData(0, hasp::MakeImage(this->jaw.grid, this->jaw.samples));
    this->filter->SetInputData(1, hasp::MakeImage(this->leg.grid, this->leg.samples));
    this->filter->SetRecipe(Recipe());
  }
  double Measure(const char* name, int n)
  {
    return this->filter->GetOutput()->GetFieldData()->GetArray(name)->GetComponent(n, 0);
  }
  vtkIdType Cells(int port)
  {
    return vtkPolyData::SafeDownCast(this->filter->GetOutputDataObject(port))->GetNumberOfCells();
  }

  cuttest::BoneScan jaw = ScanOfJaw(), leg = ScanOfLeg();
  vtkNew<vtkHaspTransplantFilter> filter;
  std::string said;
};

TEST_F(TransplantFilter, GivesTheBuildersMeshesLinesAndMeasuresOrAnError)
{
  this->filter->Update();
  ASSERT_EQ(this->said, "");
  const hasp::MadeTransplant made =
    hasp::MakeTransplant(ImageOf(this->jaw), ImageOf(this->leg), Recipe());
  const std::size_t first = made.segments[0].mesh.triangles.size(),
                    second = made.segments[1].mesh.triangles.size();
  EXPECT_EQ(this->Cells(0), vtkIdType(first + second));
  EXPECT_EQ(this->Cells(1), vtkIdType(first + second));
  vtkDataArray* number = this->filter->GetOutput()->GetCellData()->GetArray("Segment");
  EXPECT_EQ(number->GetComponent(vtkIdType(first) - 1, 0), 0.0);
  EXPECT_EQ(number->GetComponent(vtkIdType(first), 0), 1.0);
  std::size_t jaws = 0;
  for (const hasp::BoneFragment& fragment : made.recipient.fragments)
    jaws += fragment.resected || fragment.crumb ? 0 : fragment.mesh.triangles.size();
  EXPECT_EQ(this->Cells(2), vtkIdType(jaws));
  EXPECT_EQ(this->Cells(3), 3); // two parts of the vessel, and the paddle
  EXPECT_EQ(this->Measure("SegmentLengthMm", 1), made.segments[1].cut.lengthMm);
  EXPECT_EQ(this->Measure("SegmentVolumeMm3", 0), made.segments[0].volumeMm3);
  EXPECT_EQ(this->Measure("JointContactMm2", 2), made.joints[2].fit.contactMm2);
  EXPECT_EQ(this->filter->GetResult().plan.joints, made.plan.joints);
  // A warning is one; an error leaves nothing.
  hasp::TransplantRecipe recipe = Recipe();
  recipe.resection.resected.clear();
  this->filter->SetRecipe(recipe);
  this->filter->Update();
  EXPECT_NE(this->said.find("resected names no fragment"), std::string::npos) << this->said;
  EXPECT_GT(this->Cells(0), 0);
  recipe.leastSegmentMm = 40.0;
  this->filter->SetRecipe(recipe);
  this->said.clear();
  this->filter->Update();
  EXPECT_NE(this->said.find("segments[0]'s length"), std::string::npos) << this->said;
  for (int port = 0; port < 4; ++port)
    EXPECT_EQ(this->Cells(port), 0);
  EXPECT_TRUE(this->filter->GetResult().segments.empty());
  this->said.clear();
  EXPECT_FALSE(this->filter->ReadRecipe("/nowhere/t.json"));
  EXPECT_NE(this->said, "");
  EXPECT_EQ(this->said.find("nowhere"), std::string::npos);
}

} // namespace
