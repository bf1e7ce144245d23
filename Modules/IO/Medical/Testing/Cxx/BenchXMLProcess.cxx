// What the child process costs: Hasp's reading of VTK's XML files against VTK's own in this
// process, both from a warm cache. Prints medians; fails only where the two differ. On a busy
// machine look at the processor time.
#include "SurfaceFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

namespace
{

class BenchXMLProcess : public SurfaceFixture
{
protected:
  struct Times
  {
    double wallMs = 0.0, cpuMs = 0.0; ///< of this process and its children
  };
  static double CpuMs()
  {
    double ms = 0.0;
    for (const auto who : { RUSAGE_SELF, RUSAGE_CHILDREN })
    {
      rusage use{};
      getrusage(who, &use);
      for (const timeval& t : { use.ru_utime, use.ru_stime })
        ms += 1e3 * double(t.tv_sec) + 1e-3 * double(t.tv_usec);
    }
    return ms;
  }
  static Times MedianOf(const std::function<void()>& work)
  {
    std::vector<double> wall, cpu;
    for (int n = 0; n < 7; ++n)
    {
      const auto start = std::chrono::steady_clock::now();
      const double cpuStart = CpuMs();
      work();
      cpu.push_back(CpuMs() - cpuStart);
      wall.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
          .count());
    }
    std::nth_element(wall.begin(), wall.begin() + 3, wall.end());
    std::nth_element(cpu.begin(), cpu.begin() + 3, cpu.end());
    return { wall[3], cpu[3] };
  }
  static void Print(const std::string& what, const Times& ours, const char* how)
  {
    std::printf(
      "%-28s %-26s %8.2f ms, %8.2f ms of processor\n", what.c_str(), how, ours.wallMs, ours.cpuMs);
  }
};

TEST_F(BenchXMLProcess, Images)
{
  for (const int side : { 64, 256 })
  {
    const hasp::GridGeometry g{ { side, side, side }, {}, { 1, 1, 1 } };
    std::vector<std::int16_t> samples(g.Size());
    for (std::size_t n = 0; n < samples.size(); ++n) // neither noise nor constant
      samples[n] = static_cast<std::int16_t>((n * n >> 7) % 3000 & ~63);
    const auto file = (this->Folder / "a.vti").string();
    hasp::WriteVolume(hasp::MakeImage(g, samples), file);
    hasp::LoadedVolume volume;
    const Times child = MedianOf([&] { volume = IOFixture::Read(file); });
    vtkSmartPointer<vtkXMLImageDataReader> reader;
    const Times own = MedianOf(
      [&]
      {
        reader = vtkSmartPointer<vtkXMLImageDataReader>::New();
        reader->SetFileName(file.c_str());
        reader->Update();
      });
    EXPECT_EQ(std::memcmp(volume.image->GetScalarPointer(), reader->GetOutput()->GetScalarPointer(),
                samples.size() * sizeof(samples[0])),
      0);
    const std::string what = std::to_string(side) + "^3 .vti, LZ4";
    Print(what, child, "Hasp, child process");
    Print(what, own, "VTK, in process");
  }
}

TEST_F(BenchXMLProcess, Surface)
{
  hasp::TriangleMesh mesh; // a bumpy sheet
  constexpr unsigned side = 571;
  for (unsigned y = 0; y < side; ++y)
    for (unsigned x = 0; x < side; ++x)
      mesh.points.emplace_back(0.5F * x, 0.5F * y, float(std::sin(0.1 * x) * std::cos(0.07 * y)));
  for (unsigned y = 0; y + 1 < side; ++y)
    for (unsigned x = 0; x + 1 < side; ++x)
    {
      const unsigned a = y * side + x;
      mesh.triangles.emplace_back(a, a + 1, a + side);
      mesh.triangles.emplace_back(a + 1, a + side + 1, a + side);
    }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(hasp::MakePolyData(mesh));
  writer->SetFileName((this->Folder / "a.vtp").c_str());
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  writer->Write();
  hasp::LoadedSurface surface;
  const Times child =
    MedianOf([&] { surface = hasp::LoadSurface((this->Folder / "a.vtp").string()); });
  vtkSmartPointer<vtkXMLPolyDataReader> reader;
  const Times own = MedianOf(
    [&]
    {
      reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
      reader->SetFileName((this->Folder / "a.vtp").c_str());
      reader->Update();
    });
  ExpectSame(surface, hasp::MakeTriangleMesh(reader->GetOutput()));
  const std::string what = std::to_string(mesh.triangles.size()) + " triangles .vtp, LZ4";
  Print(what, child, "Hasp, child process");
  Print(what, own, "VTK, in process");
  for (const char* name : { "a.stl", "a.ply", "a.obj" })
  {
    const auto file = (this->Folder / name).string();
    hasp::WriteSurface(surface.surface, file);
    const Times ours = MedianOf([&] { hasp::LoadSurface(file); });
    Print(std::string("the same as ") + name, ours, "Hasp, in process");
  }
}

} // namespace
