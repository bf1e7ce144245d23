// Hardware selection gives the cell the ray caster meets; and a scene that does not pick pays
// nothing.
#include "CellTestScene.h"
#include "Isosurface/ClusteredCells.h"
#include "Isosurface/RayCaster.h"
#include "vtkHaspClusteredCellLocator.h"
#include "vtkHaspPickedCell.h"

#include "vtkCellPicker.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkPointData.h"
#include "vtkWorldPointPicker.h"

#include <gtest/gtest.h>

namespace
{

using hasp::testing::CellTestScene;

struct PickScene
{
  hasp::GridGeometry geometry = hasp::testing::ObliqueGrid(48, { 1.0, 0.8, 1.3 });
  vtkSmartPointer<vtkImageData> image = hasp::MakeImage(
    geometry, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(30), geometry, 100, 0));
  hasp::MinMaxBlocks blocks{ hasp::ViewImage(image) };
  CellTestScene scene{ 240, 200 };
  PickScene()
  {
    scene.Mapper->SetInputData(image);
    scene.Look({ 90, -120, 60 }, { 0, 0, 0 }, 40, 300);
    scene.Draw();
  }
};

hasp::ResourceUse Find(const CellTestScene& scene, const std::string& name)
{
  hasp::ResourceList list;
  scene.Mapper->ListResources(list);
  for (const auto& use : list)
    if (use.resource == name)
      return use;
  ADD_FAILURE() << "no resource " << name;
  return {};
}

class CellPicking : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(CellPicking, GivesTheCellAndTheActor)
{
  PickScene s;
  const hasp::RayCaster caster(hasp::ViewImage(s.image), s.blocks, 0.0);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(s.scene.Renderer);
  selector->SetArea(0, 0, 239, 199);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_TRUE(selector->CaptureBuffers());
  int hits = 0, differ = 0;
  for (unsigned y = 5; y < 200; y += 7)
    for (unsigned x = 5; x < 240; x += 9)
    {
      const auto [origin, direction] = s.scene.Ray(int(x), int(y));
      const auto truth = caster.Cast(origin, direction);
      const unsigned pixel[2] = { x, y };
      const auto picked = selector->GetPixelInformation(pixel);
      ASSERT_EQ(picked.Valid, truth.has_value()) << x << " " << y;
      if (!truth)
        continue;
      EXPECT_EQ(picked.Prop, s.scene.Actor.GetPointer());
      int ijk[3];
      ASSERT_TRUE(s.scene.Mapper->GetCellIndex(picked.AttributeID, ijk));
      differ += glm::ivec3(ijk[0], ijk[1], ijk[2]) != truth->cell;
      ++hits;
    }
  EXPECT_GT(hits, 200);
  EXPECT_LE(differ, 1); // a hit on the face between two cells
}

TEST_F(CellPicking, APickOfPointsNamesTheActorAndNoPoint)
{
  PickScene s;
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(s.scene.Renderer);
  selector->SetArea(0, 0, 239, 199);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_POINTS);
  ASSERT_TRUE(selector->CaptureBuffers());
  const unsigned pixel[2] = { 120, 100 };
  const auto picked = selector->GetPixelInformation(pixel);
  EXPECT_EQ(picked.Prop, s.scene.Actor.GetPointer());
  EXPECT_LE(picked.AttributeID, 0) << "a surface of cells has no points";
}

TEST_F(CellPicking, WorldPointPickerGivesThePointOnTheSurface)
{
  PickScene s;
  const hasp::RayCaster caster(hasp::ViewImage(s.image), s.blocks, 0.0);
  vtkNew<vtkWorldPointPicker> picker;
  picker->Pick(120, 100, 0, s.scene.Renderer);
  const auto [origin, direction] = s.scene.Ray(120, 100);
  const auto truth = caster.Cast(origin, direction);
  ASSERT_TRUE(truth);
  const double* at = picker->GetPickPosition();
  // The picker takes the pixel's corner, not its centre: half a pixel, some 0.2 mm here.
  EXPECT_LT(glm::length(glm::dvec3(at[0], at[1], at[2]) - truth->position), 1.0);
}

// An actor with a matrix, and the picker as any program uses it.
TEST_F(CellPicking, ACellPickerWithTheLocatorIsExact)
{
  PickScene s;
  s.scene.Actor->SetPosition(3, -4, 5);
  s.scene.Actor->RotateZ(20);
  s.scene.Draw();
  vtkNew<vtkHaspClusteredCellLocator> locator;
  locator->SetMapper(s.scene.Mapper);
  vtkNew<vtkCellPicker> picker;
  picker->AddLocator(locator);
  int hits = 0;
  for (int y = 5; y < 200; y += 7)
    for (int x = 5; x < 240; x += 9)
    {
      const auto truth = s.scene.Point(x, y);
      // The picker takes the pixel's lower left corner.
      ASSERT_EQ(picker->Pick(x + 0.5, y + 0.5, 0, s.scene.Renderer) != 0, truth.has_value());
      if (!truth)
        continue;
      ++hits;
      // 24 bits of depth from 40 to 300 mm: 0.02 mm.
      EXPECT_LT(glm::distance(glm::make_vec3(picker->GetPickPosition()), *truth), 0.03);
      EXPECT_EQ(picker->GetActor(), s.scene.Actor.GetPointer());
      const vtkIdType id = picker->GetCellId();
      const glm::ivec3 n = s.geometry.Cells();
      EXPECT_TRUE(s.scene.Mapper->GetCells().Find({ id % n.x, id / n.x % n.y, id / n.x / n.y }));
    }
  EXPECT_GT(hits, 200);
}

