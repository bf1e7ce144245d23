// Active cells below OpenGL 4.3: what rays on the CPU meet is drawn, true to the last digit; what
// takes 4.3 is refused by name.
#include "OlderOpenGLScene.h"

#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkPointData.h"

namespace
{

using hasp::testing::FindResource;
using hasp::testing::OlderOpenGL;
using hasp::testing::OlderScene;
using hasp::testing::RaycastScene;

/// Else the tests below would show nothing: no later shader compiles here.
TEST_F(OlderOpenGL, HasNoLaterShaders)
{
  const GLuint shader = glCreateShader(GL_VERTEX_SHADER);
  const char* text = "#version 430 core\nvoid main() { gl_Position = vec4(0.0); }\n";
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_TRUE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  EXPECT_FALSE(compiled) << "the version of GLSL was not set, or a cache had the shader";
  glDeleteShader(shader);
}

#if HASP_WITH_EMBREE

TEST_F(OlderOpenGL, ActiveCellsAreTraced)
{
  OlderScene& scene = *this->Scene;
  for (const int renderer :
    { vtkHaspClusteredCellMapper::Automatic, vtkHaspClusteredCellMapper::Trace })
  {
    scene.Mapper->SetRenderer(renderer);
    for (int frame = 0; frame < 7; ++frame) // as many as would be measured
      scene.Draw();
    this->ExpectTruth();
    EXPECT_EQ(scene.Mapper->GetRendererChoice(),
      "traced: " + (renderer == vtkHaspClusteredCellMapper::Trace ? "as asked for"
                                                                  : this->Lack("rasterising")));
    EXPECT_EQ(FindResource(scene.Mapper, "active cells, GPU").bytes, 0U);
  }
  this->ExpectNothingSaid();
}

TEST_F(OlderOpenGL, TheTreeIsKeptFromFrameToFrame)
{
  OlderScene& scene = *this->Scene;
  const auto tree = FindResource(scene.Mapper, "ray tracing tree");
  EXPECT_GT(tree.bytes, 0U);
  scene.Look({ 50, -90, 30 }, { 0, 0, 0 }, 20, 200);
  scene.Draw();
  EXPECT_EQ(FindResource(scene.Mapper, "ray tracing tree").milliseconds, tree.milliseconds);
  this->ExpectTruth();
}

/// In the light of the camera a matt surface is as bright as its true normal faces the eye.
TEST_F(OlderOpenGL, ColorsAreThoseOfTheFormula)
{
  OlderScene& scene = *this->Scene;
  scene.Actor->GetProperty()->SetColor(1.0, 0.8, 0.5);
  const glm::dvec3 eye(60, -80, 40), color(1.0, 0.8, 0.5);
  scene.Look(eye, { 0, 0, 0 }, 20, 200);
  const std::vector<unsigned char> drawn = scene.Colors();
  const auto truth = scene.Truth();
  int compared = 0, others = 0;
  for (std::size_t pixel = 0; pixel < truth.size(); ++pixel)
  {
    if (!truth[pixel])
      continue;
    const glm::dvec3 normal = glm::normalize(truth[pixel]->gradient);
    const bool seenFromInside = glm::dot(normal, eye - truth[pixel]->position) > 0.0;
    const double facing = glm::dot(seenFromInside ? normal : -normal, glm::normalize(eye));
    ++compared;
    for (int c = 0; c < 3; ++c)
    {
      const double expected = 255.0 * color[c] * (0.1 + 0.9 * std::max(facing, 0.0));
      others += std::abs(drawn[3 * pixel + c] - expected) > 1.0; // half a level, and floats
    }
  }
  EXPECT_GT(compared, 3000);
  EXPECT_LE(others, 3 * compared / 500); // a hit on the face between two cells has either's normal
  this->ExpectNothingSaid();
}

TEST_F(OlderOpenGL, PicksGiveTheCellsThatAreSeen)
{
  OlderScene& scene = *this->Scene;
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, RaycastScene::PixelsX - 1, RaycastScene::PixelsY - 1);
  selector->SetFieldAssociation(vtkDataObject::FIELD_ASSOCIATION_CELLS);
  ASSERT_TRUE(selector->CaptureBuffers());
  const auto truth = scene.Truth();
  int hits = 0, others = 0;
  for (unsigned y = 0; y < RaycastScene::PixelsY; ++y)
    for (unsigned x = 0; x < RaycastScene::PixelsX; ++x)
    {
      const unsigned pixel[2] = { x, y };
      const auto picked = selector->GetPixelInformation(pixel);
      const auto& met = truth[y * RaycastScene::PixelsX + x];
      EXPECT_EQ(picked.Valid, met.has_value()) << x << " " << y;
      int ijk[3];
      if (!met || !scene.Mapper->GetCellIndex(picked.AttributeID, ijk))
        continue;
      ++hits;
      others += glm::ivec3(ijk[0], ijk[1], ijk[2]) != met->cell;
    }
  EXPECT_GT(hits, 3000);
  EXPECT_LE(others, hits / 500); // a hit on the face between two cells is either's
  this->ExpectNothingSaid();
}

