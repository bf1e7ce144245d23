// Frame time against error of one surface drawn four ways, in turn within each round: our discs,
// VTK's glyphs of discs (vtkGlyph3DMapper), VTK's point gaussians and the Flying Edges mesh. A
// torus in 600 x 600 pixels; depth is judged along the ray against the closed form, normals by what
// light of three axes makes of them.
//
//   bin/BenchPointShell [rounds]      median of so many frames, each with glFinish by reading a
//   pixel
#include "DiscScene.h"

#include "vtkDiskSource.h"
#include "vtkFlyingEdges3D.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace
{
using hasp::testing::DiscScene;

constexpr double Large = 14.0, Small = 6.0; // mm

double Distance(const glm::dvec3& p)
{
  return std::hypot(std::hypot(p.x, p.y) - Large, p.z) - Small;
}

glm::dvec3 Normal(const glm::dvec3& p)
{
  const double ring = std::hypot(p.x, p.y);
  return glm::normalize(p - glm::dvec3(p.x, p.y, 0) * (Large / ring));
}

/// On the torus, even per area: rows across the tube, each with points as far apart as rows are.
std::shared_ptr<std::vector<hasp::ShellDisc>> TorusDiscs(int about)
{
  const double pi = std::numbers::pi, area = 4 * pi * pi * Large * Small;
  const double step = std::sqrt(area / about);
  auto discs = std::make_shared<std::vector<hasp::ShellDisc>>();
  const int rows = std::max(3, int(std::lround(2 * pi * Small / step)));
  for (int row = 0; row < rows; ++row)
  {
    const double v = 2 * pi * row / rows, ring = Large + Small * std::cos(v);
    const int count = std::max(3, int(std::lround(2 * pi * ring / step)));
    for (int n = 0; n < count; ++n)
    {
      const double u = 2 * pi * (n + 0.5 * (row % 2)) / count;
      const glm::dvec3 out(std::cos(u), std::sin(u), 0);
      const glm::dvec3 normal = std::cos(v) * out + glm::dvec3(0, 0, std::sin(v));
      discs->push_back({ Large * out + Small * normal,
        static_cast<float>((2 * pi * Small / rows) * (2 * pi * ring / count)), normal, 0 });
    }
  }
  return discs;
}

vtkNew<vtkPolyData> Points(const std::vector<hasp::ShellDisc>& discs)
{
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  vtkNew<vtkFloatArray> normals, radii;
  normals->SetName("normal");
  normals->SetNumberOfComponents(3);
  radii->SetName("radius");
  for (const hasp::ShellDisc& disc : discs)
  {
    places->InsertNextPoint(disc.center.x, disc.center.y, disc.center.z);
    normals->InsertNextTuple3(disc.normal.x, disc.normal.y, disc.normal.z);
    radii->InsertNextValue(1.8F * std::sqrt(disc.areaMm2 * std::numbers::inv_pi_v<float>));
  }
  points->SetPoints(places);
  points->GetPointData()->AddArray(normals);
  points->GetPointData()->AddArray(radii);
  return points;
}

vtkSmartPointer<vtkMapper> Glyphs(vtkPolyData* points)
{
  vtkNew<vtkDiskSource> disc; // in the plane z = 0; glyphs turn x into the normal
  disc->SetInnerRadius(0);
  disc->SetOuterRadius(1);
  disc->SetCircumferentialResolution(12);
  disc->Update();
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(disc->GetOutput());
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (vtkIdType n = 0; n < turned->GetNumberOfPoints(); ++n)
  {
    double p[3];
    turned->GetPoint(n, p);
    turned->GetPoints()->SetPoint(n, 0, p[0], p[1]);
    normals->InsertNextTuple3(1, 0, 0);
  }
  turned->GetPointData()->SetNormals(normals);
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(points);
  mapper->SetSourceData(turned);
  mapper->SetOrientationArray("normal");
  mapper->SetOrientationModeToDirection();
  mapper->SetScaleArray("radius");
  mapper->SetScaleModeToScaleByMagnitude();
  return mapper;
}

vtkSmartPointer<vtkMapper> Gaussians(vtkPolyData* points)
{
  auto mapper = vtkSmartPointer<vtkPointGaussianMapper>::New();
  mapper->SetInputData(points);
  mapper->SetScaleArray("radius");
  mapper->SetScaleFactor(1.0);
  mapper->EmissiveOff();
  // Without a shader of its own it is a blurred, unlit dot: this one is an opaque circle.
  mapper->SetSplatShaderCode(
    "//VTK::Color::Impl\nif (dot(offsetVCVSOutput, offsetVCVSOutput) > 1.0) discard;\n");
  return mapper;
}

vtkSmartPointer<vtkMapper> Mesh(int samples)
{
  vtkNew<vtkImageData> image;
  const double spacing = 44.0 / (samples - 1);
  image->SetDimensions(samples, samples, samples);
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(-22, -22, -22);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    double p[3];
    image->GetPoint(n, p);
    values[n] = static_cast<float>(Distance({ p[0], p[1], p[2] }));
  }
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0.0);
  edges->Update();
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(edges->GetOutput());
  mapper->ScalarVisibilityOff();
  return mapper;
}

