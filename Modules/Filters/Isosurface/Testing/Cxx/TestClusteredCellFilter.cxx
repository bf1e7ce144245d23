#include "vtkHaspClusteredCellFilter.h"

#include "Isosurface/CellAttributes.h"
#include "Isosurface/Testing/CellFixture.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{

using hasp::testing::CellsOf;
using hasp::testing::Noise;
using hasp::testing::SameCells;

const hasp::GridGeometry Geometry{ { 40, 33, 29 }, { -5, 6, 7 }, { 0.5, 0.7, 1.3 },
  glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1) };

/// Counts errors of an algorithm in place of printing them.
struct Errors
{
  explicit Errors(vtkObject* of)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        static_cast<Errors*>(self)->Text += static_cast<const char*>(text);
        ++static_cast<Errors*>(self)->Count;
      });
    of->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  vtkNew<vtkCallbackCommand> Command;
  std::string Text;
  int Count = 0;
};

class ClusteredCellFilter : public ::testing::Test
{
protected:
  ClusteredCellFilter() : Image(hasp::MakeImage(Geometry, Noise<std::int16_t>(Geometry)))
  {
    this->Filter->SetInputData(this->Image);
    this->Filter->SetIsoValue(100.5);
  }
  const hasp::ClusteredCells& Update()
  {
    this->Filter->Update();
    this->Held = this->Filter->GetOutput()->GetCells();
    return *this->Held;
  }
  hasp::ClusteredCells Truth(double isovalue = 100.5, bool compact = false) const
  {
    return CellsOf(hasp::ViewImage(this->Image), isovalue,
      compact ? hasp::CellPrecision::Compact : hasp::CellPrecision::Exact);
  }
  std::int16_t& Sample(int i, int j, int k)
  {
    return *static_cast<std::int16_t*>(this->Image->GetScalarPointer(i, j, k));
  }

  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkHaspClusteredCellFilter> Filter;
  std::shared_ptr<const hasp::ClusteredCells> Held;
};

TEST_F(ClusteredCellFilter, BadInputsAreErrorsAndGiveNothing)
{
  const Errors errors(this->Filter), executive(this->Filter->GetExecutive());
  ASSERT_GT(this->Update().Count(), 0U);
  this->Filter->SetIsoValue(std::numeric_limits<double>::infinity());
  EXPECT_EQ(this->Update().Count(), 0U);
  EXPECT_EQ(errors.Count, 1);
  EXPECT_NE(errors.Text.find("must be a finite number"), std::string::npos) << errors.Text;
  this->Filter->SetIsoValue(100.5);
  this->Image->AllocateScalars(VTK_SHORT, 3);
  this->Image->Modified();
  EXPECT_EQ(this->Update().Count(), 0U);
  EXPECT_EQ(errors.Count, 2);
}

TEST_F(ClusteredCellFilter, GivesWhatTheKernelGives)
{
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
  this->Filter->SetIsoValue(50.5);
  EXPECT_TRUE(SameCells(this->Update(), this->Truth(50.5)));
  this->Filter->CompactOn();
  EXPECT_TRUE(SameCells(this->Update(), this->Truth(50.5, true)));
  this->Filter->SetIsoValue(1000.0);
  EXPECT_EQ(this->Update().Count(), 0U);
}

TEST_F(ClusteredCellFilter, AChangedVolumeIsReadAnew)
{
  this->Update();
  this->Sample(20, 20, 20) = 30000;
  this->Image->Modified();
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
  this->Image->SetOrigin(1, 2, 3);
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
}

TEST_F(ClusteredCellFilter, OfAMarkedBoxOnlyItsBlocksAreRead)
{
  for (const bool compact : { false, true })
  {
    this->Filter->SetCompact(compact);
    this->Update();
    for (int i = 10; i <= 13; ++i)
      this->Sample(i, 9, 12) = static_cast<std::int16_t>(this->Sample(i, 9, 12) > 100 ? 20 : 180);
    const hasp::ClusteredCells truth = this->Truth(100.5, compact);
    const std::int16_t far = this->Sample(39, 32, 28);
    this->Sample(39, 32, 28) = static_cast<std::int16_t>(200 - far); // not marked: nobody looks
    this->Image->Modified();
    const int extent[6] = { 10, 13, 9, 9, 12, 12 };
    this->Filter->MarkModified(extent);
    EXPECT_TRUE(SameCells(this->Update(), truth));
    this->Sample(39, 32, 28) = far;
    this->Image->Modified();
    EXPECT_TRUE(SameCells(this->Update(), truth)) << "the mark is for one update";
  }
}

TEST_F(ClusteredCellFilter, AMarkMayReachAsFarAsIntegersDo)
{
  int whole[6] = { 100, 139, -10, 22, 7, 35 };
  this->Image->SetExtent(whole);
  this->Update();
  this->Sample(101, -9, 8) = 30000;
  constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
  const int everything[6] = { least, most, least, most, least, most };
  this->Filter->MarkModified(everything);
  this->Image->Modified();
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
}

