#include "SurfaceFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspSurfaceReader.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkTriangleFilter.h"

#include <glm/geometric.hpp>

#include <random>

namespace
{

/// What holds of all formats.
class SurfaceForms : public SurfaceFixture
{
};

bool Mentions(const hasp::SurfacePassport& passport, const std::string& words)
{
  for (const std::string& warning : passport.warnings)
    if (warning.find(words) != warning.npos)
      return true;
  return false;
}

/// Coordinates that need all their digits, in a mesh whose points are in no file's order.
hasp::TriangleMesh Wild(int triangles, bool narrow)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-300.0, 300.0);
  hasp::TriangleMesh mesh;
  for (int n = 0; n < triangles; ++n)
  {
    for (int c = 0; c < 3; ++c)
    {
      const glm::dvec3 p(place(random), place(random) * 1e-3, place(random));
      mesh.points.push_back(narrow ? glm::dvec3(glm::vec3(p)) : p);
    }
    mesh.triangles.emplace_back(3 * n + 2, 3 * n, 3 * n + 1);
  }
  return mesh;
}

TEST_F(SurfaceForms, LeftStaysLeftInLPSAndInRAS)
{
  const hasp::TriangleMesh truth = Truth();
  hasp::TriangleMesh ras = truth; // the same place in the patient, as RAS has it
  for (glm::dvec3& p : ras.points)
    p = { -p.x, -p.y, p.z };
  for (const Form form : Forms)
  {
    SCOPED_TRACE(int(form));
    const auto lps = this->Read(form, Bytes(form, truth, "SPACE=LPS"));
    ExpectSame(lps, truth);
    EXPECT_EQ(lps.passport.space, "LPS");
    EXPECT_TRUE(lps.passport.warnings.empty()) << lps.passport.warnings[0];
    const auto turned = this->Read(form, Bytes(form, ras, "SPACE=RAS"));
    ExpectSame(turned, truth);
    EXPECT_EQ(turned.passport.space, "RAS");
    EXPECT_EQ(turned.passport.minimum, glm::dvec3(5, -7, 11.5));
    EXPECT_EQ(turned.passport.maximum, glm::dvec3(15, 13, 41.625));
    const auto unsaid = this->Read(form, Bytes(form, truth, ""));
    ExpectSame(unsaid, truth);
    EXPECT_EQ(unsaid.passport.space, "");
    EXPECT_TRUE(Mentions(unsaid.passport, "LPS is taken"));
    const auto other = this->Read(form, Bytes(form, truth, "SPACE=LAS"));
    EXPECT_TRUE(Mentions(other.passport, "neither LPS nor RAS"));
    EXPECT_FALSE(Mentions(other.passport, "LAS"));
  }
}

