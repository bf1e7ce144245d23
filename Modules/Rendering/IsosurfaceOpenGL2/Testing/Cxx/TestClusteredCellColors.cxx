// Scalar colours as vtkMapper knows them, held to closed form and to VTK's own mesh.
#include "AttributeTestScene.h"
#include "Isosurface/ClusteredCells.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkLookupTable.h"
#include "vtkProbeFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

using hasp::testing::AttributeScene;
using hasp::testing::BytesOf;
using Color = std::array<int, 3>;

class CellColors : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// Red grows, blue falls with the value; `steps` colours.
vtkSmartPointer<vtkLookupTable> RedToBlue(int steps)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(steps);
  for (int n = 0; n < steps; ++n)
    table->SetTableValue(n, double(n) / (steps - 1), 0, 1 - double(n) / (steps - 1));
  return table;
}

/// Each component within `bound` of the other's.
testing::AssertionResult Near(const Color& a, const Color& b, int bound)
{
  for (int c = 0; c < 3; ++c)
    if (std::abs(a[c] - b[c]) > bound)
      return testing::AssertionFailure()
             << a[0] << " " << a[1] << " " << a[2] << " and " << b[0] << " " << b[1] << " " << b[2];
  return testing::AssertionSuccess();
}

TEST_F(CellColors, AreOffUntilSwitchedOn)
{
  AttributeScene s;
  s.Actor->GetProperty()->SetColor(0, 1, 0);
  EXPECT_EQ(s.ColorAt({ 0, -15, 0 }), (Color{ 0, 255, 0 }));
  EXPECT_EQ(BytesOf(s, "cell colours, host"), 0U);
  EXPECT_EQ(BytesOf(s, "cell colours, GPU"), 0U);
  EXPECT_TRUE(s.Mapper->GetCells().colors.empty());
}

TEST_F(CellColors, OfTheDensityAreTheIsovaluesForTheWholeSurface)
{
  AttributeScene s;
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetLookupTable(RedToBlue(256));
  s.Mapper->SetScalarRange(-100, 100);
  for (const double isovalue : { 0.0, -100.0, 60.0 })
  {
    s.Mapper->SetIsoValue(isovalue);
    const int red = static_cast<int>(255 * (isovalue + 100) / 200 + 0.5);
    EXPECT_TRUE(Near(s.ColorAt({ 0, -15, 0 }), { red, 0, 255 - red }, 1)) << isovalue;
    EXPECT_TRUE(Near(s.ColorAt({ 6, -13, 5 }), { red, 0, 255 - red }, 1)) << isovalue;
  }
  EXPECT_EQ(BytesOf(s, "cell colours, GPU"), 0U);
}

TEST_F(CellColors, OfAnotherArrayAreInterpolatedAtTheHit)
{
  AttributeScene s;
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetScalarModeToUsePointFieldData();
  s.Mapper->SelectColorArray("height");
  s.Mapper->SetLookupTable(RedToBlue(256));
  s.Mapper->SetScalarRange(-20, 20);
  for (const double z : { -10.2, -3.0, 0.4, 7.7 })
  {
    const double y = -std::sqrt(15 * 15 - z * z);
    const int red = static_cast<int>(255 * (z + 20) / 40 + 0.5);
    // A pixel is 0.9 mm wide, 6 grey levels, and on a slope up to 1.5 of them high.
    EXPECT_TRUE(Near(s.ColorAt({ 0, y, z }), { red, 0, 255 - red }, 7)) << z;
  }
  EXPECT_EQ(BytesOf(s, "cell colours, host"),
    4 * (s.Mapper->GetCells().colors.size() + s.Mapper->GetCells().clusters.size()));
}

