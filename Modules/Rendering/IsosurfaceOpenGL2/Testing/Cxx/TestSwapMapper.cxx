// A VTK program that knows nothing of Hasp runs with its mapper's class name changed and nothing
// else: reader, mapper, actor; own lights, clipping plane, lookup table, picker, two windows,
// samples changed in place.
#include "Grid/AnalyticVolumes.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkExecutive.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMetaImageReader.h"
#include "vtkMetaImageWriter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace
{

/// What VTK offers for the same: a contour and its mesh, as one mapper (the way of
/// vtkDataSetMapper).
class ContourMapper : public vtkMapper
{
public:
  static ContourMapper* New();
  vtkTypeMacro(ContourMapper, vtkMapper);
  double* GetBounds() override
  {
    this->GetInputAlgorithm()->Update();
    this->GetInput()->GetBounds(this->Bounds);
    return this->Bounds;
  }
  void Render(vtkRenderer* renderer, vtkActor* actor) override
  {
    this->GetInputAlgorithm()->Update();
    double range[2];
    this->GetInput()->GetScalarRange(range);
    this->Contour->SetInputData(this->GetInput());
    this->Contour->SetValue(0, 0.5 * (range[0] + range[1]));
    this->Mesh->SetClippingPlanes(this->ClippingPlanes);
    this->Mesh->SetScalarVisibility(this->ScalarVisibility);
    this->Mesh->SetLookupTable(this->GetLookupTable());
    this->Mesh->SetScalarRange(this->ScalarRange);
    this->Mesh->Render(renderer, actor);
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Mesh->ReleaseGraphicsResources(window);
  }
  bool GetSupportsSelection() override { return true; }

protected:
  ContourMapper() { this->Mesh->SetInputConnection(this->Contour->GetOutputPort()); }
  int FillInputPortInformation(int, vtkInformation* info) override
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
    return 1;
  }
  vtkNew<vtkFlyingEdges3D> Contour;
  vtkNew<vtkPolyDataMapper> Mesh;
};
vtkStandardNewMacro(ContourMapper);

struct Shown
{
  std::vector<std::vector<unsigned char>> pictures;
  std::vector<double> numbers; ///< bounds, dimensions, picks
};

struct ProgramWindow
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  ProgramWindow(vtkActor* actor, double x, double y)
  {
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(150, 120);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.2, 0.2, 0.3);
    this->Renderer->AddActor(actor);
    this->Renderer->AutomaticLightCreationOff();
    vtkNew<vtkLight> key, fill;
    key->SetPosition(-100, -100, 200);
    fill->SetLightTypeToHeadlight();
    fill->SetIntensity(0.4);
    fill->SetColor(0.6, 0.8, 1);
    this->Renderer->AddLight(key);
    this->Renderer->AddLight(fill);
    this->Renderer->GetActiveCamera()->SetPosition(x, y, 60);
    this->Renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
    this->Renderer->ResetCamera();
  }
  void Show(Shown& shown)
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, 149, 119, 1, pixels);
    shown.pictures.emplace_back(
      pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  }
};

/// The program. Mapper is its only parameter.
template <typename Mapper>
Shown RunProgram(const char* file)
{
  Shown shown;
  vtkNew<vtkMetaImageReader> reader;
  reader->SetFileName(file);
  vtkNew<Mapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->Update();
  const double* bounds = mapper->GetBounds();
  shown.numbers.assign(bounds, bounds + 6);
  shown.numbers.push_back(static_cast<double>(mapper->GetInput()->GetNumberOfPoints()));
  shown.numbers.push_back(mapper->GetLength());

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.8, 0.6);
  actor->GetProperty()->SetSpecular(0.3);
  actor->GetProperty()->SetSpecularPower(15);
  actor->SetScale(1, 1, 1.2);
  actor->RotateX(10);
  ProgramWindow first(actor, 40, -200), second(actor, -150, -100);
  first.Show(shown);
  second.Show(shown);

  vtkNew<vtkPropPicker> picker;
  for (const int x : { 75, 5 }) // a hit and a miss
    shown.numbers.push_back(picker->Pick(x, 60, 0, first.Renderer) && picker->GetActor() == actor);

  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.3, 1, 0);
  mapper->AddClippingPlane(plane);
  first.Show(shown);
  plane->SetOrigin(0, -6, 0);
  first.Show(shown);

  vtkNew<vtkLookupTable> table;
  table->SetHueRange(0.1, 0.9);
  table->Build();
  mapper->SetLookupTable(table);
  mapper->SetScalarRange(-1000, 3000);
  mapper->ScalarVisibilityOn();
  first.Show(shown);
  mapper->ScalarVisibilityOff();
  mapper->RemoveAllClippingPlanes();

  vtkImageData* image = reader->GetOutput(); // drill a hole
  const int* dims = image->GetDimensions();
  for (int k = 0; k < dims[2]; ++k)
    for (int j = dims[1] / 2 - 4; j < dims[1] / 2 + 4; ++j)
      for (int i = 0; i < dims[0]; ++i)
        if (std::hypot(j - dims[1] / 2, k - dims[2] / 2) < 4)
          *static_cast<short*>(image->GetScalarPointer(i, j, k)) = -1500;
  image->Modified();
  first.Show(shown);
  second.Show(shown);
  actor->GetProperty()->SetOpacity(0.5);
  first.Show(shown);
  return shown;
}

TEST(SwapMapper, AProgramRunsWithTheClassNameChanged)
{
  hasp::UseHeadlessWindows();
  const auto file =
    std::filesystem::temp_directory_path() / ("hasp-swap-" + std::to_string(getpid()) + ".mha");
  hasp::GridGeometry g{ { 50, 44, 40 }, { -24, -21, -19 }, { 1, 1, 1 }, glm::dmat3(1) };
  vtkNew<vtkMetaImageWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetCompression(false);
  writer->SetInputData(
    hasp::MakeImage(g, hasp::SampleAnalytic<std::int16_t>(
                         hasp::AnalyticTorus({ 0, 0, 0 }, { 0, 0.6, 0.8 }, 12, 6), g, 100, 0)));
  writer->Write();
  const Shown ours = RunProgram<vtkHaspClusteredCellMapper>(file.c_str());
  const Shown theirs = RunProgram<ContourMapper>(file.c_str());
  std::filesystem::remove(file);

  EXPECT_EQ(ours.numbers, theirs.numbers);
  ASSERT_EQ(ours.pictures.size(), 8U);
  for (std::size_t p = 0; p < ours.pictures.size(); ++p)
  {
    const auto &a = ours.pictures[p], &b = theirs.pictures[p];
    ASSERT_EQ(a.size(), b.size());
    double sum = 0.0;
    int far = 0, drawn = 0;
    for (std::size_t n = 0; n < a.size(); n += 3)
    {
      int most = 0;
      for (int c = 0; c < 3; ++c)
      {
        most = std::max(most, std::abs(a[n + c] - b[n + c]));
        sum += std::abs(a[n + c] - b[n + c]);
      }
      far += most > 60;
      drawn += std::abs(a[n] - a[0]) > 10;
    }
    EXPECT_GT(drawn, 1500) << "picture " << p;
    // Mesh and trilinear surface differ by some hundredths of a voxel, normals by a few degrees
    // where the torus bends; some pixels of the outline, 2 % of all at most, go to the other side.
    EXPECT_LT(sum / static_cast<double>(a.size()), 2.5) << "picture " << p;
    EXPECT_LT(far, 360) << "picture " << p;
    if (p > 0)
    {
      EXPECT_NE(a, ours.pictures[p - 1]) << "nothing changed in picture " << p;
    }
  }
}

} // namespace
