// Discs among other things: opaque actors, translucency, clipping planes, eyes, picks.
#include "DiscScene.h"

#include "vtkDataSetMapper.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

namespace
{
using hasp::testing::DiscScene;
using hasp::testing::Pixel;
using hasp::testing::SphereDiscs;

/// As white as it is, whatever the light.
void Unlit(vtkActor* actor)
{
  actor->GetProperty()->LightingOff();
}

TEST(DiscNeighbours, AnOpaqueActorCutsThemWhereItStands)
{
  DiscScene scene(300);
  scene.Look({ 0, -60, 80 }, { 0, 0, 1 });
  scene.Mapper->SetDiscs(SphereDiscs(16'384, 20));
  vtkNew<vtkPlaneSource> plate; // z = 4
  plate->SetOrigin(-40, -40, 4);
  plate->SetPoint1(40, -40, 4);
  plate->SetPoint2(-40, 40, 4);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(plate->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1, 0, 0);
  Unlit(actor);
  scene.Actor->GetProperty()->SetColor(0, 1, 0);
  Unlit(scene.Actor);
  scene.Renderer->AddActor(actor);
  const std::vector<Pixel> pixels = scene.Draw();
  const std::vector<glm::ivec3> colors = scene.Colors();
  int balls = 0, plates = 0;
  for (std::size_t n = 0; n < pixels.size(); ++n)
  {
    const Pixel& pixel = pixels[n];
    const auto onBall = pixel.OnSphere(20.0);
    if (!onBall || pixel.Miss() > 19.5) // the rim may stand out
      continue;
    const double toPlate = (4.0 - pixel.from.z) / pixel.direction.z;
    const double toBall = glm::distance(*onBall, pixel.from);
    if (std::abs(toPlate - toBall) < 0.1) // mm; discs stand 0.008 out, along the ray some more
      continue;
    const bool ball = toBall < toPlate;
    EXPECT_EQ(colors[n], ball ? glm::ivec3(0, 255, 0) : glm::ivec3(255, 0, 0));
    (ball ? balls : plates) += 1;
  }
  EXPECT_GT(balls, 3000);
  EXPECT_GT(plates, 3000);
}

TEST(DiscNeighbours, ATranslucentShellShowsItsNearestLayerAlone)
{
  for (const bool peeling : { false, true })
  {
    DiscScene scene;
    scene.Renderer->SetUseDepthPeeling(peeling);
    scene.Mapper->SetDiscs(SphereDiscs(4096, 20));
    scene.Actor->GetProperty()->SetColor(1, 1, 1);
    scene.Actor->GetProperty()->SetOpacity(0.5);
    Unlit(scene.Actor);
    int inside = 0;
    const std::vector<glm::ivec3> colors = scene.Colors();
    DiscScene opaque;
    opaque.Mapper->SetDiscs(SphereDiscs(4096, 20));
    const std::vector<Pixel> pixels = opaque.Draw();
    for (std::size_t n = 0; n < pixels.size(); ++n)
      if (pixels[n].hit)
      {
        ++inside;
        EXPECT_NEAR(colors[n].x, 127.5, 1.5) << peeling; // two layers: 191
      }
      else
        EXPECT_EQ(colors[n], glm::ivec3(0));
    EXPECT_GT(inside, 5000);
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST(DiscNeighbours, ClippingPlanesTakeWhatIsBehindThem)
{
  DiscScene scene;
  scene.Mapper->SetDiscs(SphereDiscs(4096, 20));
  scene.Actor->SetPosition(1, 0, 0); // planes are in the world
  for (const double side : { 1.0, -1.0 })
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(side, 0, 0);
    plane->SetOrigin(5, 0, 0);
    scene.Mapper->RemoveAllClippingPlanes();
    scene.Mapper->AddClippingPlane(plane);
    int kept = 0;
    for (const Pixel& pixel : scene.Draw())
      if (pixel.hit)
      {
        ++kept;
        // Blended depth is between two hits that were kept, a rim's height apart.
        EXPECT_GE(side * (pixel.hit->x - 5.0), -0.05);
      }
    EXPECT_GT(kept, 2000);
  }
}

TEST(DiscNeighbours, CullingTakesTheFacesThatPointAway)
{
  DiscScene scene;
  scene.Mapper->SetDiscs(SphereDiscs(4096, 20));
  scene.Actor->GetProperty()->BackfaceCullingOn();
  for (const Pixel& pixel : scene.Draw())
    if (pixel.Miss() < 19.0)
    {
      EXPECT_TRUE(pixel.hit && glm::dot(*pixel.hit, pixel.direction) < 0.0);
    }
  scene.Actor->GetProperty()->BackfaceCullingOff();
  scene.Actor->GetProperty()->FrontfaceCullingOn();
  for (const Pixel& pixel : scene.Draw())
    if (pixel.Miss() < 19.0)
    {
      EXPECT_TRUE(pixel.hit && glm::dot(*pixel.hit, pixel.direction) > 0.0);
    }
}

TEST(DiscNeighbours, BothEyesSeeWhatAMeshShows)
{
  DiscScene scene, rival;
  scene.Mapper->SetDiscs(SphereDiscs(16'384, 20));
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(20);
  ball->SetThetaResolution(200);
  ball->SetPhiResolution(200);
  vtkNew<vtkDataSetMapper> mesh;
  mesh->SetInputConnection(ball->GetOutputPort());
  rival.Actor->SetMapper(mesh);
  std::vector<std::vector<glm::ivec3>> seen;
  for (const int eye : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    int differ = 0, missing = 0;
    for (DiscScene* one : { &scene, &rival })
    {
      Unlit(one->Actor);
      one->Window->StereoCapableWindowOn();
      one->Window->SetStereoType(eye);
      one->Window->StereoRenderOn();
      one->Renderer->GetActiveCamera()->SetEyeAngle(8);
      one->Actor->SetPosition(0, 0, 15); // before the plane where the eyes agree
    }
    seen.push_back(scene.Colors());
    const auto other = rival.Colors();
    for (std::size_t n = 0; n < other.size(); ++n)
    {
      differ += seen.back()[n] != other[n];
      missing += seen.back()[n] == glm::ivec3(0) && other[n] != glm::ivec3(0);
    }
    EXPECT_EQ(missing, 0) << eye;  // discs stand out, and the filter widens them: on all sides
    EXPECT_LE(differ, 580) << eye; // a pixel around the silhouette; the other eye: 1700
  }
  EXPECT_NE(seen[0], seen[1]);
}

TEST(DiscNeighbours, PicksGiveTheActorAndTheDisc)
{
  DiscScene scene;
  const auto discs = SphereDiscs(300, 20);
  scene.Mapper->SetDiscs(discs);
  scene.Window->Render();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  selector->SetArea(100, 100, 100, 100);
  vtkSmartPointer<vtkSelection> picked;
  picked.TakeReference(selector->Select());
  ASSERT_EQ(picked->GetNumberOfNodes(), 1U);
  vtkSelectionNode* node = picked->GetNode(0);
  EXPECT_EQ(node->GetProperties()->Get(vtkSelectionNode::PROP()), scene.Actor);
  auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
  ASSERT_TRUE(ids && ids->GetNumberOfTuples() == 1);
  const glm::vec3 center = (*discs)[ids->GetValue(0)].center;
  EXPECT_LT(glm::distance(center, glm::vec3(0, 0, 20)), 3.0F) << ids->GetValue(0); // 2.1 apart
  selector->SetArea(5, 5, 5, 5);
  picked.TakeReference(selector->Select());
  EXPECT_EQ(picked->GetNumberOfNodes(), 0U);
}

TEST(DiscNeighbours, LevelsHaveTheirColors)
{
  DiscScene scene;
  auto discs = hasp::testing::PlaneDiscs(40);
  for (hasp::ShellDisc& disc : *discs)
    disc.level = disc.center.x < 0 ? 9 : 2; // 9 has the colour of 1
  scene.Mapper->SetDiscs(discs);
  scene.Mapper->ColorByLevelOn();
  Unlit(scene.Actor);
  const std::vector<Pixel> pixels = scene.Draw();
  const std::vector<glm::ivec3> colors = scene.Colors();
  int seen = 0;
  for (std::size_t n = 0; n < pixels.size(); ++n)
    if (pixels[n].hit && std::abs(pixels[n].hit->x) > 2.0)
    {
      double rgb[3];
      vtkHaspPointShellMapper::GetLevelColor(pixels[n].hit->x < 0 ? 1 : 2, rgb);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(colors[n][c], 255 * rgb[c], 1.0);
      ++seen;
    }
  EXPECT_GT(seen, 5000);
}

} // namespace
