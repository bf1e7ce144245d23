#include "SurfaceFixture.h"

#include <cstring>

namespace
{

class Stl : public SurfaceFixture
{
protected:
  static std::string Counted(std::uint32_t count)
  {
    std::string bytes = Bytes(Form::StlBinary, Truth(), "");
    std::memcpy(bytes.data() + 80, &count, sizeof(count));
    return bytes;
  }
  static std::string Text() { return Bytes(Form::StlText, Truth(), ""); }
};

TEST_F(Stl, LyingCountsAreRefused)
{
  for (const std::uint32_t count : { 0U, 3U, 5U, 4000000000U, 4294967295U })
    this->ExpectRefused(
      Form::StlBinary, Counted(count), { std::to_string(count), "the file has 284" });
  EXPECT_NO_THROW(this->Read(Form::StlBinary, Counted(4)));
  this->ExpectRefused(Form::StlBinary, Counted(4) + "more", { "too long" });
}

TEST_F(Stl, BinaryThatBeginsWithSolidIsBinary)
{
  EXPECT_EQ(this->Read(Form::StlBinary, Counted(4)).passport.encoding, "binary");
  const std::string other = Replaced(Counted(4), "solid", "COLOR");
  EXPECT_EQ(this->Read(Form::StlBinary, other).passport.encoding, "binary");
}

TEST_F(Stl, BinaryNormalsAreNotLookedAt)
{
  std::string bytes = Counted(4);
  const float nan = std::nanf("");
  for (int n = 0; n < 4; ++n)
    std::memcpy(bytes.data() + 84 + 50 * n, &nan, sizeof(nan));
  ExpectSame(this->Read(Form::StlBinary, bytes), Truth());
}

TEST_F(Stl, TextMayBeWrittenInManyWays)
{
  std::string capitals = Text();
  for (char& c : capitals)
    c = static_cast<char>(std::toupper(c));
  ExpectSame(this->Read(Form::StlText, capitals), Truth());
  std::string windows;
  for (const char c : Text())
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  ExpectSame(this->Read(Form::StlText, windows), Truth());
  ExpectSame(this->Read(Form::StlText, "\xEF\xBB\xBF" + Text()), Truth());
  ExpectSame(
    this->Read(Form::StlText, "\n \n" + Replaced(Text(), " facet", "\n\t\tfacet")), Truth());
  ExpectSame(
    this->Read(Form::StlText, Replaced(Text(), "vertex 5 -7", "vertex +5.0e0 -.7E1")), Truth());
  ExpectSame(
    this->Read(Form::StlText, Replaced(Text(), "normal 0 0 0", "normal nan nan nan")), Truth());
  EXPECT_EQ(this->Read(Form::StlText, Text() + Text()).passport.triangles, 8U); // two solids
}

TEST_F(Stl, FaultsOfTextAreNamedByLine)
{
  this->ExpectRefused(
    Form::StlText, Replaced(Text(), "5 -7", "5 x"), { "line 4", "number 2 of 3" });
  this->ExpectRefused(Form::StlText, Replaced(Text(), "5 -7", "5"), { "line 4", "number 3 of 3" });
  this->ExpectRefused(Form::StlText, Replaced(Text(), "5 -7", "5 1,5"), { "line 4", "number 2" });
  this->ExpectRefused(
    Form::StlText, Replaced(Text(), "5 -7", "5 1 2"), { "line 4", "more than three" });
  this->ExpectRefused(Form::StlText, Replaced(Text(), "5 -7", "5 0x10"), { "line 4" });
  this->ExpectRefused(
    Form::StlText, Replaced(Text(), "  endloop\n", ""), { "line 7", "vertex or endloop" });
  this->ExpectRefused(
    Form::StlText, Replaced(Text(), "  endloop\n", "vertex 1 2 3\n endloop\n"), { "4 corners" });
  this->ExpectRefused(Form::StlText, Replaced(Text(), " endfacet\n", ""), { "line 8", "endfacet" });
  this->ExpectRefused(
    Form::StlText, Replaced(Text(), "outer loop", "inner loop"), { "line 3", "outer loop" });
  this->ExpectRefused(
    Form::StlText, Replaced(Text(), "endsolid", "Mustermann"), { "facet or endsolid" });
  this->ExpectRefused(Form::StlText, "solid\nendsolid\n", { "no triangles" });
}

TEST_F(Stl, PointsThatDifferByTheSmallestBitStayTwo)
{
  hasp::TriangleMesh mesh = Truth();
  mesh.points.push_back(mesh.points[0]);
  mesh.points[4].x = std::nextafter(5.0F, 6.0F);
  mesh.triangles[1].x = 4;
  EXPECT_EQ(this->Read(Form::StlBinary, Bytes(Form::StlBinary, mesh, "")).passport.points, 5U);
  hasp::TriangleMesh zero = Truth(); // 0 and -0 are one place
  zero.points = { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 20, 0 }, { 0, 0, 30 }, { -0.0, 0, -0.0 } };
  zero.triangles[1].x = 4;
  EXPECT_EQ(this->Read(Form::StlBinary, Bytes(Form::StlBinary, zero, "")).passport.points, 4U);
}

TEST_F(Stl, TwoSystemsInOneFileAreRefused)
{
  const std::string two =
    Bytes(Form::StlText, Truth(), "SPACE=LPS") + Bytes(Form::StlText, Truth(), "SPACE=RAS");
  this->ExpectRefused(Form::StlText, two, { "LPS and", "RAS" });
}

} // namespace
