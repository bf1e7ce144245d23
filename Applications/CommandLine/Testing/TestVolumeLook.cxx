// What a volume is shown as without being told, and skin and bone.
#include "VolumeStage.h"
#include "vtkHaspVolumeFile.h"

namespace
{

using namespace hasp;
using namespace hasp::testing;

Passport Known(bool hounsfield, double minimum, double maximum)
{
  Passport passport;
  passport.hounsfield = hounsfield;
  passport.minimum = minimum;
  passport.maximum = maximum;
  return passport;
}

TEST(UsualLook, IsOfBoneWhereValuesAreHounsfield)
{
  using Window = std::array<double, 2>;
  EXPECT_EQ(UsualLook(Known(true, -1024, 3071)).window, (Window{ 0, 2000 }));
  EXPECT_EQ(UsualLook(Known(true, -1024, 900)).window, (Window{ 0, 900 }));
  EXPECT_EQ(UsualLook(Known(true, -1024, -10)).window, (Window{ -1024, -10 })); // a lung
  EXPECT_EQ(UsualLook(Known(true, 100, 3071)).window, (Window{ 100, 2000 }));
  EXPECT_EQ(UsualLook(Known(true, 2500, 3071)).window, (Window{ 2500, 3071 }));
  EXPECT_EQ(UsualLook(Known(false, 0, 255)).window, (Window{ 0, 255 }));
  EXPECT_TRUE(UsualLook(Known(true, -1024, 3071)).skin);
  EXPECT_FALSE(UsualLook(Known(false, -1024, 3071)).skin);
}

/// A ball of 1000 in a ball of 40 in air, from the front.
class Translucent : public ::testing::Test
{
protected:
  Translucent()
    : image(Volume({ 41, 41, 41 }, { 1, 1, 1 }, VTK_SHORT,
        [](int i, int j, int k)
        {
          const double r = std::hypot(i - 20.0, j - 20.0, k - 20.0);
          const auto edge = [r](double radius) { return std::clamp(radius - r + 0.5, 0.0, 1.0); };
          return -1000.0 + 1040.0 * edge(17.0) + 960.0 * edge(8.0);
        }))
  {
  }
  std::array<int, 3> Pixel(int samplesFromMiddle) const
  {
    const unsigned char* p = this->stage.At(61 + 3 * samplesFromMiddle, 61);
    return { p[0], p[1], p[2] };
  }
  void Draw(vtkVolume* volume)
  {
    this->stage.renderer->RemoveAllViewProps();
    this->stage.renderer->AddVolume(volume);
    LookAlong(this->stage, this->image, { 2, 0, 1 });
    this->stage.Draw();
  }
  vtkSmartPointer<vtkImageData> image;
  Stage stage{ 123, 123 };
};

TEST_F(Translucent, SkinLiesOverBoneAndOverNothing)
{
  VolumeLook look = UsualLook(Known(true, -1000, 1000));
  this->Draw(MakeTranslucent(this->image, 226, look, { 0, 1, 0 }));
  EXPECT_EQ(this->Pixel(-19), (std::array{ 0, 0, 0 })); // air
  const auto skin = this->Pixel(13), bone = this->Pixel(0);
  EXPECT_GT(skin[0], skin[1]); // its colour is red above green
  EXPECT_GT(skin[0], 15);
  EXPECT_GT(bone[1], 100); // green, seen
  EXPECT_GT(bone[0], 15);  // through skin
  look.skin.reset();
  this->Draw(MakeTranslucent(this->image, 226, look, { 0, 1, 0 }));
  EXPECT_EQ(this->Pixel(13), (std::array{ 0, 0, 0 }));
  EXPECT_EQ(this->Pixel(0)[0], this->Pixel(0)[2]); // the lamp's gloss alone
}

TEST_F(Translucent, BoneFollowsItsValueAndColor)
{
  const VolumeLook look = UsualLook(Known(true, -1000, 1000));
  const auto volume = MakeTranslucent(this->image, 226, look, { 0, 1, 0 });
  this->Draw(volume);
  const auto before = this->Pixel(0);
  SetTranslucentBone(volume, 226, look, { 0, 0, 1 });
  this->Draw(volume);
  EXPECT_GT(this->Pixel(0)[2], before[2] + 80);
  SetTranslucentBone(volume, 1500, look, { 0, 0, 1 }); // above all values
  this->Draw(volume);
  const auto middle = this->Pixel(0), side = this->Pixel(5);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(middle[c], side[c], 40); // skin alone, and no ball in it
  EXPECT_LT(middle[2], 60);
}

} // namespace
