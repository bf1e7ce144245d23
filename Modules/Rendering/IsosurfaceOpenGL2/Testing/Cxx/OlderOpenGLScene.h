#pragma once
// A window below OpenGL 4.3, where nothing of a later OpenGL can be called. CTest runs these tests
// on several versions: Mesa makes itself older, GLSL and all, where the environment says so.
#include "RaycastTestScene.h"

#include "vtkProperty.h"

#include <cstdlib>
#include <memory>

namespace hasp::testing
{

/// "3.2".
inline std::string WantedVersion()
{
  const char* version = std::getenv("MESA_GL_VERSION_OVERRIDE");
  return version ? version : "";
}

/// What both mappers say, and a gyroid for either.
struct OlderScene : RaycastScene
{
  std::vector<std::string> Complaints, Warnings; ///< of the cells' mapper; of the other

  OlderScene()
  {
    this->Mapper->SetRendererToAutomatic();
    this->Hear(this->Mapper, vtkCommand::ErrorEvent, this->Complaints);
    this->Hear(this->Raycaster, vtkCommand::WarningEvent, this->Warnings);
    this->Show<std::int16_t>(hasp::AnalyticGyroid(25), ObliqueGrid(52, { 1.0, 0.8, 1.3 }));
    this->Mapper->SetInputData(this->Raycaster->GetImage());
    this->Actor->GetProperty()->SetAmbient(0.1); // nothing is as black as the background
    this->Actor->GetProperty()->SetDiffuse(0.9);
  }
  static void Hear(vtkObject* from, unsigned long event, std::vector<std::string>& texts)
  {
    vtkNew<vtkCallbackCommand> hear;
    hear->SetClientData(&texts);
    hear->SetCallback(
      [](vtkObject*, unsigned long, void* all, void* text) {
        static_cast<std::vector<std::string>*>(all)->emplace_back(static_cast<const char*>(text));
      });
    from->AddObserver(event, hear);
  }
  void ShowCells() { this->Actor->SetMapper(this->Mapper); }
  void ShowRaycaster(int mode)
  {
    this->Raycaster->SetMode(mode);
    this->Actor->SetMapper(this->Raycaster);
  }
  int Pixels() // that show a surface
  {
    int count = 0;
    for (const auto& point : this->Points())
      count += point.has_value();
    return count;
  }
};

/// Functions of later versions end the test where they are called.
inline void ForbidLaterFunctions()
{
  glTexStorage3D = nullptr; // 4.2
  glMemoryBarrier = nullptr;
  glTextureView = nullptr; // 4.3
  glDispatchCompute = nullptr;
  glMultiDrawArraysIndirect = nullptr;
}

class OlderOpenGL : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }

  void SetUp() override
  {
    if (WantedVersion().empty())
      GTEST_SKIP() << "CTest says which version, in MESA_GL_VERSION_OVERRIDE";
    this->Scene = std::make_unique<OlderScene>();
    this->Scene->ShowCells();
    this->Scene->Draw();
    const std::string version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
    if (version.find("Mesa") == std::string::npos)
      GTEST_SKIP() << "a driver that does not make itself older: " << version;
    ASSERT_EQ(version.substr(0, 4), WantedVersion() + " ");
    ForbidLaterFunctions();
  }
  void TearDown() override
  {
    EXPECT_EQ(this->Scene ? glGetError() : GL_NO_ERROR, GLenum(GL_NO_ERROR));
  }
  std::string Lack(const std::string& what) const
  {
    return what + " needs OpenGL 4.3, and this window has " + WantedVersion();
  }
  /// The exact root, to what the depth buffer keeps.
  void ExpectTruth(int mostMissed = 0)
  {
    const Judgement judged = this->Scene->Judge(this->Scene->Truth());
    EXPECT_GT(judged.surface, 3000);
    EXPECT_LE(judged.missed, mostMissed);
    EXPECT_EQ(judged.invented, 0);
    EXPECT_LE(judged.error, 0.001);
  }
  void ExpectNothingSaid()
  {
    EXPECT_EQ(this->Scene->Complaints, std::vector<std::string>());
    EXPECT_EQ(this->Scene->Errors, std::vector<std::string>());
    EXPECT_EQ(this->Scene->Warnings, std::vector<std::string>());
  }
  /// Nothing is drawn, which is said once, in these words.
  void ExpectRefused(const std::string& words)
  {
    OlderScene& scene = *this->Scene;
    for (int n = 0; n < 3; ++n)
      EXPECT_EQ(scene.Pixels(), 0) << words;
    ASSERT_EQ(scene.Complaints.size(), 1U) << words;
    EXPECT_NE(scene.Complaints[0].find(this->Lack("rasterising") + "; " + words), std::string::npos)
      << scene.Complaints[0];
    EXPECT_EQ(scene.Mapper->GetRendererChoice(), "not drawn: " + this->Lack("rasterising"));
    scene.Complaints.clear();
  }

  std::unique_ptr<OlderScene> Scene;
};

} // namespace hasp::testing