// Why the locator is needed: see vtkHaspClusteredCellLocator.h.
TEST_F(CellPicking, ACellPickerWithoutItStopsAtTheVolumesBox)
{
  PickScene s;
  vtkNew<vtkCellPicker> picker;
  picker->Pick(120.5, 100.5, 0, s.scene.Renderer);
  const glm::dvec3 index = s.geometry.WorldToIndex(glm::make_vec3(picker->GetPickPosition()));
  const glm::dvec3 fromWall = glm::min(index, glm::dvec3(s.geometry.dims - 1) - index);
  EXPECT_LT(std::min({ fromWall.x, fromWall.y, fromWall.z }), 1.01) << "in the outermost voxels";
  EXPECT_GT(
    glm::distance(glm::make_vec3(picker->GetPickPosition()), *s.scene.Point(120, 100)), 2.0);
}

TEST_F(CellPicking, GivesVoxelPointNormalAndValue)
{
  PickScene s;
  vtkNew<vtkFloatArray> height; // x + 2 y - z in index coordinates: trilinear is exact
  height->SetName("height");
  for (int k = 0; k < s.geometry.dims.z; ++k)
    for (int j = 0; j < s.geometry.dims.y; ++j)
      for (int i = 0; i < s.geometry.dims.x; ++i)
        height->InsertNextValue(static_cast<float>(i + 2 * j - k));
  s.image->GetPointData()->AddArray(height);
  const hasp::RayCaster caster(hasp::ViewImage(s.image), s.blocks, 0.0);
  s.scene.Draw();
  for (const bool colored : { false, true })
  {
    s.scene.Mapper->SetScalarVisibility(colored);
    s.scene.Mapper->SetScalarModeToUsePointFieldData();
    s.scene.Mapper->SelectColorArray("height");
    s.scene.Draw();
    const auto [origin, direction] = s.scene.Ray(120, 100);
    const glm::dvec3 to = origin + 300.0 * direction;
    const auto truth = caster.Cast(origin, direction);
    vtkNew<vtkHaspPickedCell> picked;
    ASSERT_TRUE(s.scene.Mapper->PickFirstCell(&origin.x, &to.x, picked));
    EXPECT_EQ(glm::make_vec3(picked->GetIJK()), truth->cell);
    // The root is found in float inside a cell: a millionth of it.
    EXPECT_LT(glm::distance(glm::make_vec3(picked->GetPosition()), truth->position), 1e-5);
    EXPECT_GT(
      glm::dot(glm::make_vec3(picked->GetNormal()), -glm::normalize(truth->gradient)), 0.9999);
    EXPECT_EQ(picked->GetLabel(), 0);
    const glm::dvec3 index = s.geometry.WorldToIndex(truth->position);
    EXPECT_NEAR(picked->GetValue(), colored ? index.x + 2 * index.y - index.z : 0.0, 1e-4);
    vtkNew<vtkHaspPickedCell> same;
    EXPECT_TRUE(s.scene.Mapper->PickCell(picked->GetCellId(), &origin.x, &to.x, same));
    EXPECT_EQ(same->GetT(), picked->GetT());
    EXPECT_FALSE(s.scene.Mapper->PickCell(picked->GetCellId(), &origin.x, &origin.x, same));
    EXPECT_FALSE(s.scene.Mapper->PickCell(-1, &origin.x, &to.x, same));
  }
}

TEST_F(CellPicking, CellsOutsideTheRangeAreNoCells)
{
  PickScene s;
  int ijk[3] = { 7, 7, 7 };
  EXPECT_FALSE(s.scene.Mapper->GetCellIndex(-1, ijk));
  EXPECT_FALSE(s.scene.Mapper->GetCellIndex(vtkIdType(1) << 40, ijk));
  EXPECT_EQ(ijk[0], 7);
}

TEST_F(CellPicking, IsNotThereUntilAskedForAndGoneAfterRelease)
{
  PickScene s;
  EXPECT_EQ(Find(s.scene, "shader: cell selection").milliseconds, 0.0);
  EXPECT_GT(Find(s.scene, "active cells, GPU").bytes, 0U);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(s.scene.Renderer);
  selector->SetArea(120, 100, 120, 100);
  EXPECT_TRUE(selector->CaptureBuffers());
  EXPECT_GT(Find(s.scene, "shader: cell selection").milliseconds, 0.0);
  s.scene.Window->Finalize();
  for (const char* name : { "shader: cell selection", "shader: shaded cells", "active cells, GPU" })
  {
    EXPECT_EQ(Find(s.scene, name).bytes, 0U) << name;
    EXPECT_EQ(Find(s.scene, name).milliseconds, 0.0) << name;
  }
}

} // namespace