TEST_F(CellColors, ANewLookupTableExtractsNothing)
{
  AttributeScene s;
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetScalarModeToUsePointFieldData();
  s.Mapper->ColorByArrayComponent("height", 0);
  s.Mapper->SetScalarRange(-20, 20);
  auto table = RedToBlue(2);
  s.Mapper->SetLookupTable(table);
  const Color blue = s.ColorAt({ 0, -13, -7 });
  const auto* clusters = s.Mapper->GetCells().clusters.data();
  table->SetTableValue(0, 0, 1, 0);
  const Color green = s.ColorAt({ 0, -13, -7 });
  EXPECT_EQ(blue, (Color{ 0, 0, 255 }));
  EXPECT_EQ(green, (Color{ 0, 255, 0 }));
  s.Mapper->SetScalarRange(-20, -15); // now the other end
  EXPECT_EQ(s.ColorAt({ 0, -13, -7 }), (Color{ 255, 0, 0 }));
  table->SetTableRange(-20, 20);
  s.Mapper->UseLookupTableScalarRangeOn();
  EXPECT_EQ(s.ColorAt({ 0, -13, -7 }), (Color{ 0, 255, 0 }));
  EXPECT_EQ(s.Mapper->GetCells().clusters.data(), clusters);
  s.Mapper->ScalarVisibilityOff();
  s.Draw();
  EXPECT_EQ(BytesOf(s, "cell colours, GPU"), 0U);
  EXPECT_EQ(BytesOf(s, "cell colours, host"), 0U);
}

// Two colours, and the border between them at z = 0.5. Mapped first: a ramp as wide as a cell.
// Interpolated first: an edge.
TEST_F(CellColors, InterpolateScalarsBeforeMappingGivesSharpEdges)
{
  AttributeScene s;
  s.Look({ 0, -25, 0.5 }, { 0, 0, 0.5 }, 5, 60); // 10 pixels a mm
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetScalarModeToUsePointFieldData();
  s.Mapper->SelectColorArray("height");
  s.Mapper->SetLookupTable(RedToBlue(2));
  s.Mapper->SetScalarRange(-19.5, 20.5);
  const auto mixed = [&]
  {
    int count = 0;
    for (double z = -0.5; z < 1.5; z += 0.05)
    {
      const Color c = s.ColorAt({ 0, -std::sqrt(15 * 15 - z * z), z });
      EXPECT_NEAR(c[0] + c[2], 255, 1);
      count += c[0] > 5 && c[0] < 250;
    }
    return count;
  };
  EXPECT_GT(mixed(), 14);
  s.Mapper->InterpolateScalarsBeforeMappingOn();
  EXPECT_EQ(mixed(), 0);
  EXPECT_EQ(s.ColorAt({ 0, -15, 0.3 }), (Color{ 0, 0, 255 }));
  EXPECT_EQ(s.ColorAt({ 0, -15, 0.7 }), (Color{ 255, 0, 0 }));
}

TEST_F(CellColors, ColoursInTheArrayAreShownAsTheyAre)
{
  AttributeScene s;
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetScalarModeToUsePointFieldData();
  s.Mapper->SelectColorArray("rgb");
  for (const glm::dvec3 p : { glm::dvec3(-5, -13, 4), glm::dvec3(7.5, -12, -3) })
  {
    const glm::dvec3 at = 15.0 * glm::normalize(p), truth = 6.0 * (at + 20.0);
    EXPECT_TRUE(
      Near(s.ColorAt(at), { int(truth.x), int(truth.y), int(truth.z) }, 6)); // a pixel's width
  }
  s.Mapper->SetColorModeToMapScalars(); // the first component through the table
  s.Mapper->SetLookupTable(RedToBlue(256));
  s.Mapper->SetScalarRange(0, 240);
  EXPECT_TRUE(Near(s.ColorAt({ 0, -15, 0 }), { 127, 0, 127 }, 7));
}

TEST_F(CellColors, ATranslucentTableMakesTheSurfaceTranslucent)
{
  AttributeScene s;
  auto table = RedToBlue(2);
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetLookupTable(table);
  EXPECT_TRUE(s.Actor->HasOpaqueGeometry());
  EXPECT_FALSE(s.Actor->HasTranslucentPolygonalGeometry());
  for (int n = 0; n < 2; ++n)
    table->SetTableValue(n, 1, 0, 0, 0.5);
  EXPECT_FALSE(s.Actor->HasOpaqueGeometry());
  EXPECT_TRUE(s.Actor->HasTranslucentPolygonalGeometry());
  EXPECT_NEAR(s.ColorAt({ 0, -15, 0 })[0], 191, 3); // two layers of half
}

