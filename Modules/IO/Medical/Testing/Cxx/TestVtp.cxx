#include "SurfaceFixture.h"

#include "XML/XMLWire.h"
#include "vtkHaspVolumeView.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>

namespace
{

class Vtp : public SurfaceFixture
{
protected:
  ~Vtp() override { unsetenv("HASP_XML_DECODER"); }

  static std::string Text() { return Bytes(Form::Vtp, Truth(), ""); }

  /// A program in the place of the real one.
  void Pretend(const std::string& script) const
  {
    const auto file = this->Folder / "decoder";
    WriteBytes(file, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("HASP_XML_DECODER", file.c_str(), 1);
  }
  /// One that answers with this record and these bytes.
  template <typename Record>
  void Answer(const Record& record, const std::string& more) const
  {
    std::string bytes;
    const hasp::XMLFrame busy{ hasp::XMLFrame::Magic, hasp::XMLFrame::Busy, 0.5 };
    const hasp::XMLFrame answer{ hasp::XMLFrame::Magic, hasp::XMLFrame::Answer, 1.0 };
    AppendBytes(bytes, &busy, 1);
    AppendBytes(bytes, &answer, 1);
    AppendBytes(bytes, &record, 1);
    WriteBytes(this->Folder / "answer", bytes + more);
    this->Pretend("exec cat '" + (this->Folder / "answer").string() + "'");
  }
  static hasp::XMLSurfaceRecord Sound()
  {
    hasp::XMLSurfaceRecord record{};
    record.coordinateBytes = 4;
    record.saysLps = 1;
    record.points = 3;
    record.faces = 1;
    record.corners = 3;
    return record;
  }
  static std::string SoundBytes(std::uint32_t lastCorner = 2, std::uint32_t corners = 3)
  {
    const float points[9] = { 0, 0, 0, 10, 0, 0, 0, 10, 0 };
    const std::uint32_t face[4] = { corners, 0, 1, lastCorner };
    std::string bytes;
    AppendBytes(bytes, points, 9);
    AppendBytes(bytes, face, 4);
    return bytes;
  }
};

TEST_F(Vtp, EveryWayOfWritingIsRead)
{
  for (int compressor = 0; compressor < 4; ++compressor)
    for (int mode = 0; mode < 4; ++mode)
    {
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetInputData(hasp::MakePolyData(Truth()));
      writer->SetFileName((this->Folder / "a.vtp").c_str());
      writer->SetCompressorType(compressor);
      writer->SetDataMode(mode == 3 ? vtkXMLWriter::Appended : mode);
      writer->SetEncodeAppendedData(mode != 3);
      mode == 1 ? writer->SetByteOrderToBigEndian() : writer->SetByteOrderToLittleEndian();
      writer->Write();
      SCOPED_TRACE("compressor " + std::to_string(compressor) + ", mode " + std::to_string(mode));
      ExpectSame(hasp::LoadSurface((this->Folder / "a.vtp").string()), Truth());
    }
}

TEST_F(Vtp, StripsAndPolygonsBecomeTriangles)
{
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(hasp::MakePolyData(Truth()));
  vtkNew<vtkCellArray> strips, polygons, lines;
  strips->InsertNextCell({ 0, 2, 1, 3 });
  polygons->InsertNextCell({ 0, 1, 2, 3 });
  lines->InsertNextCell({ 0, 1 });
  surface->SetStrips(strips);
  surface->SetPolys(polygons);
  surface->SetLines(lines);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName((this->Folder / "a.vtp").c_str());
  writer->Write();
  const auto loaded = hasp::LoadSurface((this->Folder / "a.vtp").string());
  // VTK's own way through a strip: 0 2 1, then 1 2 3, every second one turned.
  hasp::TriangleMesh truth = Truth();
  truth.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 2, 1 }, { 1, 2, 3 } };
  ExpectSame(loaded, truth);
  EXPECT_EQ(loaded.passport.cutPolygons, 1U);
  ASSERT_EQ(loaded.passport.warnings.size(), 3U);
  EXPECT_NE(loaded.passport.warnings[0].find("1 vertices and lines"), std::string::npos);
}