TEST_F(OlderOpenGL, RasterisingIsRefusedUntilTracingIsAskedFor)
{
  this->Scene->Mapper->SetRendererToRasterize();
  this->ExpectRefused("the renderer automatic traces rays on the CPU instead");
  EXPECT_EQ(FindResource(this->Scene->Mapper, "ray tracing tree").bytes, 0U);
  this->Scene->Mapper->SetRendererToAutomatic();
  this->Scene->Draw();
  this->ExpectTruth();
  this->ExpectNothingSaid();
}

TEST_F(OlderOpenGL, WhatIsNotTracedIsRefused)
{
  OlderScene& scene = *this->Scene;
  vtkImageData* image = scene.Raycaster->GetImage();
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("labels");
  labels->SetNumberOfValues(image->GetNumberOfPoints());
  labels->FillValue(1);
  image->GetPointData()->AddArray(labels);
  vtkNew<vtkFloatArray> depth;
  depth->SetName("depth");
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
    depth->InsertNextValue(static_cast<float>(n));
  image->GetPointData()->AddArray(depth);
  const int before = scene.Pixels();
  const std::vector<std::pair<std::function<void()>, std::function<void()>>> wishes = {
    { [&] { scene.Actor->GetProperty()->SetOpacity(0.5); },
      [&] { scene.Actor->GetProperty()->SetOpacity(1.0); } },
    { [&] { scene.Mapper->BlendNormalsOn(); }, [&] { scene.Mapper->BlendNormalsOff(); } },
    { [&]
      {
        scene.Mapper->SetLabelArrayName("labels");
        scene.Mapper->SetLabelColor(1, 1, 0, 0);
      },
      [&] { scene.Mapper->ClearLabels(); } },
    { [&]
      {
        scene.Mapper->SetScalarModeToUsePointFieldData();
        scene.Mapper->SelectColorArray("depth");
        scene.Mapper->ScalarVisibilityOn();
      },
      [&] { scene.Mapper->ScalarVisibilityOff(); } },
  };
  for (std::size_t n = 0; n < wishes.size(); ++n)
    for (const int renderer :
      { vtkHaspClusteredCellMapper::Automatic, vtkHaspClusteredCellMapper::Trace })
    {
      SCOPED_TRACE(n);
      scene.Mapper->SetRenderer(renderer);
      wishes[n].first();
      this->ExpectRefused(n == 0 ? "translucent surfaces are drawn in no other way"
                                 : "labels, scalar colours and blended normals are drawn in no "
                                   "other way");
      const bool mayBecomeOpaque = n == 0 && renderer == vtkHaspClusteredCellMapper::Trace;
      EXPECT_EQ(FindResource(scene.Mapper, "ray tracing tree").bytes > 0, mayBecomeOpaque);
      wishes[n].second();
      EXPECT_EQ(scene.Pixels(), before);
      this->ExpectNothingSaid();
    }
}

#else

TEST_F(OlderOpenGL, WithoutEmbreeNothingIsDrawn)
{
  const std::string embree = "rays on the CPU would do with 3.2, and need a build with Embree";
  this->Scene->Complaints.clear(); // of the fixture's frame
  this->Scene->Mapper->SetRendererToRasterize();
  this->ExpectRefused("the renderer automatic");
  this->Scene->Mapper->SetRendererToAutomatic();
  this->ExpectRefused(embree);
}

#endif

} // namespace
