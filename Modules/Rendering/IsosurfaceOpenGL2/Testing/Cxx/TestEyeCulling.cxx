// Two eyes of a rig that share one pass of culling see, bit by bit, what each sees by itself.
#include "AttributeTestScene.h"
#include "EyeCulling.h"
#include "vtkHaspStereoPair.h"

#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkTransform.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <random>

namespace
{

using hasp::testing::AttributeScene;
using hasp::testing::CellTestScene;

class EyeCullingOfAMapper : public ::testing::Test
{
protected:
  static void SetUpTestSuite() { hasp::UseHeadlessWindows(); }
};

struct Head
{
  glm::dvec3 position, lookAt, up;
  double apart;
};

/// What a window shows.
struct Picture
{
  std::vector<unsigned char> colors;
  std::vector<float> depth;
  bool operator==(const Picture&) const = default;
};

/// A frame an eye, as a rig draws them: each a camera of its own.
class RigOf
{
public:
  explicit RigOf(CellTestScene& scene) : Scene(scene)
  {
    vtkNew<vtkCallbackCommand> choose; // vtkRenderWindow has set the left one
    choose->SetClientData(this);
    choose->SetCallback(
      [](vtkObject*, unsigned long, void* data, void*)
      {
        auto* rig = static_cast<RigOf*>(data);
        rig->Camera()->SetLeftEye(rig->Left);
      });
    scene.Renderer->AddObserver(vtkCommand::StartEvent, choose);
  }
  vtkCamera* Camera() { return this->Scene.Renderer->GetActiveCamera(); }

  std::array<Picture, 2> DrawBoth(const Head& head, bool shared)
  {
    hasp::StereoPair pair;
    this->Aim(head, false);
    pair.right = this->WorldToClip();
    this->Aim(head, true);
    pair.left = this->WorldToClip();
    hasp::SetStereoPair(
      this->Camera()->GetInformation(), shared ? std::optional(pair) : std::nullopt);
    Picture left = this->DrawEye(head, true);
    return { std::move(left), this->DrawEye(head, false) };
  }
  Picture DrawEye(const Head& head, bool left)
  {
    this->Aim(head, left);
    this->Left = left;
    this->Scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> rgb;
    vtkNew<vtkFloatArray> depth;
    const int x = this->Scene.Window->GetSize()[0] - 1, y = this->Scene.Window->GetSize()[1] - 1;
    this->Scene.Window->GetPixelData(0, 0, x, y, 0, rgb);
    this->Scene.Window->GetZbufferData(0, 0, x, y, depth);
    return { { rgb->GetPointer(0), rgb->GetPointer(0) + rgb->GetNumberOfValues() },
      { depth->GetPointer(0), depth->GetPointer(0) + depth->GetNumberOfValues() } };
  }
  int Passes() { return std::atoi(this->Kept().reason.c_str()); }
  hasp::ResourceUse Kept()
  {
    return hasp::testing::FindResource(this->Scene.Mapper, "clusters both eyes see");
  }

private:
  void Aim(const Head& head, bool left)
  {
    const glm::dvec3 right = glm::normalize(glm::cross(head.lookAt - head.position, head.up));
    const glm::dvec3 eye = head.position + (left ? -0.5 : 0.5) * head.apart * right;
    vtkCamera* camera = this->Camera();
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(head.lookAt.x, head.lookAt.y, head.lookAt.z);
    camera->SetViewUp(head.up.x, head.up.y, head.up.z);
    camera->SetClippingRange(0.5, 300);
  }
  glm::dmat4 WorldToClip()
  {
    vtkNew<vtkMatrix4x4> clip;
    vtkMatrix4x4::Multiply4x4(this->Camera()->GetProjectionTransformMatrix(
                                this->Scene.Renderer->GetTiledAspectRatio(), -1, 1),
      this->Camera()->GetModelViewTransformMatrix(), clip);
    return glm::transpose(glm::make_mat4(clip->GetData()));
  }

