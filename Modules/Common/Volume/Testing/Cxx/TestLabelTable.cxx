#include "vtkHaspLabelTable.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

const hasp::LabelTable Table{ { 65535, "Unterkiefer \"l\xC3\xA4nks\": 1", { 0, 128, 255 }, true },
  { 1, "", { 1, 2, 3 }, false } };

TEST(LabelTableOfAnImage, ComesBackAsItWasPut)
{
  vtkNew<vtkImageData> image;
  EXPECT_TRUE(hasp::GetLabelTable(image).empty());
  hasp::SetLabelTable(image, Table);
  EXPECT_EQ(hasp::GetLabelTable(image), Table);
  vtkNew<vtkImageData> copy;
  copy->ShallowCopy(image);
  EXPECT_EQ(hasp::GetLabelTable(copy), Table);
  hasp::SetLabelTable(image, {});
  EXPECT_TRUE(hasp::GetLabelTable(image).empty());
  EXPECT_EQ(image->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(LabelTableOfAnImage, ArraysThatAreNoTableAreRefused)
{
  const auto refused = [](const char* says, const auto& change)
  {
    vtkNew<vtkImageData> image;
    hasp::SetLabelTable(image, Table);
    change(image->GetFieldData());
    try
    {
      hasp::GetLabelTable(image);
      ADD_FAILURE() << "was taken: " << says;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find("kiefer"), std::string::npos) << "a name";
    }
  };
  const auto values = [](vtkFieldData* fields)
  { return vtkUnsignedShortArray::SafeDownCast(fields->GetAbstractArray("LabelValues")); };
  refused("as many", [](auto* fields) { fields->RemoveArray("LabelNames"); });
  refused("as many", [](auto* fields) { fields->RemoveArray("LabelValues"); });
  refused("as many", [](auto* fields) { fields->GetArray("LabelColors")->SetNumberOfTuples(1); });
  refused("0, which is nothing", [&](auto* fields) { values(fields)->SetValue(0, 0); });
  refused("1 twice", [&](auto* fields) { values(fields)->SetValue(0, 1); });
  refused("LabelValues is of another type",
    [](auto* fields)
    {
      vtkNew<vtkFloatArray> array;
      array->SetName("LabelValues");
      fields->AddArray(array);
    });
  refused("LabelColors is of another type",
    [](auto* fields) { fields->GetArray("LabelColors")->SetNumberOfComponents(4); });
}

TEST(LabelTableOfAnImage, WithoutAWordOfBoneNothingIsSaidOfIt)
{
  vtkNew<vtkImageData> image;
  hasp::SetLabelTable(image, Table);
  image->GetFieldData()->RemoveArray("LabelsOfBone");
  EXPECT_FALSE(hasp::GetLabelTable(image)[0].bone);
}

} // namespace