TEST_F(CellColors, LabelsWithAColourComeFirst)
{
  AttributeScene s;
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetScalarModeToUsePointFieldData();
  s.Mapper->SelectColorArray("height");
  s.Mapper->SetLookupTable(RedToBlue(2));
  s.Mapper->SetScalarRange(-20, 20);
  s.Mapper->SetLabelArrayName("label");
  s.Mapper->SetLabelColor(1, 0, 1, 0);
  EXPECT_EQ(s.ColorAt({ -7, -12, 5 }), (Color{ 0, 255, 0 }));
  EXPECT_EQ(s.ColorAt({ 7, -12, 5 }), (Color{ 255, 0, 0 }));
}

// Second implementation: VTK's own mesh, the array probed at its vertices.
TEST_F(CellColors, LookLikeVTKsMesh)
{
  AttributeScene s;
  s.Actor->GetProperty()->LightingOn();
  s.Actor->GetProperty()->SetAmbient(0.2);
  s.Actor->GetProperty()->SetDiffuse(0.7);
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetScalarModeToUsePointFieldData();
  s.Mapper->SelectColorArray("height");
  s.Mapper->SetLookupTable(RedToBlue(256));
  s.Mapper->SetScalarRange(-20, 20);
  vtkNew<vtkUnsignedCharArray> ours, theirs;
  s.Draw();
  s.Window->GetPixelData(0, 0, 119, 99, 1, ours);
  vtkNew<vtkFlyingEdges3D> mesh;
  mesh->SetInputData(s.Mapper->GetImage());
  mesh->SetValue(0, 0);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputConnection(mesh->GetOutputPort());
  probe->SetSourceData(s.Mapper->GetImage());
  probe->PassPointArraysOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(probe->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("height");
  mapper->SetLookupTable(s.Mapper->GetLookupTable());
  mapper->SetScalarRange(-20, 20);
  s.Actor->SetMapper(mapper);
  s.Window->Render();
  s.Window->GetPixelData(0, 0, 119, 99, 1, theirs);
  int seen = 0;
  double difference = 0.0;
  for (vtkIdType n = 0; n < ours->GetNumberOfValues(); ++n)
    if (ours->GetValue(n) > 0 && theirs->GetValue(n) > 0)
    {
      ++seen;
      difference += std::abs(ours->GetValue(n) - theirs->GetValue(n));
    }
  EXPECT_GT(seen, 1500);
  EXPECT_LT(difference / seen, 3.0); // their normals are interpolated, ours the gradient's
}

TEST_F(CellColors, WhatIsNotThereIsAnErrorAndNothingIsDrawn)
{
  struct Counter : vtkCommand
  {
    int Count = 0;
    void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
  };
  auto errors = vtkSmartPointer<Counter>::Take(new Counter);
  AttributeScene s;
  s.Mapper->AddObserver(vtkCommand::ErrorEvent, errors);
  s.Mapper->ScalarVisibilityOn();
  s.Mapper->SetScalarModeToUsePointFieldData();
  s.Mapper->SelectColorArray("nothing");
  EXPECT_EQ(s.Covered(), 0);
  EXPECT_GT(errors->Count, 0);
  errors->Count = 0;
  vtkNew<vtkFloatArray> values;
  values->SetName("cells");
  values->SetNumberOfTuples(40 * 40 * 40);
  s.Mapper->GetImage()->GetCellData()->SetScalars(values);
  s.Mapper->SetScalarModeToUseCellData();
  EXPECT_EQ(s.Covered(), 0);
  EXPECT_GT(errors->Count, 0);
  s.Mapper->SetScalarModeToDefault();
  EXPECT_GT(s.Covered(), 100);
}

} // namespace