  CellTestScene& Scene;
  bool Left = true;
};

/// Heads around and in a ball of 15 mm: tilted, with eyes at one place, near and far apart.
std::vector<Head> Heads(int count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
  std::vector<Head> heads;
  for (int n = 0; n < count; ++n)
    heads.push_back({ (n % 3 == 0 ? 12.0 : 60.0) * vector(), 5.0 * vector(),
      vector() + glm::dvec3(0, 0, 0.01), std::array{ 0.0, 1.0, 6.3, 80.0 }[n % 4] });
  return heads;
}

/// Each head drawn by a scene that shares and by one that does not.
void ExpectTheSame(const std::function<void(AttributeScene&)>& set, int count, int passesAHead)
{
  AttributeScene sharing, single;
  for (AttributeScene* scene : { &sharing, &single })
    set(*scene);
  RigOf shared(sharing), alone(single);
  std::size_t shown = 0;
  for (const Head& head : Heads(count))
  {
    const int before = shared.Passes();
    const auto pictures = shared.DrawBoth(head, true), truth = alone.DrawBoth(head, false);
    EXPECT_EQ(shared.Passes() - before, passesAHead);
    for (int eye = 0; eye < 2; ++eye)
    {
      EXPECT_TRUE(pictures[eye] == truth[eye]) << "apart " << head.apart << ", eye " << eye;
      for (const float depth : truth[eye].depth)
        shown += depth < 1.0F;
    }
  }
  EXPECT_GT(shown, 10'000U);
  EXPECT_EQ(alone.Kept().bytes, 0U);
}

TEST_F(EyeCullingOfAMapper, ShowsWhatEachEyeShowsByItself)
{
  ExpectTheSame([](AttributeScene&) {}, 16, 1);
}

TEST_F(EyeCullingOfAMapper, AlsoOfMovedLabels)
{
  const auto move = [](AttributeScene& scene)
  {
    vtkNew<vtkTransform> pose;
    pose->Translate(14, -3, 8);
    pose->RotateWXYZ(50, 1, 2, 3);
    scene.Mapper->SetLabelArrayName("label");
    scene.Mapper->SetLabelPose(2, pose);
  };
  ExpectTheSame(move, 12, 1);
}

/// Which culls with a margin, too.
TEST_F(EyeCullingOfAMapper, AlsoWithBlendedNormals)
{
  ExpectTheSame([](AttributeScene& scene) { scene.Mapper->BlendNormalsOn(); }, 5, 2);
}

/// What the first eye's frame found is no good for another surface, pose or place.
TEST_F(EyeCullingOfAMapper, CullsAnewWhatChangesBetweenTheEyes)
{
  const Head head{ { 0, -60, 5 }, { 0, 0, 0 }, { 0, 0, 1 }, 6.3 };
  const std::function<void(AttributeScene&)> changes[] = {
    [](AttributeScene& scene) { scene.Mapper->SetIsoValue(-400.0); },
    [](AttributeScene& scene) { scene.Actor->SetPosition(5, 0, 3); },
    [](AttributeScene& scene)
    {
      vtkNew<vtkTransform> pose;
      pose->Translate(-9, 0, 6);
      scene.Mapper->SetLabelPose(1, pose);
    },
  };
  for (const auto& change : changes)
  {
    AttributeScene sharing, single;
    for (AttributeScene* scene : { &sharing, &single })
      scene->Mapper->SetLabelArrayName("label");
    for (AttributeScene* scene : { &sharing, &single })
      scene->Mapper->SetLabelVisibility(3, true);
    RigOf shared(sharing), alone(single);
    shared.DrawBoth(head, true);
    change(sharing);
    change(single);
    EXPECT_TRUE(shared.DrawEye(head, false) == alone.DrawEye(head, false));
    EXPECT_EQ(shared.Passes(), 2);
  }
}

TEST_F(EyeCullingOfAMapper, HoldsNothingInMonoBeforeAndAfter)
{
  CellTestScene scene(60, 50);
  scene.Mapper->SetInputData(hasp::testing::TwoHalves());
  RigOf rig(scene);
  const Head head{ { 0, -60, 5 }, { 0, 0, 0 }, { 0, 0, 1 }, 6.3 };
  rig.DrawEye(head, true);
  EXPECT_EQ(rig.Kept().bytes, 0U);
  EXPECT_EQ(rig.Kept().reason, "one eye");
  rig.DrawBoth(head, true);
  EXPECT_GT(rig.Kept().bytes, 100U);
  hasp::SetStereoPair(rig.Camera()->GetInformation(), std::nullopt);
  for (int frame = 0; frame < 3; ++frame)
    rig.DrawEye(head, true);
  EXPECT_EQ(rig.Kept().bytes, 0U);
}

/// A viewer who holds still costs no pass at all.
TEST(EyeCulling, KnowsBothListsUntilSomethingChanges)
{
  EyeCulling eyes;
  const glm::dmat4 left(1.0), right(2.0);
  const EyeCulling::View first{ left, { 60, 50 }, 8.0, 0.0, 4, 5 };
  EyeCulling::View second = first;
  second.indexToClip = right;
  std::vector<std::size_t> asked;
  const auto cull = [&](std::span<const glm::dmat4> views)
  {
    asked.push_back(views.size());
    std::vector<hasp::VisibleClusters> visible(views.size());
    for (std::size_t n = 0; n < views.size(); ++n)
      visible[n].points = { views[n] == left ? 1U : 2U };
    return visible;
  };
  for (int pair = 0; pair < 3; ++pair)
  {
    eyes.BeginFrame();
    EXPECT_EQ(eyes.Visible(first, right, cull).points.front(), 1U);
    EXPECT_EQ(eyes.Visible(first, right, cull).points.front(), 1U) << "a second pass of a frame";
    eyes.BeginFrame();
    EXPECT_EQ(eyes.Visible(second, left, cull).points.front(), 2U);
  }
  EXPECT_EQ(asked, std::vector<std::size_t>{ 2 });
  const std::function<void(EyeCulling::View&)> changes[] = {
    [](EyeCulling::View& view) { ++view.viewport.y; },
    [](EyeCulling::View& view) { ++view.pointLimit; },
    [](EyeCulling::View& view) { view.margin = 0.5; },
    [](EyeCulling::View& view) { ++view.cells; },
    [](EyeCulling::View& view) { ++view.labels; },
  };
  for (const auto& change : changes)
  {
    asked.clear();
    EyeCulling::View other = first;
    change(other);
    eyes.Visible(other, right, cull);
    EXPECT_EQ(asked, std::vector<std::size_t>{ 2 });
  }
  EyeCulling one; // eyes at one place
  asked.clear();
  one.Visible(first, left, cull);
  EXPECT_EQ(asked, std::vector<std::size_t>{ 1 });
  for (int frame = 0; frame < 3; ++frame)
    one.BeginFrame();
  EXPECT_EQ(one.Bytes(), 0U);
}

} // namespace
