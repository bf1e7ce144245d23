// What is kept of an eye from one frame to the next, and how depth is read for it.
#include "CellTestScene.h"
#include "OneSampleDepth.h"
#include "ViewerEyes.h"

#include "vtkCamera.h"
#include "vtkCommand.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>

namespace
{

using hasp::testing::CellTestScene;

class ViewerEyesOfAMapper : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

/// A view that is not drawn any more would hold its depth, and a say in what is kept, for ever.
TEST_F(ViewerEyesOfAMapper, AreForgottenAfter256FramesOfOthers)
{
  const auto isKnownAfter = [](int frames)
  {
    CellTestScene scene(20, 20);
    vtkNew<vtkRenderer> other;
    scene.Window->AddRenderer(other);
    ViewerEyes eyes;
    bool begins = false;
    eyes.Of(other, scene.Actor, begins).Choice.WholeTook(false, 7.0);
    EXPECT_TRUE(begins);
    for (int frame = 0; frame < frames; ++frame)
    {
      scene.Renderer->InvokeEvent(vtkCommand::StartEvent);
      eyes.Of(scene.Renderer, scene.Actor, begins);
    }
    return eyes.Of(other, scene.Actor, begins).Choice.Text().find("7.0 ms") != std::string::npos;
  };
  EXPECT_TRUE(isKnownAfter(1));
  EXPECT_TRUE(isKnownAfter(256));
  EXPECT_FALSE(isKnownAfter(257));
}

/// A renderer that begins a frame of one of its eyes, as the camera says.
ViewerEye& Begin(ViewerEyes& eyes, CellTestScene& scene, bool left)
{
  scene.Renderer->InvokeEvent(vtkCommand::StartEvent);
  scene.Renderer->GetActiveCamera()->SetLeftEye(left);
  bool begins = false;
  ViewerEye& eye = eyes.Of(scene.Renderer, scene.Actor, begins);
  EXPECT_TRUE(begins);
  return eye;
}

TEST_F(ViewerEyesOfAMapper, AreToldApartByTheCameraWithAndWithoutVtksStereo)
{
  for (const bool stereo : { false, true })
  {
    CellTestScene scene(20, 20);
    scene.Window->SetStereoRender(stereo);
    ViewerEyes eyes;
    ViewerEye& left = Begin(eyes, scene, true);
    EXPECT_EQ(eyes.SecondOf(left), nullptr); // nobody has seen another
    ViewerEye& right = Begin(eyes, scene, false);
    EXPECT_NE(&left, &right);
    EXPECT_NE(left.Number, right.Number);
    EXPECT_TRUE(left.IsDrawn(true));
    EXPECT_EQ(&Begin(eyes, scene, true), &left);
    EXPECT_EQ(eyes.SecondOf(left), &right);
    EXPECT_EQ(eyes.SecondOf(right), nullptr);
    EXPECT_EQ(&eyes.FirstOf(right), &left); // it has just been drawn
    EXPECT_EQ(&eyes.FirstOf(left), &left);
    EXPECT_EQ(&Begin(eyes, scene, true), &left); // one eye again
    EXPECT_EQ(eyes.SecondOf(left), nullptr);
  }
}

TEST_F(ViewerEyesOfAMapper, TheSecondIsExpectedBesideTheFirst)
{
  const glm::dmat4 apart = glm::translate(glm::dmat4(1.0), glm::dvec3(-6.3, 0.2, 0.1));
  const glm::dmat4 leftLens = glm::perspective(0.5, 1.3, 10.0, 900.0),
                   rightLens = glm::perspective(0.6, 1.2, 11.0, 800.0);
  const auto head = [](double turn)
  {
    return glm::lookAt(glm::dvec3(200 * turn, -300, 40), glm::dvec3(10, 5, turn),
      glm::normalize(glm::dvec3(0.2, 0.1, 1)));
  };
  CellTestScene scene(20, 20);
  ViewerEyes eyes;
  ViewerEye& left = Begin(eyes, scene, true);
  ViewerEye& right = Begin(eyes, scene, false);
  EXPECT_FALSE(right.Beside(left, leftLens * head(0.0)));
  left.Moved(leftLens * head(0.0));
  EXPECT_FALSE(right.Beside(left, leftLens * head(0.0)));
  right.Moved(rightLens * apart * head(0.0));
  const auto beside = right.Beside(left, leftLens * head(0.3));
  ASSERT_TRUE(beside);
  const glm::dmat4 truth = rightLens * apart * head(0.3);
  for (int column = 0; column < 4; ++column) // some 1000 units; rounded a few times
    EXPECT_LT(glm::distance((*beside)[column], truth[column]), 1e-8) << column;
}

/// A framebuffer as a program of its own may have bound it.
struct Framebuffer
{
  GLuint name = 0, color = 0, depth = 0;
  explicit Framebuffer(int samples, int size = 16)
  {
    glGenFramebuffers(1, &this->name);
    glBindFramebuffer(GL_FRAMEBUFFER, this->name);
    this->Attach(this->color, GL_COLOR_ATTACHMENT1, GL_RGBA8, samples, size);
    this->Attach(this->depth, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, samples, size);
    glDrawBuffer(GL_COLOR_ATTACHMENT1);
    glReadBuffer(GL_COLOR_ATTACHMENT1);
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
  }
  ~Framebuffer()
  {
    glDeleteFramebuffers(1, &this->name);
    glDeleteRenderbuffers(1, &this->color);
    glDeleteRenderbuffers(1, &this->depth);
  }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

private:
  void Attach(GLuint& buffer, GLenum place, GLenum format, int samples, int size)
  {
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size, size);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
  }
};

