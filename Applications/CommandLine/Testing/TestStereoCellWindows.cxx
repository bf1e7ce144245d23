// Our mappers keep their buffers a window: several windows of one scene show what each shows alone.
#include "StereoWindow.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspRayCachingMapper.h"
#include "vtkHaspStereoWindows.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace
{

constexpr const char* Layouts[] = { "interlaced", "side-by-side", "left" };

vtkSmartPointer<vtkImageData> Ball()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(24, 24, 24);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* sample = static_cast<float*>(image->GetScalarPointer());
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x)
        *sample++ = static_cast<float>(
          100 - (x - 11.5) * (x - 11.5) - 2 * (y - 11.5) * (y - 11.5) - (z - 11.5) * (z - 11.5));
  return image;
}

vtkSmartPointer<vtkRenderWindow> MakeWindow(int width)
{
  hasp::UseHeadlessWindows();
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(width, 80);
  return window;
}

std::vector<unsigned char> Picture(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, window->GetSize()[0] - 1, 79, 1, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

/// Frames until the picture is complete: rays come by a budget of time.
void DrawComplete(vtkHaspStereoWindows* windows, vtkMapper* mapper)
{
  constexpr int most = 400, enough = 8; // frames, and such in a row without a find
  auto* cache = vtkHaspRayCachingMapper::SafeDownCast(mapper);
  for (int frame = 0, quiet = 0; frame < most && quiet < enough; ++frame)
  {
    ASSERT_TRUE(windows->Render());
    quiet = !cache ? enough : cache->IsRefining() ? 0 : quiet + 1;
  }
}

template <typename Mapper>
void ExpectTheSameInEach()
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(Ball());
  mapper->SetIsoValue(0.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->ResetCamera();
  std::vector<std::vector<unsigned char>> alone;
  std::vector<vtkSmartPointer<vtkRenderWindow>> shown;
  vtkNew<vtkHaspStereoWindows> all;
  all->SetRenderer(renderer);
  for (const char* layout : Layouts)
  {
    const int width = 100 + 20 * static_cast<int>(shown.size());
    const auto window = MakeWindow(width);
    vtkNew<vtkHaspStereoWindows> one;
    one->SetRenderer(renderer);
    one->AddWindow(window, layout);
    DrawComplete(one, mapper);
    alone.push_back(Picture(window));
    shown.push_back(MakeWindow(width));
    all->AddWindow(shown.back(), layout);
  }
  DrawComplete(all, mapper);
  for (std::size_t n = 0; n < shown.size(); ++n)
    EXPECT_EQ(Picture(shown[n]), alone[n]) << Layouts[n];
  EXPECT_NE(alone[2], std::vector<unsigned char>(alone[2].size(), 0));
}

TEST(StereoCellWindows, ClusteredCellsAreInEach)
{
  ExpectTheSameInEach<vtkHaspClusteredCellMapper>();
}

TEST(StereoCellWindows, CachedRaysAreInEach)
{
  ExpectTheSameInEach<vtkHaspRayCachingMapper>();
}

/// How often clusters were culled where a pair of eyes is drawn.
int Passes(vtkHaspClusteredCellMapper* mapper)
{
  hasp::ResourceList list;
  mapper->ListResources(list);
  for (const hasp::ResourceUse& use : list)
    if (use.resource == "clusters both eyes see")
      return std::atoi(use.reason.c_str()); // "one eye": 0
  ADD_FAILURE() << "no such resource";
  return -1;
}

/// Each eye's frame has, to the last bit, the matrix that was said before.
TEST(StereoCellWindows, CellsAreCulledOnceForBothEyes)
{
  for (const auto layout : { hasp::StereoLayout::SideBySide, hasp::StereoLayout::Anaglyph,
         hasp::StereoLayout::Interlaced, hasp::StereoLayout::Left })
  {
    vtkNew<vtkHaspClusteredCellMapper> mapper;
    mapper->SetInputData(Ball());
    mapper->SetIsoValue(0.0);
    mapper->SetRendererToRasterize();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->RotateWXYZ(20, 1, 2, 3);
    vtkNew<vtkRenderer> renderer;
    renderer->AddActor(actor);
    renderer->ResetCamera(0, 23, 0, 23, 0, 23);
    const auto window = MakeWindow(120);
    vtkNew<vtkHaspStereoWindows> windows;
    windows->SetRenderer(renderer);
    windows->AddWindow(window, { { layout, hasp::StereoResolution::Half } });
    const bool two = hasp::NeedsSecondEye(layout);
    for (int pair = 0; pair < 6; ++pair)
    {
      renderer->GetActiveCamera()->Azimuth(7);
      renderer->GetActiveCamera()->Roll(3);
      EXPECT_TRUE(windows->Render());
      EXPECT_EQ(Passes(mapper), two ? pair + 1 : 0) << hasp::StereoLayoutName(layout);
    }
    EXPECT_EQ(renderer->GetActiveCamera()->GetInformation()->GetNumberOfKeys(), 0);
  }
}

/// Share of the mesh's pixels that differ, where both eyes share a window's pixels.
double ShareThatDiffers(vtkMapper* ours, hasp::StereoLayout layout)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(Ball());
  contour->SetValue(0, 0.0);
  vtkNew<vtkPolyDataMapper> mesh;
  mesh->SetInputConnection(contour->GetOutputPort());
  std::vector<std::vector<unsigned char>> pictures;
  for (vtkMapper* mapper : { ours, static_cast<vtkMapper*>(mesh) })
  {
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(1.0);
    vtkNew<vtkRenderer> renderer;
    renderer->AddActor(actor);
    renderer->ResetCamera(0, 23, 0, 23, 0, 23); // a mapper of cells has the volume's bounds
    const auto window = MakeWindow(120);
    vtkNew<vtkHaspStereoWindows> windows;
    windows->SetRenderer(renderer);
    windows->AddWindow(window, { { layout, hasp::StereoResolution::Half } });
    DrawComplete(windows, mapper);
    pictures.push_back(Picture(window));
  }
  double differ = 0.0, inside = 0.0;
  for (std::size_t n = 0; n < pictures[0].size(); n += 3)
  {
    differ += (pictures[0][n] > 20) != (pictures[1][n] > 20);
    inside += pictures[1][n] > 20;
  }
  return differ / inside;
}

TEST(StereoCellWindows, StretchedAndShiftedEyesAreThoseOfAMesh)
{
  for (const auto layout : { hasp::StereoLayout::SideBySide, hasp::StereoLayout::TopBottom,
         hasp::StereoLayout::Interlaced, hasp::StereoLayout::Checkerboard })
  {
    vtkNew<vtkHaspClusteredCellMapper> cells;
    cells->SetInputData(Ball());
    cells->SetIsoValue(0.0);
    // A pixel here and there on outlines of 150 pixels around 1500.
    EXPECT_LT(ShareThatDiffers(cells, layout), 0.005) << hasp::StereoLayoutName(layout);
    vtkNew<vtkHaspRayCachingMapper> cache;
    cache->SetInputData(Ball());
    cache->SetIsoValue(0.0);
    EXPECT_LT(ShareThatDiffers(cache, layout), 0.005) << hasp::StereoLayoutName(layout);
  }
}

} // namespace
