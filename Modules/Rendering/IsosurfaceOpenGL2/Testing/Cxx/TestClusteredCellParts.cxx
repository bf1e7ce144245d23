// A driver whose storage blocks are small draws the same picture, in parts.
#include "CellTestScene.h"
#include "Isosurface/ClusterCulling.h"
#include "vtkHaspOpenGLClusteredCellMapper.h"

#include "vtkObjectFactory.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

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

} // namespace
