// Skin over bone, and the brightest values instead of it: made when switched on, gone when off.
#include "BallsScene.h"
#include "View/ScanLooks.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <QColor>

namespace hasp::testing
{
namespace
{

class ScanLooksOfBalls : public PlanSceneOfBalls
{
protected:
  ScanLooks& Looks() { return this->desk.scene.Looks(); }
  QColor At(const QImage& picture, const QPoint& fromLowerLeft) const
  {
    return picture.pixelColor(fromLowerLeft.x(), picture.height() - 1 - fromLowerLeft.y());
  }
  /// Where skin is, but no bone: the values fall by 100 a mm, so -300 is 5.26 mm outside of 226.
  QPoint BesideLeft() const
  {
    const QPoint middle = this->desk.PixelOf(this->balls.left);
    const QPoint rim = this->desk.PixelOf(
      this->balls.left + glm::dvec3(0, 0, this->balls.leftRadius)); // up, as seen from the front
    const double perMm = (rim.y() - middle.y()) / this->balls.leftRadius;
    return middle + QPoint(0, qRound(perMm * (this->balls.leftRadius + 3.0)));
  }
  vtkProp* LastProp() const
  {
    return vtkProp::SafeDownCast(
      this->desk.view.Renderer()->GetViewProps()->GetItemAsObject(int(this->desk.Props()) - 1));
  }
};

int Difference(const QColor& a, const QColor& b)
{
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
         std::abs(a.blue() - b.blue());
}

int Warmth(const QColor& colour)
{
  return colour.red() - colour.blue();
}

/// But for edges: what is opaque is traced or rasterised, whichever was the faster one.
bool Alike(const QImage& a, const QImage& b)
{
  int other = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      other += Difference(a.pixelColor(x, y), b.pixelColor(x, y)) > 30;
  return a.size() == b.size() && 100 * other < a.width() * a.height();
}

TEST_F(ScanLooksOfBalls, SkinIsThereWhileItIsOn)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Settle();
  const QImage without = this->desk.Picture("ScanWithoutSkin");
  EXPECT_EQ(this->desk.UseOf("skin").reason, "switched off");
  ASSERT_EQ(this->desk.Props(), 1U);
  const QPoint beside = this->BesideLeft(), middle = this->desk.PixelOf(this->balls.left);

  this->Looks().SetSkin(true);
  ASSERT_EQ(this->desk.Props(), 2U);
  const QImage with = this->desk.Picture("ScanWithSkin");
  EXPECT_GT(this->desk.UseOf("skin, active cells, host").bytes, 0U);
  EXPECT_EQ(this->desk.UseOf("skin").reason, "not listed");
  EXPECT_GT(Warmth(this->At(with, beside)), Warmth(this->At(without, beside)) + 20);
  EXPECT_GT(Difference(this->At(with, middle), this->At(without, middle)), 10); // over bone
  EXPECT_GT(this->At(with, middle).red(), this->At(with, beside).red() + 30);   // bone is seen

  const vtkWeakPointer<vtkMapper> mapper(vtkActor::SafeDownCast(this->LastProp())->GetMapper());
  ASSERT_TRUE(mapper);
  this->Looks().SetSkin(false);
  EXPECT_FALSE(mapper);
  EXPECT_EQ(this->desk.Props(), 1U);
  EXPECT_EQ(this->desk.UseOf("skin").reason, "switched off");
  EXPECT_EQ(this->desk.UseOf("skin").bytes, 0U);
  EXPECT_TRUE(Alike(this->desk.Picture("ScanWithoutSkinAgain"), without));
  EXPECT_FALSE(Alike(with, without));
}

TEST_F(ScanLooksOfBalls, PicksGoThroughSkin)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Settle();
  this->Looks().SetSkin(true);
  this->desk.Settle();
  EXPECT_NEAR(this->balls.Distance(this->Under(this->balls.left).world), 0.0, 0.1);
  const QPoint beside = this->BesideLeft();
  EXPECT_FALSE(this->desk.scene.PlaceAt(beside.x(), beside.y()));
}

TEST_F(ScanLooksOfBalls, SkinIsWhereItsValueIsAndAllOfItIsInSight)
{
  const PlanId scan = this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Settle();
  EXPECT_EQ(this->Looks().SkinValue(), -300.0);
  const auto reach = [&]
  {
    double bounds[6];
    this->desk.scene.Bounds().GetBounds(bounds);
    return bounds[1] - bounds[0];
  };
  const double bone = reach();
  this->Looks().SetSkin(true);
  // The values fall by 100 a mm: 5.26 mm on both sides, then 3.26; cells are 1 mm wide and turned.
  EXPECT_NEAR(reach() - bone, 2 * 5.26, 2.0);
  this->Looks().SetSkinValue(-100.0);
  EXPECT_NEAR(reach() - bone, 2 * 3.26, 2.0);
  this->desk.scene.SetVisible(scan, false); // bone; its skin is a switch of its own
  EXPECT_TRUE(this->Looks().HasSkin());
  EXPECT_EQ(this->desk.Props(), 1U);
}

