// Compiles and links every shader of the project in every variant, with the driver at hand.
#include "ShaderTexts.h"

#include "vtkHaspHeadlessWindows.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderWindow.h"
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

namespace
{
namespace fs = std::filesystem;

/// Compiles one stage and attaches it. Returns the driver's log if it fails, else nothing.
std::string Attach(GLuint program, const std::string& stage, const std::string& text)
{
  static const std::map<std::string, GLenum> kinds = { { "VS", GL_VERTEX_SHADER },
    { "FS", GL_FRAGMENT_SHADER }, { "GS", GL_GEOMETRY_SHADER }, { "CS", GL_COMPUTE_SHADER } };
  const GLuint shader = glCreateShader(kinds.at(stage));
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::string log(4096, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(length);
  glAttachShader(program, shader);
  glDeleteShader(shader); // when the program goes
  return compiled ? "" : stage + ": " + log + "\n";
}

std::string Build(const hasp::ShaderProgram& program, const hasp::ShaderDefines& defines)
{
  const GLuint handle = glCreateProgram();
  std::string errors;
  for (const auto& [stage, text] : program.stages)
    errors += Attach(handle, stage, hasp::WithDefines(text, defines));
  glLinkProgram(handle);
  GLint linked = 0;
  glGetProgramiv(handle, GL_LINK_STATUS, &linked);
  if (errors.empty() && !linked)
  {
    errors.resize(4096);
    GLsizei length = 0;
    glGetProgramInfoLog(handle, static_cast<GLsizei>(errors.size()), &length, errors.data());
    errors.resize(length);
    errors = "link: " + (errors.empty() ? "failed without a word" : errors);
  }
  glDeleteProgram(handle);
  return errors;
}

/// Everything that is wrong with the shaders under `root`; empty if all is well.
std::string FindErrors(const fs::path& root, int& built)
{
  const hasp::ShaderTexts texts = hasp::ReadShaderTexts(root);
  std::string errors;
  for (const hasp::ShaderProgram& program : texts.programs)
    for (const auto& variant : hasp::ListVariants(program))
    {
      ++built;
      const std::string wrong = Build(program, variant);
      if (wrong.empty())
        continue;
      errors += program.name + " with";
      for (const auto& [name, value] : variant)
        errors += " " + name + (value.empty() ? "" : "=" + value);
      errors += "\n" + wrong + "\n";
    }
  return errors;
}

/// An OpenGL context, and a folder for shaders that are wrong.
class ShadersCompile : public testing::Test
{
protected:
  void SetUp() override
  {
    hasp::UseHeadlessWindows();
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->OffScreenRenderingOn();
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
    ASSERT_NE(window, nullptr);
    window->Initialize();
    ASSERT_EQ(window->SupportsOpenGL(), 1) << window->GetOpenGLSupportMessage();
    window->MakeCurrent();
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::temp_directory_path() / (std::string("hasp-shaders-") + test->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  void Write(const char* name, const std::string& text) const
  {
    std::ofstream(this->Folder / name) << text;
  }
  std::string Errors() const
  {
    int built = 0;
    return FindErrors(this->Folder, built);
  }

  vtkSmartPointer<vtkRenderWindow> Window{};
  fs::path Folder{};
};

const std::string vertex = "#version 430 core\nout vec3 colour;\n"
                           "void main() { colour = vec3(1); gl_Position = vec4(0); }\n";
const std::string fragment = "#version 430 core\n//Hasp::Defines\n//Hasp::Part\nin vec3 colour;\n"
                             "out vec4 o;\nvoid main() { o = vec4(Double(colour), 1); }\n";
const std::string part = "vec3 Double(vec3 v) { return 2 * v; }\n";

TEST_F(ShadersCompile, ASoundProgramPasses)
{
  this->Write("SoundVS.glsl", vertex);
  this->Write("SoundFS.glsl", fragment);
  this->Write("Part.glsl", part);
  EXPECT_EQ(this->Errors(), "");
}

TEST_F(ShadersCompile, ABrokenStageFailsWithTheDriversLog)
{
  this->Write("BrokenVS.glsl", "#version 430 core\nvoid main() { gl_Position = nowhere; }\n");
  const std::string errors = this->Errors();
  EXPECT_NE(errors.find("Broken with\nVS: "), std::string::npos) << errors;
  EXPECT_NE(errors.find("nowhere"), std::string::npos) << errors;
}

TEST_F(ShadersCompile, AnErrorInsideAPartFails)
{
  this->Write("PartlyFS.glsl", fragment);
  this->Write("Part.glsl", "vec3 Double(vec3 v) { return 2 * w; }\n");
  EXPECT_NE(this->Errors(), "");
}

TEST_F(ShadersCompile, StagesThatDoNotFitFail)
{
  this->Write("MisfitVS.glsl", vertex);
  this->Write("MisfitFS.glsl", "#version 430 core\nin vec2 colour;\nout vec4 o;\n"
                               "void main() { o = vec4(colour, 0, 1); }\n");
  const std::string errors = this->Errors();
  EXPECT_NE(errors.find("link: "), std::string::npos) << errors;
}

TEST_F(ShadersCompile, AnErrorInOneVariantAloneFails)
{
  this->Write("VariantCS.glsl", "#version 430 core\nlayout(local_size_x = 1) in;\n"
                                "#ifdef HASP_BAD\nint x = nowhere;\n#endif\n"
                                "#if defined(HASP_GOOD)\nint y = 1;\n#endif\nvoid main() {}\n");
  int built = 0;
  const std::string errors = FindErrors(this->Folder, built);
  EXPECT_EQ(built, 4);
  EXPECT_NE(errors.find("Variant with HASP_BAD\n"), std::string::npos) << errors;
  EXPECT_EQ(errors.find("Variant with HASP_GOOD\n"), std::string::npos) << errors;
}

TEST_F(ShadersCompile, AnErrorAtOneCountAloneFails)
{
  this->Write("CountCS.glsl", "#version 430 core\nlayout(local_size_x = 1) in;\n"
                              "#ifndef HASP_LIGHTS\n#define HASP_LIGHTS 1\n#endif\n"
                              "#if HASP_LIGHTS > 0\nfloat x[HASP_LIGHTS];\n#endif\n"
                              "void main() { x[0] = 1; }\n");
  int built = 0;
  const std::string errors = FindErrors(this->Folder, built);
  EXPECT_EQ(built, 5) << "the default, and 0 and 8 with no switch and with all (none)";
  EXPECT_NE(errors.find("Count with HASP_LIGHTS=0\n"), std::string::npos) << errors;
  EXPECT_EQ(errors.find("Count with HASP_LIGHTS=8\n"), std::string::npos) << errors;
}

TEST_F(ShadersCompile, WhatCannotBePutTogetherIsRefused)
{
  EXPECT_THROW(hasp::ReadShaderTexts(this->Folder / "nowhere"), std::runtime_error);
  this->Write("SlotFS.glsl", "#version 430 core\n//Hasp::Missing\nvoid main() {}\n");
  EXPECT_THROW(hasp::ReadShaderTexts(this->Folder), std::runtime_error);
  this->Write("SlotFS.glsl", "// no version\nvoid main() {}\n");
  EXPECT_THROW(hasp::ReadShaderTexts(this->Folder), std::runtime_error);
}

TEST_F(ShadersCompile, EveryShaderOfTheProject)
{
  int built = 0;
  const std::string errors = FindErrors(HASP_MODULES_FOLDER, built);
  EXPECT_EQ(errors, "");
  EXPECT_GT(built, 0) << "no shader was found under " << HASP_MODULES_FOLDER;
  std::cout << built << " programs built by " << hasp::DescribeOpenGL() << "\n";
}

} // namespace
