#include "IOFixture.h"

#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspSurfaceReader.h"
#include "vtkHaspSurfaceWriter.h"
#include "vtkHaspVolumeReader.h"
#include "vtkHaspVolumeSlabs.h"
#include "vtkHaspVolumeView.h"
#include "vtkHaspVolumeWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>

namespace
{

class Writers : public IOFixture
{
protected:
  /// A fan of 60 triangles: 3084 bytes.
  static vtkSmartPointer<vtkPolyData> Surface()
  {
    hasp::TriangleMesh mesh{ { { 0, 0, 0 } }, {} };
    for (unsigned n = 0; n <= 60; ++n)
      mesh.points.emplace_back(std::cos(0.1 * n), std::sin(0.1 * n), 5.0);
    for (unsigned n = 1; n <= 60; ++n)
      mesh.triangles.emplace_back(0, n, n + 1);
    return hasp::MakePolyData(mesh);
  }
  /// 1.5 MiB that do not compress below the limit of LimitFileSize.
  static vtkSmartPointer<vtkImageData> Large()
  {
    const hasp::GridGeometry g{ { 96, 96, 86 }, {}, { 1, 1, 1 } };
    std::vector<std::int16_t> samples(g.Size());
    std::mt19937 random(1);
    for (auto& sample : samples)
      sample = static_cast<std::int16_t>(random());
    return hasp::MakeImage(g, samples);
  }
  std::size_t FilesThere() const
  {
    return std::distance(std::filesystem::directory_iterator(this->Folder), {});
  }
  /// Writes that go beyond fail as on a full disk, for this process and while this lives.
  struct LimitFileSize
  {
    explicit LimitFileSize(rlim_t bytes) : Handler(std::signal(SIGXFSZ, SIG_IGN))
    {
      getrlimit(RLIMIT_FSIZE, &this->Before);
      const rlimit now{ bytes, this->Before.rlim_max };
      setrlimit(RLIMIT_FSIZE, &now);
    }
    ~LimitFileSize()
    {
      setrlimit(RLIMIT_FSIZE, &this->Before);
      std::signal(SIGXFSZ, this->Handler);
    }
    rlimit Before{};
    void (*Handler)(int);
  };
};

TEST_F(Writers, FullDiskLeavesTheOldFileAndNothingElse)
{
  for (const char* name : { "a.mha", "a.vti" })
  {
    SCOPED_TRACE(name);
    const auto file = this->Folder / name;
    WriteBytes(file, "the old file");
    {
      const LimitFileSize limit(1 << 20);
      EXPECT_THROW(hasp::WriteVolume(Large(), file.string()), std::runtime_error);
    }
    EXPECT_EQ(ReadBytes(file), "the old file");
    EXPECT_EQ(this->FilesThere(), 1U);
    std::filesystem::remove(file);
  }
  const auto file = this->Folder / "a.stl";
  WriteBytes(file, "the old file");
  {
    const LimitFileSize limit(1000);
    EXPECT_THROW(hasp::WriteSurface(Surface(), file.string()), std::runtime_error);
  }
  EXPECT_EQ(ReadBytes(file), "the old file");
  EXPECT_EQ(this->FilesThere(), 1U);
}

TEST_F(Writers, AWriteThatFailedInItsLastBytesCannotBeFinished)
{
  const auto g = this->Truth();
  const std::string file = (this->Folder / "a.nii.gz").string();
  hasp::VolumeSlabWriter writer(file, g, hasp::SampleType::Int16);
  writer.Append(Samples(g)); // so few that zlib keeps them to itself
  {
    const LimitFileSize limit(16);
    EXPECT_THROW(writer.Commit(), std::runtime_error);
  }
  EXPECT_THROW(writer.Commit(), std::invalid_argument) << "a part of the file is lost";
  EXPECT_EQ(this->FilesThere(), 0U);
}

TEST_F(Writers, UnwritableNamesAreErrors)
{
  const auto g = this->Truth();
  const auto image = hasp::MakeImage(g, Samples(g));
  for (const char* name : { "absent/a.mha", "absent/a.vti", "a.hdr", "a", "" })
  {
    SCOPED_TRACE(name);
    EXPECT_THROW(hasp::WriteVolume(image, (this->Folder / name).string()), std::runtime_error);
    EXPECT_THROW(hasp::WriteSurface(Surface(), (this->Folder / name).string()), std::runtime_error);
  }
  std::filesystem::create_directories(this->Folder / "folder.mha");
  EXPECT_THROW(
    hasp::WriteVolume(image, (this->Folder / "folder.mha").string()), std::runtime_error);
  EXPECT_EQ(this->FilesThere(), 1U);
}

TEST_F(Writers, EndingsMayBeInCapitalsAsForReaders)
{
  const auto image = hasp::MakeImage(this->Truth(), Samples(this->Truth()));
  for (const char* name : { "A.MHA", "A.Vti" })
  {
    hasp::WriteVolume(image, (this->Folder / name).string());
    ExpectSame(Read(this->Folder / name), this->Truth(), Samples(this->Truth()));
  }
  hasp::WriteSurface(Surface(), (this->Folder / "A.STL").string());
  EXPECT_EQ(ReadBytes(this->Folder / "A.STL").size(), 84U + 60 * 50);
}

TEST_F(Writers, WhatFailsItsInspectionIsNotPutInPlace)
{
  const auto file = this->Folder / "a.stl";
  WriteBytes(file, "the old file");
  const auto refuse = [](const std::string&) -> hasp::PartVerdict
  { throw std::domain_error("no"); };
  EXPECT_THROW(hasp::WriteSurface(Surface(), file.string(), {}, refuse), std::domain_error);
  EXPECT_EQ(ReadBytes(file), "the old file");
  std::string inspected;
  hasp::WriteSurface(Surface(), file.string(), {},
    [&](const std::string& pending)
    {
      inspected = ReadBytes(pending);
      EXPECT_EQ(ReadBytes(file), "the old file");
      return hasp::PartVerdict::Holds;
    });
  EXPECT_EQ(inspected.size(), 84U + 60 * 50);
  EXPECT_EQ(ReadBytes(file), inspected);
  EXPECT_EQ(this->FilesThere(), 1U);
}

TEST_F(Writers, ASignalHandlerCanRemoveWhatIsUnderWay)
{
  const auto file = this->Folder / "a.stl";
  WriteBytes(file, "the old file");
  const auto remove = [&](const std::string&)
  {
    EXPECT_EQ(this->FilesThere(), 2U);
    hasp::RemovePendingFiles();
    EXPECT_EQ(this->FilesThere(), 1U);
    return hasp::PartVerdict::Holds;
  };
  EXPECT_THROW(hasp::WriteSurface(Surface(), file.string(), {}, remove), std::runtime_error);
  EXPECT_EQ(ReadBytes(file), "the old file");
  for (int n = 0; n < 40; ++n) // more than are noted at once: each is forgotten again
    hasp::WriteSurface(Surface(), file.string());
  hasp::RemovePendingFiles();
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(Writers, NamesMayBeAsLongAsTheFileSystemAllows)
{
  const auto file = this->Folder / std::string(255, 'a');
  hasp::WriteBytes("text", file.string());
  EXPECT_EQ(ReadBytes(file), "text");
  EXPECT_EQ(this->FilesThere(), 1U);
}

TEST_F(Writers, BadSurfacesAreRefusedAndTheOldFileSurvives)
{
  const auto file = (this->Folder / "a.stl").string();
  WriteBytes(file, "the old file");
  vtkNew<vtkPolyData> empty;
  EXPECT_THROW(hasp::WriteSurface(empty, file), std::invalid_argument);
  EXPECT_THROW(hasp::WriteSurface(nullptr, file), std::invalid_argument);
  vtkNew<vtkPolyData> strips;
  strips->ShallowCopy(Surface());
  vtkNew<vtkCellArray> strip;
  strip->InsertNextCell({ 0, 1, 2, 3 });
  strips->SetStrips(strip);
  EXPECT_THROW(hasp::WriteSurface(strips, file), std::invalid_argument);
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), 1e300 })
  {
    hasp::TriangleMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, bad, 0 } }, { { 0, 1, 2 } } };
    EXPECT_THROW(hasp::WriteSurface(hasp::MakePolyData(mesh), file), std::invalid_argument);
  }
  EXPECT_EQ(ReadBytes(file), "the old file");
  EXPECT_EQ(this->FilesThere(), 1U);
}

