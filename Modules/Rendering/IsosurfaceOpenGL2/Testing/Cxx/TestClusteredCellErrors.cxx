// What is wrong is said once, not in every pass of every frame, and again after a change.
#include "AttributeTestScene.h"
#include "ErrorCounter.h"
#include "Isosurface/ClusterCulling.h"
#include "vtkHaspOpenGLClusteredCellMapper.h"

#include "vtkObjectFactory.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using hasp::testing::AttributeScene;
using hasp::testing::CellTestScene;
using hasp::testing::ErrorCounter;

class CellErrors : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }

  CellErrors() { this->Scene.Mapper->AddObserver(vtkCommand::ErrorEvent, this->Errors); }

  /// Errors of two frames, with one more question in between, which all fail or all succeed.
  int Said(bool fails = true)
  {
    this->Errors->Count = 0;
    EXPECT_EQ(this->Scene.Covered() == 0, fails);
    EXPECT_EQ(this->Scene.Mapper->UpdateCells(), !fails);
    EXPECT_EQ(this->Scene.Covered() == 0, fails);
    return this->Errors->Count;
  }

  AttributeScene Scene;
  vtkNew<ErrorCounter> Errors;
};

TEST_F(CellErrors, NoInputIsSaidOnce)
{
  vtkSmartPointer<vtkImageData> image = this->Scene.Mapper->GetImage();
  this->Scene.Mapper->RemoveAllInputConnections(0);
  EXPECT_EQ(this->Said(), 1);
  EXPECT_EQ(this->Said(), 0);
  this->Scene.Mapper->SetInputData(image);
  EXPECT_EQ(this->Said(false), 0);
  this->Scene.Mapper->RemoveAllInputConnections(0);
  EXPECT_EQ(this->Said(), 1);
}

TEST_F(CellErrors, ATypeOfScalarsIsRefusedOncePerImage)
{
  vtkNew<vtkImageData> bad, worse;
  for (vtkImageData* image : { bad.GetPointer(), worse.GetPointer() })
  {
    image->SetDimensions(4, 4, 4);
    image->AllocateScalars(VTK_INT, 1);
  }
  vtkSmartPointer<vtkImageData> good = this->Scene.Mapper->GetImage();
  vtkNew<vtkTrivialProducer> reader; // its output changes behind the mapper's back
  reader->SetOutput(bad);
  this->Scene.Mapper->SetInputConnection(reader->GetOutputPort());
  EXPECT_EQ(this->Said(), 1);
  EXPECT_EQ(this->Said(), 0);
  bad->Modified();
  EXPECT_EQ(this->Said(), 1);
  reader->SetOutput(worse);
  EXPECT_EQ(this->Said(), 1);
  reader->SetOutput(good);
  EXPECT_EQ(this->Said(false), 0);
}

TEST_F(CellErrors, AnIsovalueIsRefusedOnce)
{
  this->Scene.Mapper->SetIsoValue(std::nan(""));
  EXPECT_EQ(this->Said(), 1);
  EXPECT_EQ(this->Said(), 0);
  this->Scene.Mapper->SetIsoValue(HUGE_VAL);
  EXPECT_EQ(this->Said(), 1);
  this->Scene.Mapper->SetIsoValue(0.0);
  EXPECT_EQ(this->Said(false), 0);
}

TEST_F(CellErrors, AMissingArrayIsSaidOnceAndNothingIsExtractedForIt)
{
  const auto extraction = [this]
  {
    hasp::ResourceList list;
    this->Scene.Mapper->ListResources(list);
    for (const auto& use : list)
      if (use.resource == "active cells, host")
        return use.milliseconds;
    return -1.0;
  };
  this->Scene.Mapper->SetLabelArrayName("nothing");
  EXPECT_EQ(this->Said(), 1);
  const double once = extraction();
  EXPECT_GT(once, 0.0);
  EXPECT_EQ(this->Said(), 0);
  EXPECT_EQ(extraction(), once) << "it was extracted again";
  vtkNew<vtkUnsignedShortArray> late;
  late->DeepCopy(this->Scene.Mapper->GetImage()->GetPointData()->GetArray("label"));
  late->SetName("nothing");
  this->Scene.Mapper->GetImage()->GetPointData()->AddArray(late);
  EXPECT_EQ(this->Said(false), 0);
}

/// As if the driver bound no more than so many bytes.
struct PoorDriverMapper : vtkHaspOpenGLClusteredCellMapper
{
  static PoorDriverMapper* New();
  vtkTypeMacro(PoorDriverMapper, vtkHaspOpenGLClusteredCellMapper);
  std::size_t BlockBytes = 100;
  std::size_t GetStorageBlockBytes() const override { return this->BlockBytes; }
};
vtkStandardNewMacro(PoorDriverMapper);

TEST_F(CellErrors, WhatOpenGLRefusesIsSaidOnceAndTriedAgain)
{
  vtkNew<PoorDriverMapper> mapper;
  mapper->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  mapper->SetInputData(this->Scene.Mapper->GetImage());
  mapper->SetRendererToRasterize();
  this->Scene.Actor->SetMapper(mapper);
  EXPECT_EQ(this->Scene.Covered(), 0);
  EXPECT_EQ(this->Scene.Covered(), 0);
  EXPECT_EQ(this->Errors->Count, 1);
  mapper->BlockBytes = hasp::LeastBlockBytes;
  EXPECT_GT(this->Scene.Covered(), 0);
  mapper->BlockBytes = 100;
  mapper->SetIsoValue(1.0); // to upload once more
  EXPECT_EQ(this->Scene.Covered(), 0);
  EXPECT_EQ(this->Scene.Covered(), 0);
  EXPECT_EQ(this->Errors->Count, 2);
}

} // namespace