TEST_F(ScanLooksOfBalls, ValuesThatAreNoHounsfieldUnitsHaveSkinBelowSoftTissue)
{
  // Air at 0, soft tissue at 500, bone at 900, in balls within balls.
  vtkImageData* image = this->balls.image;
  auto* samples = static_cast<short*>(image->GetScalarPointer());
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
    samples[n] = short(samples[n] > 226 ? 900 + n % 7 : samples[n] > -200 ? 500 + n % 11 : n % 5);
  ShelfScan scan;
  scan.image = image;
  scan.passport.hash = BallsHash;
  scan.passport.maximum = 906;
  this->desk.scans.Put(scan);
  this->desk.Add(PlanVolume{ 0, "", BallsHash });
  this->Looks().SetSkin(true);
  this->desk.Settle();
  EXPECT_NEAR(this->Looks().SkinValue(), 252.0, 10.0); // between 0 and 505
  EXPECT_EQ(this->desk.Props(), 2U);
  this->Looks().SetBrightest(true);
  this->desk.Settle();
  EXPECT_GT(this->desk.UseOf("brightest values, GPU").bytes, 0U);
  EXPECT_EQ(this->desk.refused, QStringList());
}

TEST_F(ScanLooksOfBalls, SwitchesStayAndWhatTheyShowIsOfTheNewPlan)
{
  this->Looks().SetSkin(true);
  this->Looks().SetBrightest(true);
  EXPECT_EQ(this->desk.UseOf("skin").reason, "the plan has no scan");
  EXPECT_EQ(this->desk.UseOf("brightest values, GPU").reason, "the plan has no scan");
  EXPECT_EQ(this->desk.Props(), 0U);
  this->desk.AddScan(this->balls.image, BallsHash);
  this->Looks().SetSkinValue(-100.0);
  this->desk.Settle();
  EXPECT_EQ(this->desk.Props(), 2U);
  this->desk.plan.BeginNew();
  this->desk.Settle();
  EXPECT_EQ(this->desk.Props(), 0U);
  EXPECT_TRUE(this->Looks().HasSkin());
  EXPECT_TRUE(this->Looks().HasBrightest());
  EXPECT_EQ(this->Looks().SkinValue(), -300.0); // of another scan
  this->desk.Add(PlanVolume{ 0, "", std::string(64, 'c') });
  EXPECT_EQ(this->desk.UseOf("skin").reason, "the scan is not in memory");
}

TEST_F(ScanLooksOfBalls, TheBrightestValuesStandForBoneWhileTheyAreOn)
{
  this->desk.AddScan(this->balls.image, BallsHash);
  this->desk.Settle();
  const QImage bone = this->desk.Picture("ScanBone");
  const QPoint middle = this->desk.PixelOf(this->balls.left);
  EXPECT_EQ(this->desk.UseOf("brightest values, GPU").reason, "switched off");

  this->Looks().SetBrightest(true);
  EXPECT_EQ(this->desk.scene.ScanProp(), nullptr);
  EXPECT_EQ(this->desk.UseOf("scan's isosurface").reason, "the brightest values are shown instead");
  ASSERT_EQ(this->desk.Props(), 1U);
  EXPECT_EQ(this->desk.UseOf("brightest values, GPU").bytes,
    2U * std::size_t(this->balls.image->GetNumberOfPoints()));
  const QImage brightest = this->desk.Picture("ScanBrightest");
  // 226 and 100 a mm up to the middle, which is 1426, in a window up to 1426.
  const QColor inside = this->At(brightest, middle);
  EXPECT_GT(inside.red(), 200);
  EXPECT_NEAR(inside.red(), inside.blue(), 20); // white over the background
  EXPECT_LT(this->At(brightest, { 5, 5 }).red(), 80);

  const vtkWeakPointer<vtkProp> volume(this->LastProp());
  this->Looks().SetBrightest(false);
  EXPECT_FALSE(volume);
  EXPECT_NE(this->desk.scene.ScanProp(), nullptr);
  EXPECT_EQ(this->desk.UseOf("brightest values, GPU").bytes, 0U);
  EXPECT_TRUE(Alike(this->desk.Picture("ScanBoneAgain"), bone));
  EXPECT_FALSE(Alike(brightest, bone));
}

TEST_F(ScanLooksOfBalls, AScanOfOneValueIsRefusedOnce)
{
  ShelfScan scan;
  scan.image = this->balls.image;
  scan.passport.hash = BallsHash;
  scan.passport.minimum = scan.passport.maximum = 7.0;
  this->desk.scans.Put(scan);
  this->desk.Add(PlanVolume{ 0, "", BallsHash });
  this->Looks().SetBrightest(true);
  this->desk.Settle();
  this->desk.scene.Sync();
  ASSERT_EQ(this->desk.refused.size(), 1);
  EXPECT_TRUE(this->desk.refused[0].contains("all values of the scan are the same"));
  EXPECT_EQ(this->desk.Props(), 0U);
}

} // namespace
} // namespace hasp::testing
