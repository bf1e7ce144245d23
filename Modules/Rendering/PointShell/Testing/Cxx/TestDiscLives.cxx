// What is made when, for whom, and what it takes to be refused.
#include "DiscScene.h"
#include "Haptics/PointShell.h"
#include "HaspGL.h"

#include "vtkDataArray.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTextureUnitManager.h"

#include <gtest/gtest.h>

#include <utility>

namespace
{
using hasp::testing::DiscScene;
using hasp::testing::SphereDiscs;

std::shared_ptr<const hasp::PointShell> SphereShell(int count)
{
  std::vector<hasp::SurfacePoint> points;
  const auto discs = SphereDiscs(count, 20);
  for (const hasp::ShellDisc& disc : *discs)
    points.push_back({ disc.center, disc.normal });
  return hasp::PointShell::OfPoints(
    points, 4 * std::numbers::pi * 400, glm::dvec3(0.0), { count, 64, 1 });
}

struct Held
{
  std::size_t bytes = 0;
  double milliseconds = 0.0;
  std::string discs; ///< the reason
};

Held HeldBy(vtkHaspPointShellMapper* mapper)
{
  hasp::ResourceList list;
  mapper->ListResources(list);
  Held held;
  for (const hasp::ResourceUse& use : list)
  {
    held.bytes += use.bytes;
    held.milliseconds += use.milliseconds;
    if (use.resource == "discs, GPU")
      held.discs = use.reason;
  }
  return held;
}

int Lit(const std::vector<glm::ivec3>& colors)
{
  int lit = 0;
  for (const glm::ivec3& color : colors)
    lit += color != glm::ivec3(0);
  return lit;
}

TEST(DiscLives, NothingIsMadeUntilThereIsADisc)
{
  DiscScene scene;
  EXPECT_EQ(Lit(scene.Colors()), 0);
  scene.Mapper->SetDiscs(std::make_shared<std::vector<hasp::ShellDisc>>());
  EXPECT_EQ(Lit(scene.Colors()), 0);
  EXPECT_EQ(HeldBy(scene.Mapper).bytes, 0U);
  EXPECT_EQ(HeldBy(scene.Mapper).milliseconds, 0.0);
  EXPECT_EQ(HeldBy(scene.Mapper).discs, "no disc was drawn");
  EXPECT_GT(scene.Mapper->GetBounds()[0], scene.Mapper->GetBounds()[1]); // uninitialised
  scene.Mapper->SetDiscs(SphereDiscs(256, 20));
  EXPECT_GT(Lit(scene.Colors()), 5000);
  EXPECT_GT(HeldBy(scene.Mapper).bytes, 200U * 200U * 4U);
}

/// Names that OpenGL knows in the current context.
int Alive()
{
  int alive = 0;
  for (GLuint name = 1; name < 2000; ++name)
    alive += glIsBuffer(name) + glIsTexture(name) + glIsVertexArray(name) + glIsFramebuffer(name);
  return alive;
}

TEST(DiscLives, NothingIsLeftInOpenGLOfWhatIsReleased)
{
  DiscScene scene;
  scene.Window->Render();
  const int before = Alive();
  for (const bool levels : { false, true })
  {
    scene.Mapper->SetColorByLevel(levels);
    scene.Mapper->SetDiscs(
      SphereDiscs(levels ? 900 : 256, 20)); // the second does not fit the first
    scene.Window->Render();
    EXPECT_GT(Alive(), before + 5);
  }
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  scene.Window->MakeCurrent();
  EXPECT_EQ(Alive(), before);
}

TEST(DiscLives, WhatIsReleasedIsGoneAndComesBack)
{
  DiscScene scene;
  scene.Mapper->SetDiscs(SphereDiscs(256, 20));
  const auto before = scene.Colors();
  scene.Mapper->ReleaseGraphicsResources(scene.Window);
  EXPECT_EQ(HeldBy(scene.Mapper).bytes, 0U);
  EXPECT_EQ(scene.Colors(), before);
  scene.Window->Finalize();
  EXPECT_EQ(HeldBy(scene.Mapper).bytes, 0U);
  EXPECT_TRUE(scene.Errors.empty());
}

TEST(DiscLives, OpenGLIsLeftAsItWasFound)
{
  const auto state = []
  {
    std::vector<GLint> all;
    for (const GLenum name :
      { GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_MULTISAMPLE, GL_SCISSOR_TEST })
      all.push_back(glIsEnabled(name));
    for (const GLenum name : { GL_ACTIVE_TEXTURE, GL_BLEND_DST_ALPHA, GL_BLEND_DST_RGB,
           GL_BLEND_SRC_ALPHA, GL_BLEND_SRC_RGB, GL_DEPTH_FUNC, GL_DEPTH_WRITEMASK,
           GL_DRAW_FRAMEBUFFER_BINDING, GL_VERTEX_ARRAY_BINDING, GL_TEXTURE_BUFFER })
      glGetIntegerv(name, &all.emplace_back());
    for (GLenum unit = 0; unit < 8; ++unit) // the active one is restored
    {
      glActiveTexture(GL_TEXTURE0 + unit);
      glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &all.emplace_back());
    }
    glActiveTexture(static_cast<GLenum>(all[5]));
    return all;
  };
  DiscScene scene;
  scene.Mapper->SetDiscs(SphereDiscs(256, 20));
  EXPECT_GT(Lit(scene.Colors()), 5000);
  vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetRenderFramebuffer()->Bind();
  for (const bool levels : { false, true })
  {
    scene.Mapper->SetColorByLevel(levels);
    scene.Mapper->SetDiscs(SphereDiscs(levels ? 900 : 600, 20)); // with an upload
    const auto before = state();
    scene.Mapper->Render(scene.Renderer, scene.Actor);
    EXPECT_EQ(state(), before) << levels;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  }
}