GLint Asked(GLenum what)
{
  GLint answer = 0;
  glGetIntegerv(what, &answer);
  return answer;
}

/// Before OpenGL 4.1 what is read from must have the colours that it says it reads: a copy of depth
/// alone has none to say. Newer ones let that pass, so it is asked, not tried.
TEST_F(ViewerEyesOfAMapper, ACopyOfDepthReadsNoColours)
{
  CellTestScene scene(20, 20);
  scene.Window->Render();
  const Framebuffer drawn(4);
  {
    const OneSampleScope copy(static_cast<GLint>(drawn.name), { 0, 0 }, { 16, 16 });
    ASSERT_TRUE(copy.Ready());
    EXPECT_EQ(Asked(GL_READ_BUFFER), GL_NONE);
    EXPECT_EQ(glCheckFramebufferStatus(GL_READ_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
  }
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// Who reads pixels next reads those it was about to read.
TEST_F(ViewerEyesOfAMapper, ReadingDepthLeavesWhatIsReadAsItWas)
{
  CellTestScene scene(20, 20);
  scene.Window->Render();
  for (const int samples : { 0, 4 })
  {
    const Framebuffer read(0);
    glClearColor(0.0F, 1.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    const Framebuffer drawn(samples);
    glClearDepth(0.25);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, read.name);
    ViewerEye eye(scene.Renderer, scene.Actor, true, 0);
    eye.ReadDepth({ 2, 3 }, { 8, 6 });
    ASSERT_EQ(eye.Depth({ 8, 6 }).size(), 48U) << samples;
    for (const float depth : eye.Depth({ 8, 6 }))
      EXPECT_NEAR(depth, 0.25F, 1e-6F) << samples; // 24 bits
    EXPECT_EQ(Asked(GL_READ_FRAMEBUFFER_BINDING), static_cast<GLint>(read.name)) << samples;
    EXPECT_EQ(Asked(GL_DRAW_FRAMEBUFFER_BINDING), static_cast<GLint>(drawn.name)) << samples;
    EXPECT_EQ(Asked(GL_READ_BUFFER), GL_COLOR_ATTACHMENT1) << samples;
    std::array<unsigned char, 4> pixel{};
    glReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    EXPECT_EQ(pixel, (std::array<unsigned char, 4>{ 0, 255, 0, 255 })) << samples;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << samples;
  }
}

} // namespace