struct Way
{
  std::string name;
  vtkIdType count; ///< points, or triangles
  std::unique_ptr<DiscScene> scene = std::make_unique<DiscScene>(600);
  std::vector<double> milliseconds{};

  void Prepare(vtkMapper* mapper)
  {
    this->scene->Actor->SetMapper(mapper);
    this->scene->Look({ 0, -60, 70 }, { 0, 0, 1 });
  }
  void Time()
  {
    const auto start = std::chrono::steady_clock::now();
    this->scene->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixel;
    this->scene->Window->GetPixelData(0, 0, 0, 0, 1, pixel);
    this->milliseconds.push_back(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  void Print()
  {
    std::sort(this->milliseconds.begin(), this->milliseconds.end());
    const auto pixels = this->scene->Draw();
    const auto normals = this->scene->Normals();
    double square = 0.0, degrees = 0.0;
    int hits = 0;
    for (std::size_t n = 0; n < pixels.size(); ++n)
    {
      if (!pixels[n].hit || std::abs(glm::dot(Normal(*pixels[n].hit), pixels[n].direction)) < 0.2)
        continue; // rims of the silhouette are judged by pixels, not by depth
      const double off = Distance(*pixels[n].hit);
      square += off * off;
      const double length = glm::length(normals[n]);
      const double cosine =
        length > 0.0 ? glm::dot(normals[n], Normal(*pixels[n].hit)) / length : 0.0;
      degrees += std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
      ++hits;
    }
    std::printf("%-28s %9lld  %8.1f  %9.4f  %8.2f  %7d\n", this->name.c_str(),
      static_cast<long long>(this->count), this->milliseconds[this->milliseconds.size() / 2],
      std::sqrt(square / hits), degrees / hits, hits);
  }
};

} // namespace

int main(int argc, char* argv[])
{
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 15;
  std::vector<Way> ways;
  for (const int count : { 1000, 4000, 16'000, 64'000 })
  {
    const auto discs = TorusDiscs(count);
    const auto points = Points(*discs);
    const auto size = static_cast<vtkIdType>(discs->size());
    Way& ours = ways.emplace_back(Way{ "discs", size });
    ours.scene->Mapper->SetDiscs(discs);
    ours.Prepare(ours.scene->Mapper);
    ways.emplace_back(Way{ "vtkGlyph3DMapper", size }).Prepare(Glyphs(points));
    ways.emplace_back(Way{ "vtkPointGaussianMapper", size }).Prepare(Gaussians(points));
  }
  for (const int samples : { 24, 48, 96, 192 })
  {
    const auto mesh = Mesh(samples);
    ways
      .emplace_back(Way{ "Flying Edges, " + std::to_string(samples) + "^3",
        vtkPolyData::SafeDownCast(mesh->GetInputDataObject(0, 0))->GetNumberOfCells() })
      .Prepare(mesh);
  }
  for (int round = -1; round < rounds; ++round) // the first uploads and compiles
    for (Way& way : ways)
    {
      way.Time();
      if (round < 0)
        way.milliseconds.clear();
    }
  std::printf("%-28s %9s  %8s  %9s  %8s  %7s\n", "drawn as", "parts", "ms/frame", "RMS mm",
    "degrees", "pixels");
  for (Way& way : ways)
    way.Print();
}