// Where no unit is left for the last texture, the ones before it are given back.
TEST(DiscLives, TextureUnitsAreGivenBack)
{
  DiscScene scene;
  scene.Window->Render();
  vtkTextureUnitManager* units =
    vtkOpenGLRenderWindow::SafeDownCast(scene.Window)->GetTextureUnitManager();
  std::vector<int> taken;
  const auto takeAll = [&]
  {
    for (int unit = units->Allocate(); unit >= 0; unit = units->Allocate())
      taken.push_back(unit);
    return taken.size();
  };
  const auto giveBack = [&](std::size_t left)
  {
    for (; taken.size() > left; taken.pop_back())
      units->Free(taken.back());
  };
  const std::size_t all = takeAll();
  ASSERT_GT(all, 8U);
  giveBack(0);
  scene.Mapper->SetDiscs(SphereDiscs(600, 20));
  scene.Mapper->ColorByLevelOn();
  EXPECT_GT(Lit(scene.Colors()), 5000);
  EXPECT_EQ(takeAll(), all);
  EXPECT_TRUE(scene.Errors.empty());
  giveBack(all - 1);
  scene.Mapper->Render(scene.Renderer, scene.Actor);
  ASSERT_EQ(scene.Errors.size(), 1U);
  EXPECT_NE(scene.Errors[0].find("no texture unit"), std::string::npos) << scene.Errors[0];
  giveBack(0);
  EXPECT_EQ(takeAll(), all);
  giveBack(0);
  EXPECT_GT(Lit(scene.Colors()), 5000);
}

// No window has room for 64 TiB.
TEST(DiscLives, WhereTheGPUHasNoRoomThereIsAWordAndNoPicture)
{
  static decltype(glBufferData) whole = nullptr;
  DiscScene scene;
  scene.Window->Render();
  scene.Mapper->SetDiscs(SphereDiscs(600, 20));
  whole = std::exchange(glBufferData, [](GLenum target, GLsizeiptr, const void* data, GLenum use)
    { whole(target, GLsizeiptr{ 1 } << 46, data, use); });
  scene.Mapper->Render(scene.Renderer, scene.Actor);
  scene.Mapper->Render(scene.Renderer, scene.Actor);
  glBufferData = whole;
  ASSERT_EQ(scene.Errors.size(), 1U);
  EXPECT_NE(scene.Errors[0].find("no room"), std::string::npos) << scene.Errors[0];
  EXPECT_EQ(HeldBy(scene.Mapper).bytes, 0U);
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  EXPECT_GT(Lit(scene.Colors()), 5000) << "it is tried again";
  EXPECT_EQ(scene.Errors.size(), 1U);
}

