// Traced cells in several passes of a frame: what did not change is neither traced nor uploaded.
#include "CellTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{

using hasp::testing::CellTestScene;

#if HASP_WITH_EMBREE

constexpr int Pixels = 80;

/// A ball, traced, in two layers of a window: the second is drawn over the first, from the same
/// place.
struct TwoLayers : CellTestScene
{
  vtkNew<vtkRenderer> Over;
  std::function<void()> Between; ///< called when the second layer begins

  TwoLayers() : CellTestScene(Pixels, Pixels)
  {
    const hasp::GridGeometry g{ { 40, 40, 40 }, glm::dvec3(-19.5), { 1, 1, 1 }, glm::dmat3(1) };
    this->Mapper->SetInputData(hasp::MakeImage(
      g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 15), g, 100, 0)));
    this->Mapper->SetRendererToTrace();
    this->Look({ 0, -80, 0 }, { 0, 0, 0 }, 40, 120);
    this->Over->SetActiveCamera(this->Renderer->GetActiveCamera());
    this->Over->AddActor(this->Actor);
    this->Over->SetLayer(1);
    this->Window->SetNumberOfLayers(2);
    this->Window->AddRenderer(this->Over);
    vtkNew<vtkCallbackCommand> begins;
    begins->SetClientData(this);
    begins->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*)
      {
        if (const auto& call = static_cast<TwoLayers*>(self)->Between)
          call();
      });
    this->Over->AddObserver(vtkCommand::StartEvent, begins);
  }

  double Milliseconds(const std::string& name)
  {
    hasp::ResourceList list;
    this->Mapper->ListResources(list);
    for (const auto& use : list)
      if (use.resource == name)
        return use.milliseconds;
    ADD_FAILURE() << name;
    return -1.0;
  }
  double Picture() { return this->Milliseconds("traced picture"); }

  void Pick()
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(0, 0, Pixels - 1, Pixels - 1);
    selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
    ASSERT_TRUE(selector->CaptureBuffers());
    const unsigned middle[2] = { Pixels / 2, Pixels / 2 };
    EXPECT_GE(selector->GetPixelInformation(middle).AttributeID, 0);
  }
};

class TracedCellUploads : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

TEST_F(TracedCellUploads, CellsThatEachFrameRasterisesOnceStay)
{
  TwoLayers scene;
  vtkNew<vtkActor> glass; // always rasterised; the layers' actor is traced twice
  glass->SetMapper(scene.Mapper);
  glass->GetProperty()->SetOpacity(0.3);
  glass->SetPosition(8, 0, 0);
  scene.Renderer->AddActor(glass);
  scene.Draw();
  const double once = scene.Milliseconds("active cells, GPU");
  EXPECT_GT(once, 0.0);
  for (int n = 0; n < 4; ++n)
  {
    scene.Draw();
    EXPECT_EQ(scene.Milliseconds("active cells, GPU"), once) << "cells were uploaded again, " << n;
  }
  glass->VisibilityOff();
  scene.Draw();
  scene.Draw();
  hasp::ResourceList list;
  scene.Mapper->ListResources(list);
  for (const auto& use : list)
    if (use.resource == "active cells, GPU")
    {
      EXPECT_EQ(use.bytes, 0U) << "nobody rasterised for a whole frame";
    }
}

TEST_F(TracedCellUploads, AFrameTracesAViewOnce)
{
  TwoLayers scene;
  double before = 0.0;
  scene.Between = [&] { before = scene.Picture(); };
  for (int n = 0; n < 3; ++n)
  {
    const double last = scene.Picture();
    scene.Draw();
    EXPECT_NE(before, last) << "a new frame is a new picture, " << n;
    EXPECT_EQ(scene.Picture(), before) << "traced or uploaded again, " << n;
    EXPECT_TRUE(scene.Point(Pixels / 2, Pixels / 2).has_value());
  }
  // The second layer looks from another place.
  scene.Between = [&]
  {
    before = scene.Picture();
    scene.Renderer->GetActiveCamera()->SetPosition(0, -70, 0);
  };
  scene.Draw();
  EXPECT_NE(scene.Picture(), before);
  const auto point = scene.Point(Pixels / 2, Pixels / 2);
  ASSERT_TRUE(point.has_value());
  EXPECT_NEAR(glm::length(*point), 15, 0.1);
}

TEST_F(TracedCellUploads, APickUsesThePictureThatWasLookedAt)
{
  TwoLayers scene;
  scene.Window->RemoveRenderer(scene.Over); // which nobody picks in
  scene.Draw();
  scene.Pick(); // uploads cell numbers
  const double picked = scene.Picture();
  scene.Pick();
  EXPECT_EQ(scene.Picture(), picked) << "traced or uploaded again";
  scene.Mapper->SetIsoValue(500.0);
  scene.Pick();
  EXPECT_NE(scene.Picture(), picked) << "of other cells";
  const double smaller = scene.Picture();
  scene.Look({ 0, -90, 0 }, { 0, 0, 0 }, 40, 120);
  scene.Pick();
  EXPECT_NE(scene.Picture(), smaller) << "of another view";
}

#endif

} // namespace
