// Render passes that have a say in an actor's shaders have it for traced cells as for rasterised
// ones.
#include "CellTestScene.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProperty.h"
#include "vtkRenderStepsPass.h"
#include "vtkShaderProgram.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace
{

using hasp::testing::CellTestScene;

#if HASP_WITH_EMBREE

constexpr int Pixels = 120;

using Colors = std::vector<unsigned char>;

/// Exchanges red and blue, takes a share of each colour by a uniform, and leaves out every eighth
/// column.
class TintPass : public vtkOpenGLRenderPass
{
public:
  static TintPass* New();
  vtkTypeMacro(TintPass, vtkOpenGLRenderPass);

  void Render(const vtkRenderState* state) override
  {
    this->PreRender(state);
    this->Steps->Render(state);
    this->PostRender(state);
  }
  bool PreReplaceShaderValues(
    std::string&, std::string&, std::string& fragment, vtkAbstractMapper*, vtkProp*) override
  {
    vtkShaderProgram::Substitute(fragment, "//VTK::DepthPeeling::Dec", "uniform vec3 tint;");
    vtkShaderProgram::Substitute(
      fragment, "//VTK::DepthPeeling::PreColor", "if (mod(gl_FragCoord.x, 8.0) < 1.0) discard;");
    return true;
  }
  bool PostReplaceShaderValues(
    std::string&, std::string&, std::string& fragment, vtkAbstractMapper*, vtkProp*) override
  {
    vtkShaderProgram::Substitute(fragment, "//VTK::DepthPeeling::Impl",
      "gl_FragData[0] = vec4(gl_FragData[0].bgr * tint, 1.0);");
    return true;
  }
  bool SetShaderParameters(
    vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*) override
  {
    const float tint[3] = { 0.9F, 0.6F, 0.3F };
    return program->SetUniform3f("tint", tint);
  }

private:
  vtkNew<vtkRenderStepsPass> Steps;
};
vtkStandardNewMacro(TintPass);

struct PassScene : CellTestScene
{
  PassScene() : CellTestScene(Pixels, Pixels)
  {
    const hasp::GridGeometry g = hasp::testing::ObliqueGrid(50, { 1, 0.9, 1.3 });
    this->Mapper->SetInputData(
      hasp::MakeImage(g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticGyroid(20), g, 100, 0)));
    this->Actor->GetProperty()->SetColor(1, 0.7, 0.4);
    this->Actor->GetProperty()->SetAmbient(0.2); // nothing is as black as the background
    this->Look({ 60, -80, 40 }, { 0, 0, 0 }, 20, 200);
  }
  Colors Picture(int renderer)
  {
    this->Mapper->SetRenderer(renderer);
    this->Draw();
    vtkNew<vtkUnsignedCharArray> rgb;
    this->Window->GetPixelData(0, 0, Pixels - 1, Pixels - 1, 0, rgb);
    return { rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues() };
  }
};

int Differ(const Colors& a, const Colors& b)
{
  int pixels = 0;
  for (std::size_t n = 0; n < a.size(); n += 3)
    pixels += std::abs(a[n] - b[n]) > 2 || std::abs(a[n + 1] - b[n + 1]) > 2 ||
              std::abs(a[n + 2] - b[n + 2]) > 2;
  return pixels;
}

class TracedCellPasses : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

constexpr int Few = Pixels * Pixels / 200; // silhouettes, faces between two cells

TEST_F(TracedCellPasses, APassChangesTheShader)
{
  PassScene scene;
  const Colors plain = scene.Picture(vtkHaspClusteredCellMapper::Rasterize);
  vtkNew<TintPass> tint;
  scene.Renderer->SetPass(tint);
  const Colors drawn = scene.Picture(vtkHaspClusteredCellMapper::Rasterize);
  EXPECT_GT(Differ(drawn, plain), Pixels * Pixels / 4);
  EXPECT_LE(Differ(scene.Picture(vtkHaspClusteredCellMapper::Trace), drawn), Few);
  scene.Renderer->SetPass(nullptr);
  EXPECT_LE(Differ(scene.Picture(vtkHaspClusteredCellMapper::Trace), plain), Few);
}

#endif

} // namespace