TEST_F(SurfaceForms, PassportHasTheFacts)
{
  for (const Form form : Forms)
  {
    SCOPED_TRACE(int(form));
    const auto loaded = this->Read(form, Bytes(form, Truth(), "SPACE=LPS"));
    const hasp::SurfacePassport& p = loaded.passport;
    EXPECT_EQ(p.points, 4U); // STL's twelve corners are four points
    EXPECT_EQ(p.triangles, 4U);
    EXPECT_EQ(p.degenerate, 0U);
    EXPECT_EQ(p.cutPolygons, 0U);
    EXPECT_EQ(p.coordinateType, "float32");
    EXPECT_EQ(loaded.surface->GetPointData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(loaded.surface->GetFieldData()->GetNumberOfArrays(), 0);
    static const char* const says[] = { "STL text", "STL binary", "PLY text", "PLY binary",
      "PLY binary, big endian", "OBJ text", "VTP XML" };
    EXPECT_EQ(p.format + " " + p.encoding, says[int(form)]);
  }
}

TEST_F(SurfaceForms, FlatTrianglesStayAndAreCounted)
{
  hasp::TriangleMesh mesh = Truth();
  mesh.points.push_back(0.5 * (mesh.points[0] + mesh.points[1]));
  mesh.triangles.emplace_back(0, 4, 1); // in a line
  mesh.triangles.emplace_back(2, 2, 3); // a point twice
  for (const Form form : Forms)
    EXPECT_EQ(this->Read(form, Bytes(form, mesh, "")).passport.degenerate, 2U) << int(form);
}

TEST_F(SurfaceForms, WrongUnitsAreAWarningWithTheNumber)
{
  for (const double scale : { 1e-3, 1e3 })
  {
    hasp::TriangleMesh mesh = Truth();
    for (glm::dvec3& p : mesh.points)
      p *= scale;
    for (const Form form : Forms)
      EXPECT_TRUE(Mentions(this->Read(form, Bytes(form, mesh, "")).passport,
        scale < 1.0 ? "is 0.030125 mm" : "is 30125 mm"))
        << int(form);
  }
}

TEST_F(SurfaceForms, WildCoordinatesAreRefused)
{
  for (const double bad : { std::nan(""), 1.0 / 0.0, -1000001.0 })
  {
    hasp::TriangleMesh mesh = Truth();
    mesh.points[2].y = bad;
    for (const Form form : Forms)
    {
      SCOPED_TRACE(int(form));
      this->ExpectRefused(form, Bytes(form, mesh, ""),
        form == Form::Vtp ? std::vector<std::string>{ ".vtp" }
                          : std::vector<std::string>{ "kilometre" });
    }
  }
  hasp::TriangleMesh mesh = Truth();
  mesh.points[2].y = -1000000.0; // the last that is taken
  for (const Form form : Forms)
    EXPECT_NO_THROW(this->Read(form, Bytes(form, mesh, "")));
}

TEST_F(SurfaceForms, MemoryLimitIsHeldBeforeMemoryIsTaken)
{
  hasp::SurfaceReadSettings settings;
  settings.memoryLimitBytes = 4 * 32 + 4 * 12; // four points and four triangles
  const hasp::TriangleMesh truth = Truth();
  hasp::TriangleMesh more = truth;
  more.triangles.push_back(more.triangles[0]);
  for (const Form form : Forms)
  {
    SCOPED_TRACE(int(form));
    EXPECT_NO_THROW(this->Read(form, Bytes(form, truth, ""), settings));
    this->ExpectRefused(form, Bytes(form, more, ""), { "memory limit" }, settings);
  }
}

TEST_F(SurfaceForms, NothingAndOtherKindsAreRefused)
{
  for (const Form form : Forms)
  {
    SCOPED_TRACE(int(form));
    this->ExpectRefused(form, "", { "the ." });
    this->ExpectRefused(form, std::string(3000, '\0'), { "the ." });
    this->ExpectRefused(form, "Dear colleague,\nMustermann came to us\n", { "the ." });
    for (const Form other : Forms) // a wrong ending
      if (Name(other) != Name(form))
        this->ExpectRefused(form, Bytes(other, Truth(), ""), { "the ." });
  }
  EXPECT_THROW(hasp::LoadSurface(""), std::invalid_argument);
  EXPECT_THROW(hasp::LoadSurface(this->Folder.string()), std::runtime_error);
  EXPECT_THROW(hasp::LoadSurface((this->Folder / "no.stl").string()), std::runtime_error);
  WriteBytes(this->Folder / "a.step", Bytes(Form::Obj, Truth(), ""));
  EXPECT_THROW(hasp::LoadSurface((this->Folder / "a.step").string()), std::runtime_error);
  hasp::SurfaceReadSettings settings;
  settings.decoderSilenceSeconds = 0.0;
  EXPECT_THROW(this->Read(Form::Obj, "", settings), std::invalid_argument);
}

TEST_F(SurfaceForms, WhatIsWrittenReadsBackBitByBit)
{
  for (const char* name : { "a.stl", "a.ply", "a.obj", "A.PLY" })
    for (const bool narrow : { true, false })
    {
      SCOPED_TRACE(name);
      const bool stl = std::string(name) == "a.stl";
      if (stl && !narrow)
        continue; // it holds float32 alone
      const hasp::TriangleMesh mesh = Wild(500, narrow);
      const auto file = (this->Folder / name).string();
      hasp::WriteSurface(hasp::MakePolyData(mesh), file);
      const auto back = hasp::LoadSurface(file);
      ExpectSame(back, mesh);
      EXPECT_EQ(back.passport.space, "LPS");
      EXPECT_EQ(back.passport.coordinateType, narrow ? "float32" : "float64");
      EXPECT_TRUE(back.passport.warnings.empty());
      hasp::WriteSurface(back.surface, file); // and once more, from what was read
      ExpectSame(hasp::LoadSurface(file), mesh);
    }
}

TEST_F(SurfaceForms, VTKReadsTheSame)
{
  const hasp::TriangleMesh mesh = Wild(200, true);
  const auto compare = [&](auto reader, Form form, const std::string& bytes)
  {
    SCOPED_TRACE(int(form));
    const auto ours = this->Read(form, bytes);
    reader->SetFileName((this->Folder / Name(form)).c_str());
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(reader->GetOutputPort());
    triangles->Update();
    ExpectSame(ours, hasp::MakeTriangleMesh(triangles->GetOutput()));
  };
  for (const Form form : { Form::StlText, Form::StlBinary })
    compare(vtkNew<vtkSTLReader>().Get(), form,
      form == Form::StlText
        ? Bytes(form, mesh, "")
        : Replaced(Bytes(form, mesh, ""), "solid", "other")); // VTK takes it for text
  // VTK's readers of PLY and OBJ stop at much that Bytes() puts there.
  for (const auto& [name, form] : { std::pair("a.ply", Form::PlyLittle), { "a.obj", Form::Obj } })
    hasp::WriteSurface(hasp::MakePolyData(mesh), (this->Folder / name).string());
  compare(vtkNew<vtkPLYReader>().Get(), Form::PlyLittle, ReadBytes(this->Folder / "a.ply"));
  compare(vtkNew<vtkOBJReader>().Get(), Form::Obj, ReadBytes(this->Folder / "a.obj"));
}

TEST_F(SurfaceForms, PipelineReaderIsTheSkin)
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback([](vtkObject*, unsigned long, void* n, void*) { ++*static_cast<int*>(n); });
  const auto file = this->Folder / "\xC3\xA9 \xD0\xB6.obj";
  WriteBytes(file, Bytes(Form::Obj, Truth(), ""));
  vtkNew<vtkHaspSurfaceReader> reader;
  reader->AddObserver(vtkCommand::ErrorEvent, count);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, count);
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(errors, 0);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 4);
  EXPECT_EQ(reader->GetPassport().format, "OBJ");
  ASSERT_EQ(reader->GetNumberOfWarnings(), 1);
  EXPECT_NE(reader->GetWarning(0).find("LPS is taken"), std::string::npos);
  EXPECT_EQ(reader->GetWarning(1) + reader->GetWarning(-1), "");
  reader->SetFileName((this->Folder / "no.obj").c_str());
  reader->Update();
  EXPECT_GT(errors, 0);
  EXPECT_NE(reader->GetErrorCode(), 0U);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 0); // nothing of the earlier file stays
}

TEST_F(SurfaceForms, CancelIsHeard)
{
  for (const Form form : Forms)
  {
    WriteBytes(this->Folder / Name(form), Bytes(form, Truth(), ""));
    EXPECT_THROW(
      hasp::LoadSurface((this->Folder / Name(form)).string(), {}, [](double) { return false; }),
      hasp::Cancelled);
  }
}

} // namespace
