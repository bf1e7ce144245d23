#include "SurfaceFixture.h"

namespace
{

class Ply : public SurfaceFixture
{
protected:
  /// As small as it can be, with a quadrilateral.
  static std::string Square(const std::string& corner2 = "10 10 0")
  {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
           "property double z\nelement face 1\nproperty list uchar uint vertex_index\nend_header\n"
           "0 0 0\n10 0 0\n" +
           corner2 + "\n0 10 0\n4 0 1 2 3\n";
  }
  static std::string Text() { return Bytes(Form::PlyText, Truth(), ""); }
};

TEST_F(Ply, PolygonsAreCutAndUnevenOnesSaid)
{
  const auto even = this->Read(Form::PlyText, Square());
  EXPECT_EQ(even.passport.triangles, 2U);
  EXPECT_EQ(even.passport.cutPolygons, 1U);
  EXPECT_EQ(even.passport.warnings.size(), 1U);     // LPS is taken
  for (const char* corner : { "10 10 4", "2 2 0" }) // bent; with a corner that turns inward
  {
    const auto uneven = this->Read(Form::PlyText, Square(corner));
    EXPECT_EQ(uneven.passport.triangles, 2U);
    ASSERT_EQ(uneven.passport.warnings.size(), 2U) << corner;
    EXPECT_NE(uneven.passport.warnings[1].find("1 of 1 faces"), std::string::npos);
  }
}

TEST_F(Ply, LyingCountsAreRefused)
{
  for (const Form form : { Form::PlyText, Form::PlyLittle, Form::PlyBig })
    for (const char* count : { "18446744073709551616", "18446744073709551615",
           "9223372036854775807", "4294967296", "1000000", "-1", "x", "" })
      for (const char* what : { "vertex 4", "face 4", "camera 1" })
      {
        SCOPED_TRACE(std::string(what) + " as " + count);
        const std::string name(what, std::string(what).find(' ') + 1);
        this->ExpectRefused(
          form, Replaced(Bytes(form, Truth(), ""), what, name + count), { "the .ply file: " });
      }
  // Elements without properties take no bytes, and no time.
  for (const Form form : { Form::PlyText, Form::PlyLittle })
    ExpectSame(this->Read(form,
                 Replaced(Bytes(form, Truth(), ""), "nothing 5", "nothing 9223372036854775807")),
      Truth());
  this->ExpectRefused(Form::PlyText, Replaced(Text(), "vertex 4", "vertex 5"), { "line " });
  this->ExpectRefused(Form::PlyText, Replaced(Text(), "face 4", "face 3"), { "too long" });
  this->ExpectRefused(Form::PlyLittle,
    Replaced(Bytes(Form::PlyLittle, Truth(), ""), "face 4", "face 3"), { "too long" });
}

TEST_F(Ply, LyingListsAreRefused)
{
  const auto row = [&](const std::string& face) { return Replaced(Square(), "4 0 1 2 3", face); };
  for (const char* face :
    { "5 0 1 2 3", "3 0 1 2 3", "-1 0 1 2 3", "1e300 0 1 2 3", "nan 0", "4 0 1 2 -1", "4 0 1 2 4",
      "4 0 1 2 4294967296", "4 0 1 2 1.5", "2 0 1", "0", "1 0", "4 0 1 2 x", "4" })
    this->ExpectRefused(Form::PlyText, row(face), { "line 14: " });
  std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
                       "property float y\nproperty float z\nelement face 1\n"
                       "property list uint uint vertex_index\nend_header\n";
  binary.append(12, '\0').append(4, '\xFF').append(100, '\0');
  this->ExpectRefused(Form::PlyLittle, binary, { "byte ", "4.29497e+09", "too short" });
}

TEST_F(Ply, FaultsOfTheHeaderAreNamed)
{
  const auto refused = [&](
                         const std::string& find, const std::string& with, const std::string& says)
  { this->ExpectRefused(Form::PlyText, Replaced(Square(), find, with), { says }); };
  refused("ply\n", "plyx\n", "does not begin");
  refused("format ascii 1.0\n", "", "no format");
  refused("ascii", "binary_middle_endian", "line 2");
  refused("1.0", "2.0", "line 2");
  refused("format ascii 1.0\n", "format ascii 1.0\nformat ascii 1.0\n", "line 3");
  refused("element vertex 4", "comment", "line 4: a property stands before");
  refused("property double z\n", "", "no x, y or z");
  refused("double z", "double y", "declared twice");
  refused("double z", "triple z", "none of PLY's types");
  refused("uchar uint", "float uint", "must be an integer");
  refused("vertex_index", "corners", "no vertex_indices");
  refused("element face 1", "element tristrips 1", "one vertex and one face");
  refused(
    "element face 1", "element vertex 1\nproperty int a\nelement face 1", "one vertex and one");
  refused("end_header\n", "", "no word of a PLY header");
  refused("element face", "Mustermann face", "line 7");
  std::string many = "ply\nformat ascii 1.0\n";
  for (int n = 0; n < 5000; ++n)
    many += "comment\n";
  this->ExpectRefused(Form::PlyText, many, { "no end_header" });
}

TEST_F(Ply, MayBeWrittenInManyWays)
{
  std::string windows;
  for (const char c : Text())
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  ExpectSame(this->Read(Form::PlyText, windows), Truth());
  ExpectSame(this->Read(Form::PlyText, "\xEF\xBB\xBF" + Text() + "\n \n"), Truth());
  ExpectSame(this->Read(Form::PlyLittle,
               Replaced(Bytes(Form::PlyLittle, Truth(), ""), "float x", "float32 x")),
    Truth());
  // Faces may come before points.
  EXPECT_EQ(this
              ->Read(Form::PlyText,
                "ply\nformat ascii 1.0\nelement face 1\nproperty list int8 int16 vertex_indices\n"
                "element vertex 3\nproperty int z\nproperty float y\nproperty short x\nend_header\n"
                "3 2 0 1\n30 0 0\n0 0 10\n0 20 0\n")
              .passport.maximum,
    glm::dvec3(10, 20, 30));
}

TEST_F(Ply, DoublesStayDoubles)
{
  const auto loaded = this->Read(Form::PlyText, Square("10 10.000000000000002 0"));
  EXPECT_EQ(loaded.passport.coordinateType, "float64");
  EXPECT_EQ(loaded.passport.maximum.y, 10.000000000000002);
  // What is declared as float is one, however many digits it has.
  const auto single = this->Read(Form::PlyText, Replaced(Text(), "5 -7 255", "5.1 -7 255"));
  EXPECT_EQ(single.passport.coordinateType, "float32");
}

} // namespace