TEST(DiscLives, TwoWindowsShareAMapper)
{
  DiscScene scene, other;
  scene.Mapper->SetDiscs(SphereDiscs(256, 20));
  other.Actor->SetMapper(scene.Mapper);
  const auto first = scene.Colors();
  const std::size_t one = HeldBy(scene.Mapper).bytes;
  EXPECT_EQ(other.Colors(), first);
  EXPECT_EQ(HeldBy(scene.Mapper).bytes, 2 * one);
  scene.Mapper->SetDiscs(SphereDiscs(512, 15));
  const auto next = other.Colors();
  EXPECT_NE(next, first);
  EXPECT_EQ(scene.Colors(), next);
  other.Window->Finalize();
  EXPECT_LE(HeldBy(scene.Mapper).bytes, one + 512 * 40);
  EXPECT_EQ(scene.Colors(), next);
  EXPECT_TRUE(scene.Errors.empty());
}

TEST(DiscLives, DynamicDiscsAreDrawnAsAStaticShell)
{
  DiscScene scene;
  const auto shell = SphereShell(1024);
  scene.Mapper->SetPointShell(shell);
  scene.Mapper->SetLevels(2);
  const auto drawn = scene.Colors();
  auto discs = std::make_shared<std::vector<hasp::ShellDisc>>(shell->LevelEnd(1));
  std::uint32_t count = 0;
  for (int level = 0; level < 2; ++level)
    count += hasp::CopyDiscs(shell->Level(level), level, std::span(*discs).subspan(count));
  ASSERT_EQ(count, discs->size());
  for (hasp::ShellDisc& disc : *discs) // what a point stands for when level 1 is the last
    disc.areaMm2 = static_cast<float>(shell->SurfaceArea() / count);
  scene.Mapper->SetDiscs(discs);
  EXPECT_EQ(scene.Colors(), drawn);
  EXPECT_GT(Lit(drawn), 5000);
  scene.Mapper->SetPointShell(shell); // all levels have other discs
  scene.Mapper->SetLevels(0);
  EXPECT_EQ(scene.Mapper->GetNumberOfDiscs(), 1024);
  EXPECT_NE(scene.Colors(), drawn);
}

TEST(DiscLives, ChangedDiscsAloneAreUploaded)
{
  DiscScene scene;
  auto discs = SphereDiscs(4096, 20);
  scene.Mapper->SetDiscs(discs);
  const auto before = scene.Colors();
  EXPECT_EQ(HeldBy(scene.Mapper).discs, "4096 uploaded last");
  auto moved = std::make_shared<std::vector<hasp::ShellDisc>>(*discs);
  (*moved)[10].center *= 1.5F; // towards the eye; in the first block of 256
  (*moved)[4000].areaMm2 *= 2;
  scene.Mapper->SetDiscs(moved);
  const auto after = scene.Colors();
  EXPECT_EQ(HeldBy(scene.Mapper).discs, "512 uploaded last");
  EXPECT_NE(after, before);
  DiscScene fresh;
  fresh.Mapper->SetDiscs(moved);
  EXPECT_EQ(fresh.Colors(), after);
  for (const int count : { 100, 3000, 4097, 9000, 1 }) // fewer, more, and what is left over
  {
    const auto next = SphereDiscs(count, 18);
    scene.Mapper->SetDiscs(next);
    fresh.Mapper->SetDiscs(nullptr);
    fresh.Mapper->ReleaseGraphicsResources(fresh.Window);
    fresh.Mapper->SetDiscs(next);
    EXPECT_EQ(scene.Colors(), fresh.Colors()) << count;
  }
}