TEST_F(ClusteredCellFilter, MarksAddUpAndHoldForAnotherIsovalueToo)
{
  int extent[6] = { 100, 139, -10, 22, 7, 35 };
  this->Image->SetExtent(extent); // the same samples, counted otherwise
  this->Update();
  for (const glm::ivec3 at : { glm::ivec3(101, -9, 8), glm::ivec3(120, 10, 20) })
  {
    this->Sample(at.x, at.y, at.z) = 30000;
    const int box[6] = { at.x, at.x, at.y, at.y, at.z, at.z };
    this->Filter->MarkModified(box);
  }
  this->Image->Modified();
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
  this->Sample(110, 0, 10) = 30000;
  const int box[6] = { 110, 110, 0, 0, 10, 10 };
  this->Filter->MarkModified(box);
  this->Image->Modified();
  this->Filter->SetIsoValue(20000);
  EXPECT_TRUE(SameCells(this->Update(), this->Truth(20000)));
  EXPECT_GT(this->Held->Count(), 8U);
}

TEST_F(ClusteredCellFilter, CellsThatSomebodyHoldsDoNotChange)
{
  this->Update();
  const auto held = this->Held;
  const hasp::ClusteredCells before = *held;
  this->Sample(20, 20, 20) = 30000;
  this->Image->Modified();
  const int box[6] = { 20, 20, 20, 20, 20, 20 };
  this->Filter->MarkModified(box);
  this->Update();
  EXPECT_TRUE(SameCells(*held, before));
  EXPECT_TRUE(SameCells(*this->Held, this->Truth()));
}

TEST_F(ClusteredCellFilter, LabelsFollowTheArrayAndTheEdits)
{
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("bones");
  for (vtkIdType n = 0; n < this->Image->GetNumberOfPoints(); ++n)
    labels->InsertNextValue(static_cast<unsigned char>(n / 7 % 5));
  this->Image->GetPointData()->AddArray(labels);
  const auto truth = [&]
  {
    hasp::ClusteredCells cells = this->Truth();
    hasp::AddLabels(cells, hasp::ViewPointArray(this->Image, labels));
    return cells;
  };
  const Errors errors(this->Filter), executive(this->Filter->GetExecutive());
  this->Filter->SetLabelArrayName("teeth");
  EXPECT_EQ(this->Update().Count(), 0U);
  EXPECT_NE(errors.Text.find("no point array teeth"), std::string::npos) << errors.Text;
  this->Filter->SetLabelArrayName("");
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
  const auto held = this->Held;
  this->Filter->SetLabelArrayName("bones");
  EXPECT_FALSE(this->Update().labels.empty());
  EXPECT_TRUE(SameCells(*this->Held, truth()));
  EXPECT_TRUE(held->labels.empty()) << "somebody holds them";
  this->Sample(20, 20, 20) = 30000;
  const int box[6] = { 20, 20, 20, 20, 20, 20 };
  this->Filter->MarkModified(box);
  EXPECT_TRUE(SameCells(this->Update(), truth()));
  this->Filter->SetLabelArrayName("");
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
}

TEST_F(ClusteredCellFilter, AbortGivesNothingAndNoError)
{
  const Errors errors(this->Filter);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(filter)->AbortExecuteOn(); });
  const unsigned long tag = this->Filter->AddObserver(vtkCommand::ProgressEvent, abort);
  EXPECT_EQ(this->Update().Count(), 0U);
  EXPECT_EQ(errors.Count, 0);
  this->Filter->RemoveObserver(tag);
  this->Filter->AbortExecuteOff();
  this->Filter->Modified();
  EXPECT_TRUE(SameCells(this->Update(), this->Truth()));
}

TEST_F(ClusteredCellFilter, DataObjectsShareOrCopyAndSayWhatTheyHold)
{
  this->Update();
  vtkHaspClusteredCells* output = this->Filter->GetOutput();
  vtkNew<vtkHaspClusteredCells> shallow, deep;
  EXPECT_EQ(shallow->GetNumberOfCells(), 0);
  shallow->ShallowCopy(output);
  deep->DeepCopy(output);
  EXPECT_EQ(shallow->GetCells(), output->GetCells());
  EXPECT_NE(deep->GetCells(), output->GetCells());
  EXPECT_TRUE(SameCells(*deep->GetCells(), *output->GetCells()));
  EXPECT_EQ(deep->GetNumberOfCells(), vtkIdType(this->Held->Count()));
  EXPECT_EQ(deep->GetNumberOfClusters(), vtkIdType(this->Held->clusters.size()));
  EXPECT_EQ(deep->GetIsoValue(), 100.5);
  EXPECT_FALSE(deep->GetCompact());
  EXPECT_GE(deep->GetActualMemorySize(), this->Held->Bytes() / 1024);
  double bounds[6], truth[6];
  deep->GetBounds(bounds);
  this->Image->GetBounds(truth);
  for (int n = 0; n < 6; ++n)
    EXPECT_NEAR(bounds[n], truth[n], 1e-12); // rounding of one sum
  std::ostringstream text;
  deep->Print(text);
  EXPECT_NE(text.str().find("Precision: exact"), std::string::npos);
  deep->Initialize();
  EXPECT_EQ(deep->GetNumberOfCells(), 0);
  EXPECT_GT(output->GetNumberOfCells(), 0);
}

} // namespace
