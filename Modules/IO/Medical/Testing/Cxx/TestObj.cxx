#include "SurfaceFixture.h"

#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <locale>

namespace
{

class Obj : public SurfaceFixture
{
protected:
  static inline const std::string Points = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\n";
  std::size_t Triangles(const std::string& text) const
  {
    return this->Read(Form::Obj, text).passport.triangles;
  }
};

TEST_F(Obj, FacesMayBeWrittenInManyWays)
{
  EXPECT_EQ(this->Triangles(Points + "f 1 2 3\n"), 1U);
  EXPECT_EQ(this->Triangles(Points + "f 1/7 2/8 3/9\n"), 1U);
  EXPECT_EQ(this->Triangles(Points + "f 1//7 2/8/9 3/9/-1 4\n"), 2U);
  EXPECT_EQ(this->Triangles(Points + "f -4 -3 -2 -1\nf -1 -2 -3 # last\n"), 3U);
  EXPECT_EQ(this->Triangles(Points + "f 1 2 \\\n 3 \\\n4\n"), 2U);
  EXPECT_EQ(this->Triangles("f 1 2 3\n" + Points), 1U); // points may come later
  EXPECT_EQ(this->Triangles(Points + "f\t1  2\t3\r\n\r\n"), 1U);
  EXPECT_EQ(this->Triangles("\xEF\xBB\xBF" + Points + "f 1 2 3\n"), 1U);
  EXPECT_EQ(this->Triangles("v 0 0 0 1\nv 9 0 0 0.5 0.5 0.5\nv 0 9 0\nf 1 2 3"), 1U);
  EXPECT_EQ(this->Triangles("# CONTROLPOINTS=7 colorspace=x\n" + Points + "f 1 2 3\n"), 1U);
  const auto turned = this->Read(Form::Obj, Points + "f 3 1 2\n");
  EXPECT_EQ(turned.passport.points, 4U);
}

TEST_F(Obj, FaultsAreNamedByLine)
{
  const auto refused = [&](const std::string& text, const std::string& says)
  { this->ExpectRefused(Form::Obj, Points + text, { says }); };
  for (const char* face : { "f 1 2 5", "f 1 2 0", "f 1 2 -5", "f 1 2 x", "f 1 2 3/x",
         "f 1 2 3/1/2/3", "f 1 2 3.5", "f 1 2 4294967297", "f 1 2 9223372036854775807",
         "f 1 2 -9223372036854775808", "f 1 2 99999999999999999999", "f 1 2", "f", "f 1 2 3/0" })
    refused(std::string(face) + "\n", "line 5: ");
  refused("f 1 2 3\nv 1 2\n", "line 6: number 3 of 3");
  refused("f 1 2 3\nv 1 2 3,5\n", "line 6: number 3 of 3");
  refused("f 1 2 \\\n3 \\\nx\nf 1 2 3\n", "line 5: ");
  refused("f 1 2 3 \\\n4\nf 1 2 9\n", "line 7: ");
  refused("cstype bezier\n", "line 5: begins with no word");
  refused("Mustermann 1\n", "line 5: begins with no word");
  refused("", "no triangles");
}

TEST_F(Obj, ALineWithoutAnEndIsBounded)
{
  this->ExpectRefused(Form::Obj, std::string(100 << 20, '1'), { "line 1 has more than 1048576" });
  std::string continued;
  for (int n = 0; n < 1 << 20; ++n)
    continued += "# \\\n";
  this->ExpectRefused(Form::Obj, continued, { "goes on for more" });
}

TEST_F(Obj, ALineWithoutAnEndAtTheEndIsAWarning)
{
  const auto cut = this->Read(Form::Obj, Points + "f 1 2 3");
  ASSERT_EQ(cut.passport.warnings.size(), 2U);
  EXPECT_NE(cut.passport.warnings[0].find("may be cut off"), std::string::npos);
}

/// A decimal comma, as German has it; no such locale need be installed.
struct Comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_F(Obj, DecimalsDoNotDependOnTheLocale)
{
  const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
  const hasp::TriangleMesh mesh{ { { 0, 0, 0 }, { 1000.5, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  EXPECT_EQ(this->Read(Form::Obj, Bytes(Form::Obj, mesh, "")).passport.maximum.x, 1000.5);
  for (const char* name : { "a.obj", "a.ply" })
  {
    const auto file = (this->Folder / name).string();
    hasp::WriteSurface(hasp::MakePolyData(mesh), file);
    EXPECT_EQ(hasp::LoadSurface(file).passport.maximum.x, 1000.5) << name;
  }
  std::locale::global(before);
}

} // namespace