TEST(DiscLives, PointsWithNormalsAreDrawn)
{
  DiscScene scene;
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  vtkNew<vtkFloatArray> normals, areas;
  normals->SetNumberOfComponents(3);
  areas->SetName("share");
  const auto discs = SphereDiscs(1024, 20);
  for (const hasp::ShellDisc& disc : *discs)
  {
    places->InsertNextPoint(disc.center.x, disc.center.y, disc.center.z);
    normals->InsertNextTuple3(2 * disc.normal.x, 2 * disc.normal.y, 2 * disc.normal.z);
    areas->InsertNextValue(disc.areaMm2);
  }
  points->SetPoints(places);
  points->GetPointData()->SetNormals(normals);
  points->GetPointData()->AddArray(areas);
  scene.Mapper->SetInputDataObject(points);
  const int estimated = Lit(scene.Colors());
  scene.Mapper->SetAreaArrayName("share");
  const int given = Lit(scene.Colors());
  EXPECT_GT(given, 5000);
  EXPECT_NEAR(estimated, given, 0.02 * given); // rims stand out a little more or less
  DiscScene same;
  same.Mapper->SetDiscs(discs);
  EXPECT_NEAR(Lit(same.Colors()), given, 2);
  EXPECT_TRUE(scene.Errors.empty());
}

TEST(DiscLives, WhatIsWrongIsRefusedOnce)
{
  const auto wrong = [](const auto& break_)
  {
    auto discs = SphereDiscs(64, 20);
    break_((*discs)[7]);
    return discs;
  };
  const struct
  {
    std::shared_ptr<std::vector<hasp::ShellDisc>> discs;
    const char* said;
  } cases[] = {
    { wrong([](auto& d) { d.center.y = NAN; }), "disc 7 of 64 is not finite" },
    { wrong([](auto& d) { d.areaMm2 = INFINITY; }), "disc 7 of 64 is not finite" },
    { wrong([](auto& d) { d.areaMm2 = -1; }), "disc 7 of 64 has an area of -1" },
    { wrong([](auto& d) { d.normal *= 3; }), "disc 7 of 64 has a normal of length 3" },
    { wrong([](auto& d) { d.normal.x = NAN; }), "disc 7 of 64 has a normal of length" },
  };
  for (const auto& one : cases)
  {
    DiscScene scene;
    scene.Mapper->SetDiscs(one.discs);
    EXPECT_EQ(Lit(scene.Colors()) + Lit(scene.Colors()), 0) << one.said;
    ASSERT_EQ(scene.Errors.size(), 1U) << one.said;
    EXPECT_NE(scene.Errors[0].find(one.said), std::string::npos) << scene.Errors[0];
    scene.Mapper->SetDiscs(SphereDiscs(64, 20));
    EXPECT_GT(Lit(scene.Colors()), 5000);
    EXPECT_EQ(scene.Errors.size(), 1U);
  }
}

TEST(DiscLives, ArraysTooShortForThePointsAreRefused)
{
  for (const bool normalsToo : { true, false })
  {
    DiscScene scene;
    vtkNew<vtkPolyData> points;
    vtkNew<vtkPoints> places;
    vtkNew<vtkFloatArray> normals, areas;
    normals->SetNumberOfComponents(3);
    areas->SetName("share");
    for (int n = 0; n < 20; ++n)
    {
      places->InsertNextPoint(n, 0, 0);
      if (n < 10 || normalsToo)
        normals->InsertNextTuple3(0, 0, 1);
    }
    areas->InsertNextValue(1);
    points->SetPoints(places);
    points->GetPointData()->SetNormals(normals);
    points->GetPointData()->AddArray(areas);
    scene.Mapper->SetAreaArrayName("share");
    scene.Mapper->SetInputDataObject(points);
    EXPECT_EQ(Lit(scene.Colors()), 0);
    ASSERT_EQ(scene.Errors.size(), 1U);
    EXPECT_NE(scene.Errors[0].find(normalsToo ? "1 areas for 20 points" : "10 normals for 20"),
      std::string::npos)
      << scene.Errors[0];
  }
}

TEST(DiscLives, PointsWithoutNormalsAreRefused)
{
  DiscScene scene;
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(20);
  ball->GenerateNormalsOff();
  scene.Mapper->SetInputConnection(ball->GetOutputPort());
  EXPECT_EQ(Lit(scene.Colors()), 0);
  ASSERT_EQ(scene.Errors.size(), 1U);
  EXPECT_NE(scene.Errors[0].find("no normals"), std::string::npos) << scene.Errors[0];
  ball->GenerateNormalsOn();
  EXPECT_GT(Lit(scene.Colors()), 3000);
  EXPECT_EQ(scene.Errors.size(), 1U);
}

} // namespace