TEST_F(Vtp, DamagedFilesAreRefused)
{
  const auto refused = [&](const std::string& find, const std::string& with)
  { this->ExpectRefused(Form::Vtp, Replaced(Text(), find, with), { "the .vtp file" }); };
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"5\"");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"3\"");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"9223372036854775807\"");
  refused("NumberOfPoints=\"4\"", "NumberOfPoints=\"100000000000\"");
  refused("NumberOfPolys=\"4\"", "NumberOfPolys=\"5\"");
  refused("NumberOfPolys=\"4\"", "NumberOfPolys=\"4000000000\"");
  refused("NumberOfPolys=\"4\"", "NumberOfPolys=\"-1\"");
  refused("3 6 9 12", "3 6 9 1000000000");
  refused("3 6 9 12", "3 900 9 12");
  refused("3 6 9 12", "3 1 9 12");
  refused("0 2 1 0", "0 2 4 0");
  refused("0 2 1 0", "0 2 -1 0");
  refused("</Piece>", "");
}

TEST_F(Vtp, ChildThatMisbehavesIsAnErrorAndLeavesNothing)
{
  hasp::SurfaceReadSettings settings;
  settings.decoderSilenceSeconds = 0.2;
  this->Pretend("exec sleep 60");
  this->ExpectRefused(Form::Vtp, Text(), { "hangs at the .vtp file" }, settings);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
  this->Pretend("kill -SEGV $$");
  this->ExpectRefused(Form::Vtp, Text(), { "crashed at the .vtp file", "Segmentation" });
  this->Pretend("exit 3");
  this->ExpectRefused(Form::Vtp, Text(), { "more memory", "decoderMemoryBytes" });
  this->Pretend("exit 7");
  this->ExpectRefused(Form::Vtp, Text(), { "code 7" });
  this->Pretend("head -c 100000 /dev/urandom");
  this->ExpectRefused(Form::Vtp, Text(), { "no valid answer", "HASP_XML_DECODER" });
  setenv("HASP_XML_DECODER", "/nonexistent", 1);
  this->ExpectRefused(Form::Vtp, Text(), { "HASP_XML_DECODER" });
}

TEST_F(Vtp, EveryFieldOfTheAnswerIsChecked)
{
  this->Answer(Sound(), SoundBytes());
  EXPECT_EQ(this->Read(Form::Vtp, Text()).passport.triangles, 1U);
  const auto refused = [&](const std::string& says, const auto& spoil)
  {
    SCOPED_TRACE(says);
    auto record = Sound();
    spoil(record);
    this->Answer(record, SoundBytes());
    this->ExpectRefused(Form::Vtp, Text(), { says });
  };
  refused("(status)", [](auto& r) { r.status = 99; });
  refused("(status)", [](auto& r) { r.reserved = 1; });
  refused("damaged", [](auto& r) { r.status = 1; });
  refused("(size)", [](auto& r) { r.coordinateBytes = 2; });
  refused("(size)", [](auto& r) { r.points = ~0ULL; });
  refused("(size)", [](auto& r) { r.corners = ~0ULL; });
  refused("are read", [](auto& r) { r.points = 1ULL << 39; });
  refused("memory limit", [](auto& r) { r.points = 1ULL << 30; });
  refused("announced", [](auto& r) { r.corners = 2; });
  refused("gave up", [](auto& r) { r.faces = 2; }); // it ends before they come
  refused("gave up", [](auto& r) { r.points = 4; });
  this->Answer(Sound(), SoundBytes(3));
  this->ExpectRefused(Form::Vtp, Text(), { "face 1: a face names point 4", "has 3" });
  this->Answer(Sound(), SoundBytes(2, 4000000000U));
  this->ExpectRefused(Form::Vtp, Text(), { "announced" });
  this->Answer(Sound(), SoundBytes() + "x");
  this->ExpectRefused(Form::Vtp, Text(), { "more than was asked for" });
}

TEST_F(Vtp, LittleMemoryEndsTheChildAlone)
{
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "AddressSanitizer needs the addresses that the limit takes away";
#endif
  hasp::TriangleMesh large = Truth(); // points and faces take 4.8 MB
  for (unsigned n = 0; n < 100000; ++n)
  {
    large.points.emplace_back(n % 100, n / 100, 3.0);
    large.triangles.emplace_back(0, 1, n);
  }
  const std::string bytes = Bytes(Form::Vtp, large, "");
  hasp::SurfaceReadSettings settings;
  settings.decoderMemoryBytes = 4 << 20;
  this->ExpectRefused(Form::Vtp, bytes, { "needs more memory than the 4 MiB" }, settings);
  settings.decoderMemoryBytes = 64 << 20;
  EXPECT_EQ(this->Read(Form::Vtp, bytes, settings).passport.triangles, 100004U);
  // Points that the file is much too short for.
  const std::string lie = Replaced(Text(), "NumberOfPoints=\"4\"", "NumberOfPoints=\"300000000\"");
  this->ExpectRefused(Form::Vtp, lie, { "needs more memory" }, settings);
}

} // namespace
