// A driver whose storage blocks are small draws the same picture, in parts.
#include "CellTestScene.h"
#include "Isosurface/ClusterCulling.h"
#include "vtkHaspOpenGLClusteredCellMapper.h"

#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

using hasp::testing::CellTestScene;

/// As if the driver bound no more than so many bytes.
class SmallBlockMapper : public vtkHaspOpenGLClusteredCellMapper
{
public:
  static SmallBlockMapper* New();
  vtkTypeMacro(SmallBlockMapper, vtkHaspOpenGLClusteredCellMapper);
  std::size_t BlockBytes = hasp::LeastBlockBytes;

protected:
  std::size_t GetStorageBlockBytes() const override { return this->BlockBytes; }
};
vtkStandardNewMacro(SmallBlockMapper);

template <typename T>
vtkSmartPointer<vtkImageData> Gyroid()
{
  const hasp::GridGeometry g = hasp::testing::ObliqueGrid(60, { 1, 0.9, 1.3 });
  return hasp::MakeImage(g, hasp::SampleAnalytic<T>(hasp::AnalyticGyroid(17), g, 100, 120));
}

std::vector<unsigned char> Picture(
  vtkHaspClusteredCellMapper* mapper, vtkImageData* image, bool culling)
{
  CellTestScene scene(150, 150);
  mapper->SetInputData(image);
  mapper->SetIsoValue(120);
  mapper->SetOcclusionCulling(culling);
  mapper->SetRendererToRasterize();
  scene.Actor->SetMapper(mapper);
  scene.Look({ 60, -80, 30 }, { 0, 0, 0 }, 20, 200);
  scene.Draw();
  scene.Draw();
  vtkNew<vtkUnsignedCharArray> rgb;
  scene.Window->GetPixelData(0, 0, 149, 149, 0, rgb);
  return { rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues() };
}

template <typename T>
void ExpectTheSamePictureInParts()
{
  const auto image = Gyroid<T>();
  vtkNew<vtkHaspOpenGLClusteredCellMapper> whole;
  const auto truth = Picture(whole, image, false);
  ASSERT_GT(DivideClusters(whole->GetCells(), hasp::LeastBlockBytes).size(), 4U);
  for (const bool culling : { false, true })
  {
    vtkNew<SmallBlockMapper> parts;
    EXPECT_EQ(Picture(parts, image, culling), truth) << "culling " << culling;
  }
}

class CellParts : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(CellParts, ABlockThatHoldsNothingIsAnError)
{
  vtkNew<SmallBlockMapper> mapper;
  mapper->BlockBytes = 100;
  mapper->SetGlobalWarningDisplay(false);
  const auto picture = Picture(mapper, Gyroid<std::uint8_t>(), true);
  mapper->SetGlobalWarningDisplay(true);
  EXPECT_EQ(picture, std::vector<unsigned char>(picture.size(), 0));
}

TEST_F(CellParts, Int16CellsLookTheSame)
{
  ExpectTheSamePictureInParts<std::int16_t>();
}

TEST_F(CellParts, FloatCellsLookTheSame)
{
  ExpectTheSamePictureInParts<float>();
}

// Occlusion culling needs 16 bytes of draw commands a cluster. OpenGL's 128 MiB a block are full at
// 8,388,608 clusters, these 32 KiB at 2048.
TEST_F(CellParts, MoreClustersThanABlockHoldsDrawCommandsOfAreCulled)
{
  // A grain in each of 13^3 clusters.
  const hasp::GridGeometry g = hasp::testing::ObliqueGrid(108, { 0.5, 0.5, 0.5 });
  std::vector<std::int16_t> samples(g.Size(), 0);
  for (int n = 0; n < 13 * 13 * 13; ++n)
  {
    const glm::ivec3 at = 8 * glm::ivec3(n % 13, n / 13 % 13, n / 169) + glm::ivec3(3, 4, 5);
    samples[(std::size_t(at.z) * g.dims.y + at.y) * g.dims.x + at.x] = 500;
  }
  const auto image = hasp::MakeImage(g, samples);
  vtkNew<vtkHaspOpenGLClusteredCellMapper> whole;
  vtkNew<SmallBlockMapper> parts;
  const auto truth = Picture(whole, image, false);
  ASSERT_GT(16 * whole->GetCells().clusters.size(), hasp::LeastBlockBytes);
  EXPECT_EQ(Picture(parts, image, true), truth);
  EXPECT_GT(std::count_if(truth.begin(), truth.end(), [](int c) { return c > 0; }), 10000);
}

// Labels, a pose, and colours of another array go along in parts, too.
TEST_F(CellParts, LabelsAndColoursLookTheSame)
{
  const auto image = Gyroid<std::int16_t>();
  vtkNew<vtkUnsignedShortArray> label;
  vtkNew<vtkFloatArray> height;
  label->SetName("label");
  height->SetName("height");
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    label->InsertNextValue(static_cast<unsigned short>(n / 5000 % 4));
    height->InsertNextValue(static_cast<float>(n % 1777));
  }
  image->GetPointData()->AddArray(label);
  image->GetPointData()->AddArray(height);
  vtkNew<vtkTransform> pose;
  pose->Translate(4, -8, 3);
  const auto ask = [&](vtkHaspClusteredCellMapper* mapper, bool posed)
  {
    mapper->SetLabelArrayName("label");
    mapper->SetLabelColor(1, 1, 0, 0);
    mapper->SetLabelVisibility(2, false);
    mapper->SetLabelPose(3, posed ? pose.GetPointer() : nullptr);
    mapper->ScalarVisibilityOn();
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray("height");
    mapper->SetScalarRange(0, 1777);
  };
  for (const bool posed : { false, true })
  {
    vtkNew<vtkHaspOpenGLClusteredCellMapper> whole;
    vtkNew<SmallBlockMapper> parts;
    ask(whole, posed);
    ask(parts, posed);
    EXPECT_EQ(Picture(parts, image, true), Picture(whole, image, false)) << "posed " << posed;
    for (const auto& part : DivideClusters(whole->GetCells(), hasp::LeastBlockBytes))
    {
      const auto& first = whole->GetCells().firstColors;
      const std::size_t end =
        part.end < first.size() ? first[part.end] : whole->GetCells().colors.size();
      EXPECT_LE(4 * (end - first[part.first]) + 256, hasp::LeastBlockBytes);
    }
  }
}

} // namespace
