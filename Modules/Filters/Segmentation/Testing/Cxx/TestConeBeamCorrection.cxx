#include "vtkHaspConeBeamCorrection.h"

#include "ErrorsSaid.h"
#include "Grid/Phantom.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <cstring>

namespace
{

/// A coarse head as a cone-beam scanner has it, turned, its extent from elsewhere.
vtkSmartPointer<vtkImageData> Head()
{
  hasp::PhantomSettings settings;
  settings.coneBeam.on = true;
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(6.0), settings);
  const auto image = hasp::MakeImage(grid, hasp::SamplePhantom(grid, settings));
  image->SetExtent(3, grid.dims.x + 2, -4, grid.dims.y - 5, 7, grid.dims.z + 6);
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  return image;
}

TEST(ConeBeamCorrection, EvensSoftTissueAndKeepsTheGrid)
{
  const auto image = Head();
  vtkNew<vtkHaspConeBeamCorrection> filter;
  filter->SetInputData(image);
  filter->SetInsideAbove(-100.0);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  vtkImageData* out = filter->GetOutput();
  ASSERT_EQ(out->GetNumberOfPoints(), image->GetNumberOfPoints());
  EXPECT_EQ(out->GetScalarType(), VTK_FLOAT);
  EXPECT_STREQ(out->GetPointData()->GetScalars()->GetName(), "Corrected");
  EXPECT_EQ(0, std::memcmp(out->GetExtent(), image->GetExtent(), 6 * sizeof(int)));
  for (const vtkIdType point : { vtkIdType(0), out->GetNumberOfPoints() - 1 })
    for (int a = 0; a < 3; ++a)
      EXPECT_DOUBLE_EQ(out->GetPoint(point)[a], image->GetPoint(point)[a]);
  EXPECT_TRUE(filter->GetHasAir());
  EXPECT_NEAR(filter->GetAirLevel(), -550.0, 2.0); // 0.75 * -1000 + 200
  // Cupping of 12 % at 100 mm; soft tissue reaches from the axis to 96 mm.
  EXPECT_NEAR(filter->GetHighestShading() / filter->GetLowestShading(), 1.13, 0.02);
  const int* e = image->GetExtent(); // the axis is in the middle of the phantom's grid
  const int x = (e[0] + e[1]) / 2, y = (e[2] + e[3]) / 2, z = (e[4] + e[5]) / 2;
  const double soft = filter->GetSoftTissueLevel(); // 0.8 % of it above air are 6
  EXPECT_NEAR(out->GetScalarComponentAsDouble(x, y, z, 0), soft, 6.0);
  EXPECT_GT(soft - image->GetScalarComponentAsDouble(x, y, z, 0), 25.0);
}

TEST(ConeBeamCorrection, SaysWhatIsWrongAndGivesNothing)
{
  vtkNew<vtkHaspConeBeamCorrection> filter;
  filter->SetInputData(Head());
  filter->SetInsideAbove(30000.0);
  EXPECT_NE(ErrorsOfUpdate(filter).find("insideAbove"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->SetInsideAbove(-100.0);
  filter->SetFieldMm(1.0);
  EXPECT_NE(ErrorsOfUpdate(filter).find("fieldMm is 1"), std::string::npos);
  filter->SetFieldMm(60.0);
  vtkNew<vtkImageData> doubles;
  doubles->SetDimensions(4, 4, 4);
  doubles->AllocateScalars(VTK_DOUBLE, 1);
  filter->SetInputData(doubles);
  EXPECT_NE(ErrorsOfUpdate(filter).find("double"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ConeBeamCorrection, AnAbortGivesNothingWithoutAnError)
{
  vtkNew<vtkHaspConeBeamCorrection> filter;
  filter->SetInputData(Head());
  filter->SetInsideAbove(-100.0);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* self, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(self)->AbortExecuteOn(); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(ErrorsOfUpdate(filter), "");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace
