// The brightest values as VTK's ray caster draws them, held against sums done by hand.
#include "VolumeStage.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <limits>
#include <random>
#include <tuple>
#include <vector>

namespace
{

using namespace hasp;
using namespace hasp::testing;

/// On the volume's faces it is low: there a ray may end a sample early.
vtkSmartPointer<vtkImageData> Noise(
  const Size3& size, const Point& spacing, int type, double low, double high)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(low, high);
  return Volume(size, spacing, type,
    [&](int i, int j, int k)
    {
      const std::array at{ i, j, k };
      for (int a = 0; a < 3; ++a)
        if (size[a] > 1 && (at[a] == 0 || at[a] == size[a] - 1))
          return low;
      return std::round(any(random));
    });
}

double SampleAt(vtkImageData* image, int i, int j, int k)
{
  int size[3];
  image->GetDimensions(size);
  return image->GetPointData()->GetScalars()->GetTuple1(
    i + vtkIdType(size[0]) * (j + vtkIdType(size[1]) * k));
}

/// Trilinear; none outside of the samples.
double ValueAt(vtkImageData* image, const Point& world)
{
  int size[3];
  image->GetDimensions(size);
  double at[3];
  image->TransformPhysicalPointToContinuousIndex(world.data(), at);
  int cell[3];
  for (int a = 0; a < 3; ++a)
  {
    if (at[a] < 0.0 || at[a] > size[a] - 1)
      return -std::numeric_limits<double>::infinity();
    cell[a] = std::min(int(at[a]), size[a] - 2);
    at[a] -= cell[a];
  }
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int d[3] = { corner & 1, corner >> 1 & 1, corner >> 2 };
    double weight = 1.0;
    for (int a = 0; a < 3; ++a)
      weight *= d[a] ? at[a] : 1.0 - at[a];
    value += weight * SampleAt(image, cell[0] + d[0], cell[1] + d[1], cell[2] + d[2]);
  }
  return value;
}

/// The largest sample of each column is what its pixel shows, but for columns at the rim, where a
/// pixel's middle lies on the face of the box, and rays may miss it.
void ExpectColumnMaxima(vtkImageData* image, const Column& way, const std::array<double, 2>& window,
  double tolerance = Rounding)
{
  int size[3];
  image->GetDimensions(size);
  Stage stage(PixelsASample * size[way.right], PixelsASample * size[way.up]);
  stage.renderer->AddVolume(MakeBrightest(image, window));
  LookAlong(stage, image, way);
  stage.Draw();
  double worst = 0.0;
  for (int v = 1; v < size[way.up] - 1; ++v)
    for (int u = 1; u < size[way.right] - 1; ++u)
    {
      double most = -std::numeric_limits<double>::infinity();
      for (int n = 0; n < size[way.along]; ++n)
      {
        int at[3];
        at[way.along] = n;
        at[way.right] = u;
        at[way.up] = v;
        most = std::max(most, SampleAt(image, at[0], at[1], at[2]));
      }
      const unsigned char* pixel =
        stage.At(PixelsASample * u + PixelsASample / 2, PixelsASample * v + PixelsASample / 2);
      worst = std::max(worst, std::abs(pixel[0] - Grey(most, window)));
    }
  EXPECT_LE(worst, tolerance) << "along axis " << way.along;
}

TEST(Brightest, IsTheLargestSampleOfEachColumn)
{
  for (const auto& [type, low, high] :
    { std::tuple{ VTK_SHORT, -1024.0, 3071.0 }, { VTK_UNSIGNED_CHAR, 0.0, 255.0 },
      { VTK_UNSIGNED_SHORT, 0.0, 65535.0 }, { VTK_FLOAT, -5e5, 5e5 } })
  {
    // So few slices that the maxima are not all alike.
    const auto image = Noise({ 30, 26, 5 }, { 1, 1, 1 }, type, low, high);
    for (const Column way : { Column{ 2, 0, 1 }, { 0, 1, 2 }, { 1, 0, 2 } })
      ExpectColumnMaxima(image, way, { low, high });
  }
}

/// A window of 1 % of the values is ten steps of VTK's table; as the header has it, half of one.
TEST(Brightest, ANarrowWindowIsExactToHalfAStep)
{
  const auto image = Noise({ 40, 40, 3 }, { 1, 1, 1 }, VTK_SHORT, 19900, 20400);
  image->GetPointData()->GetScalars()->SetTuple1(0, -1024);
  image->GetPointData()->GetScalars()->SetTuple1(1, 30000);
  ExpectColumnMaxima(
    image, { 2, 0, 1 }, { 20000, 20300 }, Rounding + 0.5 * 255.0 * (31024.0 / 1024.0) / 300.0);
}

/// As the header has it, where two values are a whole window apart.
TEST(Brightest, TheFarFaceIsMissedByAQuarterOfASampleAtMost)
{
  const auto image = Volume(
    { 20, 20, 2 }, { 1, 1, 1 }, VTK_SHORT, [](int, int, int k) { return k == 0 ? 1000.0 : 0.0; });
  Stage stage(60, 60);
  stage.renderer->AddVolume(MakeBrightest(image, { 0, 1000 }));
  LookAlong(stage, image, { 2, 0, 1 });
  stage.Draw();
  EXPECT_GE(stage.At(31, 31)[0], 0.75 * 255.0 - Rounding);
}