TEST_F(Writers, SurfaceReadsBackByVTKWithUnitsSpaceAndChirality)
{
  // An L of three triangles in space: no mirror image of it can be turned into it.
  const hasp::TriangleMesh mesh{ { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 20, 0 }, { 0, 0, 30.125 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 } } };
  const auto file = this->Folder / "\xC3\xA9 \xD0\xB6.stl";
  WriteBytes(file, "the old file");
  vtkNew<vtkHaspSurfaceWriter> writer;
  writer->SetInputData(hasp::MakePolyData(mesh));
  writer->SetFileName(file.c_str());
  ASSERT_EQ(writer->Write(), 1);
  const std::string bytes = ReadBytes(file);
  ASSERT_EQ(bytes.size(), 84U + 3 * 50);
  EXPECT_EQ(bytes.compare(0, 4, "Hasp"), 0);
  EXPECT_LT(bytes.find("SPACE=LPS; UNIT=mm"), 80U);
  float normal[3];
  std::memcpy(normal, bytes.data() + 84, sizeof(normal));
  EXPECT_EQ(normal[2], -1.0F); // first triangle: counter-clockwise seen from below
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  const auto back = hasp::MakeTriangleMesh(reader->GetOutput());
  ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(back.points[back.triangles[t][c]], mesh.points[mesh.triangles[t][c]]);
  EXPECT_EQ(this->FilesThere(), 1U);
}