/// Spacings a hundred times apart, from both sides.
TEST(Brightest, LongVoxelsAreShownLong)
{
  const auto slices = Noise({ 24, 20, 5 }, { 0.5, 0.5, 50 }, VTK_SHORT, 0, 1000);
  ExpectColumnMaxima(slices, { 2, 0, 1 }, { 0, 1000 });
  const auto rods = Noise({ 4, 24, 20 }, { 50, 0.5, 0.5 }, VTK_SHORT, 0, 1000);
  ExpectColumnMaxima(rods, { 0, 1, 2 }, { 0, 1000 });
}

TEST(Brightest, ASingleSliceIsAsThickAsItsSpacing)
{
  const auto slice = Noise({ 24, 20, 1 }, { 1, 1, 4 }, VTK_SHORT, 0, 1000);
  ExpectColumnMaxima(slice, { 2, 0, 1 }, { 0, 1000 });
  const auto volume = MakeBrightest(slice, { 0, 1000 });
  const double* bounds = volume->GetBounds();
  EXPECT_DOUBLE_EQ(bounds[4], -2.0);
  EXPECT_DOUBLE_EQ(bounds[5], 2.0);
  // A turned one lies where it lay: its own axis is the world's x.
  slice->SetDirectionMatrix(0, 0, 1, 1, 0, 0, 0, 1, 0);
  slice->SetOrigin(7, 0, 0);
  const double* turned = MakeBrightest(slice, { 0, 1000 })->GetBounds();
  EXPECT_NEAR(turned[0], 5.0, 1e-9);
  EXPECT_NEAR(turned[1], 9.0, 1e-9);
}

/// From askew and near, a turned volume of uneven spacing whose values change by `slope` a mm at
/// most. A sample each quarter of the smallest spacing, 0.2 mm: what is brightest lies at most
/// 0.1 mm from one.
TEST(Brightest, IsWhatAWalkAlongEachRayFinds)
{
  const Point spacing{ 0.8, 1.0, 1.5 };
  const auto wave = [&](int i, int j, int k)
  { return 500.0 * (std::sin(0.5 * i) + std::sin(0.6 * j) + std::sin(0.7 * k)); };
  const auto image = Volume({ 40, 36, 30 }, spacing, VTK_SHORT, wave);
  const double slope = 500.0 * std::hypot(0.5 / 0.8, 0.6 / 1.0, 0.7 / 1.5);
  image->SetDirectionMatrix(
    std::cos(0.4), -std::sin(0.4), 0, std::sin(0.4), std::cos(0.4), 0, 0, 0, 1);
  const std::array<double, 2> window{ -1500, 1500 };
  Stage stage;
  stage.renderer->AddVolume(MakeBrightest(image, window));
  vtkCamera* camera = stage.renderer->GetActiveCamera();
  camera->SetPosition(-1, -1.7, 0.6);
  stage.renderer->ResetCamera();
  camera->Zoom(1.6);
  stage.Draw();
  const double tolerance = Rounding + 0.1 * slope * 255.0 / (window[1] - window[0]);
  constexpr double Step = 0.02, LastSample = 0.2; // mm; a ray may end that much early
  int within = 0;
  for (int y = 2; y < 100; y += 5)
    for (int x = 2; x < 100; x += 5)
    {
      const Point from = stage.World(x + 0.5, y + 0.5, 0.0),
                  to = stage.World(x + 0.5, y + 0.5, 1.0);
      std::vector<double> met;
      const double length = std::sqrt(vtkMath::Distance2BetweenPoints(from.data(), to.data()));
      for (double t = 0.0; t < length; t += Step)
      {
        Point at;
        for (int a = 0; a < 3; ++a)
          at[a] = from[a] + t / length * (to[a] - from[a]);
        if (const double value = ValueAt(image, at); std::isfinite(value))
          met.push_back(value);
      }
      if (Step * double(met.size()) < 2.0) // a corner, or nothing
        continue;
      ++within;
      const auto last = met.end() - int(LastSample / Step);
      const int shown = stage.At(x, y)[0];
      EXPECT_LE(shown, Grey(*std::max_element(met.begin(), met.end()), window) + Rounding);
      EXPECT_GE(shown, Grey(*std::max_element(met.begin(), last), window) - tolerance);
    }
  EXPECT_GT(within, 150);
}

/// An opaque sheet in the middle: what lies before it is over it, what lies behind is not there.
TEST(Brightest, ASurfaceHidesWhatIsBehindIt)
{
  constexpr int Far = 2; // of 8 slices, behind the sheet between slices 3 and 4
  const auto image = Volume({ 20, 20, 8 }, { 1, 1, 1 }, VTK_SHORT,
    [](int i, int, int k) { return k == Far ? 1000.0
                                   : k == 6 ? 30.0 * i
                                            : 0.0; });
  Stage stage(60, 60);
  stage.renderer->AddVolume(MakeBrightest(image, { 0, 1000 }));
  vtkNew<vtkPlaneSource> plane; // over the left half
  plane->SetOrigin(-2, -2, 3.5);
  plane->SetPoint1(9.5, -2, 3.5);
  plane->SetPoint2(-2, 30, 3.5);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> sheet;
  sheet->SetMapper(mapper);
  sheet->GetProperty()->SetColor(1, 0, 0);
  sheet->GetProperty()->LightingOff();
  stage.renderer->AddActor(sheet);
  LookAlong(stage, image, { 2, 0, 1 });
  stage.Draw();
  for (int i = 1; i < 19; ++i)
  {
    const unsigned char* pixel = stage.At(3 * i + 1, 31);
    const double before = Grey(30.0 * i, { 0, 1000 });
    const bool covered = i <= 9;
    EXPECT_NEAR(pixel[0], 255.0, Rounding) << i; // red, or the white of the far slice
    EXPECT_NEAR(pixel[1], covered ? before : 255.0, Rounding) << i;
  }
}

} // namespace