TEST_F(Writers, NewFilesHaveTheRightsOfAnyNewFileAndOldOnesKeepTheirs)
{
  const auto file = this->Folder / "a.stl", plain = this->Folder / "plain";
  WriteBytes(plain, "");
  hasp::WriteSurface(Surface(), file.string());
  EXPECT_EQ(
    std::filesystem::status(file).permissions(), std::filesystem::status(plain).permissions());
  const auto secret = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(file, secret);
  hasp::WriteSurface(Surface(), file.string());
  EXPECT_EQ(std::filesystem::status(file).permissions(), secret);
}

TEST_F(Writers, VTKClassesReportByErrorCodeAndMacro)
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* n, void*) { ++*static_cast<int*>(n); });
  vtkNew<vtkHaspVolumeWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, count);
  writer->SetInputData(hasp::MakeImage(this->Truth(), Samples(this->Truth())));
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(errors, 1);
  writer->SetFileName((this->Folder / "absent" / "a.vti").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(errors, 2);
  writer->SetFileName((this->Folder / "a.vti").c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(errors, 2);
  ExpectSame(Read(this->Folder / "a.vti"), this->Truth(), Samples(this->Truth()));
}

TEST_F(Writers, PrintedObjectsDoNotNameTheFile)
{
  hasp::ShowFileNames(false);
  vtkNew<vtkHaspVolumeWriter> volumeWriter;
  vtkNew<vtkHaspSurfaceWriter> surfaceWriter;
  vtkNew<vtkHaspVolumeReader> volumeReader;
  vtkNew<vtkHaspSurfaceReader> surfaceReader;
  std::ostringstream text;
  const auto print = [&](auto* object, const char* name)
  {
    object->SetFileName(name);
    object->Print(text);
  };
  print(volumeWriter.Get(), "Miller^Ann/Miller.mha");
  print(surfaceWriter.Get(), "Miller^Ann/Miller.stl");
  print(volumeReader.Get(), "Miller^Ann/Miller.nii");
  print(surfaceReader.Get(), "Miller^Ann/Miller.ply");
  EXPECT_EQ(text.str().find("Miller"), std::string::npos) << text.str();
  for (const char* label : { "the .mha file", "the .stl file", "the .nii file", "the .ply file" })
    EXPECT_NE(text.str().find(label), std::string::npos) << label;
}

TEST_F(Writers, AFailedInputIsAFailedWrite)
{
  vtkNew<vtkCallbackCommand> silent;
  silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  vtkNew<vtkHaspVolumeReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, silent);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silent);
  reader->SetFileName((this->Folder / "absent.mha").c_str());
  vtkNew<vtkHaspVolumeWriter> volume;
  volume->SetInputConnection(reader->GetOutputPort());
  volume->SetFileName((this->Folder / "a.vti").c_str());
  EXPECT_EQ(volume->Write(), 0);
  vtkNew<vtkSTLReader> mesh;
  mesh->AddObserver(vtkCommand::ErrorEvent, silent);
  mesh->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silent);
  mesh->SetFileName((this->Folder / "absent.stl").c_str());
  vtkNew<vtkHaspSurfaceWriter> surface;
  surface->AddObserver(vtkCommand::ErrorEvent, silent);
  surface->SetInputConnection(mesh->GetOutputPort());
  surface->SetFileName((this->Folder / "a.stl").c_str());
  EXPECT_EQ(surface->Write(), 0);
  EXPECT_NE(surface->GetErrorCode(), 0u);
  EXPECT_EQ(this->FilesThere(), 0u);
}

} // namespace
