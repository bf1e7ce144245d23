#include "SurfaceFixture.h"
#include "ZipFile.h"

#include "XML/XMLWire.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>

namespace
{

class ThreeMf : public SurfaceFixture
{
protected:
  ~ThreeMf() override { unsetenv("HASP_3MF_DECODER"); }

  std::string File() const { return (this->Folder / "a.3mf").string(); }
  hasp::LoadedSurface ReadThis(
    const std::string& bytes, const hasp::SurfaceReadSettings& settings = {}) const
  {
    WriteBytes(this->File(), bytes);
    return hasp::LoadSurface(this->File(), settings);
  }
  void ExpectRefusal(const std::string& bytes, const std::string& says,
    const hasp::SurfaceReadSettings& settings = {}) const
  {
    try
    {
      this->ReadThis(bytes, settings);
      ADD_FAILURE() << "was read";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find(this->Folder.string()), std::string::npos);
      EXPECT_EQ(std::string(error.what()).find("Mustermann"), std::string::npos);
    }
  }

  /// A file as another program writes it: what stands in <model>.
  static std::string Model(const std::string& inner, const std::string& unit = "millimeter")
  {
    const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    return ZipFile({
      { "[Content_Types].xml",
        xml + "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
              "<Default Extension=\"rels\" "
              "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
              "<Default Extension=\"model\" "
              "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>" },
      { "_rels/.rels", xml +
                         "<Relationships "
                         "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                         "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                         "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
                         "</Relationships>" },
      { "3D/3dmodel.model",
        xml + "<model unit=\"" + unit +
          "\" xml:lang=\"en-US\" "
          "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">" +
          inner + "</model>" },
    });
  }
  /// The tetrahedron (0,0,0), (10,0,0), (0,20,0), (0,0,30) as object `id`.
  static std::string Tetrahedron(int id, const std::string& name = "")
  {
    return "<object id=\"" + std::to_string(id) + "\" type=\"model\"" +
           (name.empty() ? "" : " name=\"" + name + "\"") +
           "><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"10\" y=\"0\" z=\"0\"/>"
           "<vertex x=\"0\" y=\"20\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"30\"/></vertices>"
           "<triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
           "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/>"
           "</triangles></mesh></object>";
  }
  static std::string Components(int id, const std::string& components)
  {
    return "<object id=\"" + std::to_string(id) + "\" type=\"model\"><components>" + components +
           "</components></object>";
  }
  static std::string Resources(const std::string& objects, const std::string& items)
  {
    return "<resources>" + objects + "</resources><build>" + items + "</build>";
  }
  /// Six times the volume, > 0 if triangles are counter-clockwise seen from outside.
  static double SixVolumes(const hasp::TriangleMesh& mesh)
  {
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
      sum += glm::dot(mesh.points[t.x], glm::cross(mesh.points[t.y], mesh.points[t.z]));
    return sum;
  }
  static hasp::TriangleMesh Moved(hasp::TriangleMesh mesh, const glm::dvec3& by)
  {
    for (glm::dvec3& point : mesh.points)
      point += by;
    return mesh;
  }
};

TEST_F(ThreeMf, NamedObjectsComeBackInTheirOrderAndPlaces)
{
  const auto first = hasp::MakePolyData(Truth());
  const auto second = hasp::MakePolyData(Moved(Truth(), { 100, -50, 25 }));
  hasp::WriteSurfaces(
    { { "fragment 1", first }, { "fragment 2", second } }, this->File(), { "reduction", "" });
  const auto loaded = hasp::LoadSurface(this->File());
  EXPECT_EQ(loaded.passport.format, "3MF");
  EXPECT_EQ(loaded.passport.encoding, "zip");
  EXPECT_EQ(loaded.passport.space, "LPS");
  EXPECT_EQ(loaded.passport.label.name, "reduction");
  EXPECT_TRUE(loaded.passport.warnings.empty());
  ASSERT_EQ(loaded.passport.pieces.size(), 2U);
  EXPECT_EQ(loaded.passport.pieces[0].name, "fragment 1");
  EXPECT_EQ(loaded.passport.pieces[1].name, "fragment 2");
  EXPECT_EQ(loaded.passport.pieces[1].firstTriangle, 4U);
  EXPECT_EQ(loaded.passport.pieces[1].triangles, 4U);
  hasp::TriangleMesh both = Truth();
  const hasp::TriangleMesh more = Moved(Truth(), { 100, -50, 25 });
  for (const glm::uvec3& t : more.triangles)
    both.triangles.push_back(t + glm::uvec3(glm::uint(both.points.size())));
  both.points.insert(both.points.end(), more.points.begin(), more.points.end());
  ExpectSame(loaded, both); // whole numbers and eighths are exact
}

TEST_F(ThreeMf, CoordinatesKeepWhatTheHeaderSays)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-3.0, 3.0), sign(-1.0, 1.0);
  double largest = 0.0;
  for (int trial = 0; trial < 20; ++trial)
  {
    hasp::TriangleMesh mesh = Truth();
    std::vector<hasp::TriangleMesh> all;
    std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
    std::vector<hasp::NamedSurface> named;
    for (int n = 0; n < 100; ++n)
    {
      for (glm::dvec3& p : mesh.points)
        for (int a = 0; a < 3; ++a)
          p[a] = float(std::copysign(std::pow(10.0, exponent(random)), sign(random)));
      all.push_back(mesh);
      surfaces.push_back(hasp::MakePolyData(mesh));
      named.push_back({ "part " + std::to_string(n), surfaces.back() });
    }
    hasp::WriteSurfaces(named, this->File());
    const hasp::TriangleMesh back = hasp::MakeTriangleMesh(hasp::LoadSurface(this->File()).surface);
    for (std::size_t n = 0; n < back.points.size(); ++n)
      for (int a = 0; a < 3; ++a)
      {
        const double was = all[n / 4].points[n % 4][a], error = std::abs(back.points[n][a] - was);
        ASSERT_LE(error, 2e-7 * std::abs(was) + 1e-6) << was;
        largest = std::max(largest, error / (2e-7 * std::abs(was) + 1e-6));
      }
  }
  std::printf("largest error of a coordinate: %.3f of what the header allows\n", largest);
}

TEST_F(ThreeMf, NothingInTheFileIsOfItsTime)
{
  hasp::WriteSurface(hasp::MakePolyData(Truth()), this->File(), { "guide", "" });
  const std::string bytes = ReadBytes(this->File());
  int heads = 0;
  for (std::size_t at = bytes.find("PK\3\4"); at != bytes.npos; at = bytes.find("PK\3\4", at + 1))
  {
    ++heads;
    EXPECT_EQ(bytes.substr(at + 10, 4), std::string(4, '\0')) << "time and date of an entry";
  }
  EXPECT_EQ(heads, 3);
}

TEST_F(ThreeMf, WhatIsNoClosedBodyIsRefusedByName)
{
  hasp::TriangleMesh open = Truth();
  open.triangles.pop_back();
  hasp::TriangleMesh turned = Truth();
  std::swap(turned.triangles[0].x, turned.triangles[0].y);
  hasp::TriangleMesh twice = Truth();
  twice.triangles[0].x = twice.triangles[0].y;
  for (const hasp::TriangleMesh& mesh : { open, turned, twice })
  {
    EXPECT_THROW(hasp::WriteSurface(hasp::MakePolyData(mesh), this->File()), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(this->File()));
  }
  EXPECT_THROW(hasp::WriteSurfaces({}, this->File()), std::invalid_argument);
  EXPECT_THROW(hasp::WriteSurfaces({ { "Mustermann", hasp::MakePolyData(Truth()) } }, this->File()),
    std::invalid_argument);
  const std::string stl = (this->Folder / "a.stl").string();
  EXPECT_THROW(
    hasp::WriteSurfaces({ { "part", hasp::MakePolyData(Truth()) } }, stl), std::runtime_error);
}

TEST_F(ThreeMf, UnitsAreScaledWithAWarning)
{
  const std::pair<const char*, double> units[] = { { "micron", 1e-3 }, { "millimeter", 1.0 },
    { "centimeter", 10.0 }, { "inch", 25.4 }, { "foot", 304.8 }, { "meter", 1000.0 } };
  for (const auto& [unit, mm] : units)
  {
    SCOPED_TRACE(unit);
    const auto loaded =
      this->ReadThis(Model(Resources(Tetrahedron(1), "<item objectid=\"1\"/>"), unit));
    EXPECT_DOUBLE_EQ(loaded.passport.maximum.z, 30.0 * mm);
    int said = 0;
    for (const std::string& warning : loaded.passport.warnings)
      said += warning.find("scaled to mm") != warning.npos;
    EXPECT_EQ(said, mm == 1.0 ? 0 : 1);
  }
}

TEST_F(ThreeMf, TransformsAndComponentsPutObjectsWhereTheyAreBuilt)
{
  // By rows of (x y z 1): x' = 5 - y, y' = 6 + x, z' = 7 + z; and in it, 100 along x, mirrored in
  // z.
  const auto loaded = this->ReadThis(Model(
    Resources(Tetrahedron(1, "Mustermann") +
                Components(2, "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 -1 100 0 0\"/>"
                              "<component objectid=\"1\"/>"),
      "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 5 6 7\"/><item objectid=\"1\"/>")));
  ASSERT_EQ(loaded.passport.pieces.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n)
    EXPECT_EQ(loaded.passport.pieces[n].name, "object " + std::to_string(n + 1));
  const hasp::TriangleMesh mesh = hasp::MakeTriangleMesh(loaded.surface);
  ASSERT_EQ(mesh.points.size(), 12U);
  EXPECT_EQ(mesh.points[0], glm::dvec3(5, 106, 7));
  EXPECT_EQ(mesh.points[2], glm::dvec3(-15, 106, 7));
  EXPECT_EQ(mesh.points[3], glm::dvec3(5, 106, -23));
  EXPECT_EQ(mesh.points[4], glm::dvec3(5, 6, 7));
  EXPECT_EQ(mesh.points[5], glm::dvec3(5, 16, 7));
  EXPECT_EQ(mesh.points[7], glm::dvec3(5, 6, 37));
  EXPECT_EQ(mesh.points[9], glm::dvec3(10, 0, 0));
  EXPECT_DOUBLE_EQ(SixVolumes(mesh), 3 * 6000.0); // the mirrored one faces outward, too
}

TEST_F(ThreeMf, WhatIsNotBuiltIsLeftOut)
{
  const auto loaded =
    this->ReadThis(Model(Resources(Tetrahedron(1) + Tetrahedron(2), "<item objectid=\"2\"/>")));
  EXPECT_EQ(loaded.passport.triangles, 4U);
  this->ExpectRefusal(Model(Resources(Tetrahedron(1), "")), "no triangles");
}

TEST_F(ThreeMf, ComponentsThatMultiplyAreRefused)
{
  std::string objects = Tetrahedron(1);
  for (int n = 2; n < 32; ++n)
  {
    const std::string inner = "<component objectid=\"" + std::to_string(n - 1) + "\"/>";
    objects += Components(n, inner + inner);
  }
  this->ExpectRefusal(Model(Resources(objects, "<item objectid=\"19\"/>")), "100000 objects");
  // Beyond that lib3mf itself goes through all of them.
  this->ExpectRefusal(Model(Resources(objects, "<item objectid=\"31\"/>")), "hangs");
  objects = Tetrahedron(1);
  for (int n = 2; n < 100; ++n)
    objects += Components(n, "<component objectid=\"" + std::to_string(n - 1) + "\"/>");
  this->ExpectRefusal(Model(Resources(objects, "<item objectid=\"99\"/>")), "64 deep");
}

TEST_F(ThreeMf, MemoryIsHeldToItsLimits)
{
  const std::string sound = Model(Resources(Tetrahedron(1), "<item objectid=\"1\"/>"));
  EXPECT_NO_THROW(this->ReadThis(sound));
  hasp::SurfaceReadSettings settings;
  settings.memoryLimitBytes = 100;
  this->ExpectRefusal(sound, "memory limit", settings);
  settings = {};
  settings.decoderMemoryBytes = std::size_t(64) << 20;
  const std::string blanks(std::size_t(200) << 20, ' ');
  this->ExpectRefusal(Model(blanks + Resources(Tetrahedron(1), "<item objectid=\"1\"/>")),
    "decoderMemoryBytes", settings);
}

TEST_F(ThreeMf, DamageIsRefused)
{
  this->ExpectRefusal("", "damaged");
  this->ExpectRefusal("Mustermann", "damaged");
  this->ExpectRefusal(ZipFile({ { "a", "b" } }), "damaged");
  this->ExpectRefusal(Model("<Mustermann>"), "damaged");
  const std::string beyond =
    "<object id=\"1\" type=\"model\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/></vertices>"
    "<triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object>";
  this->ExpectRefusal(Model(Resources(beyond, "<item objectid=\"1\"/>")), "");
}

TEST_F(ThreeMf, CutAnywhereIsRefused)
{
  hasp::WriteSurface(hasp::MakePolyData(Truth()), this->File(), { "guide", "" });
  const std::string whole = ReadBytes(this->File());
  for (std::size_t size = 0; size < whole.size(); size += 31) // each takes a process
    this->ExpectRefusal(whole.substr(0, size), "");
}

TEST_F(ThreeMf, FlippedBytesDoNoHarm)
{
  hasp::WriteSurface(hasp::MakePolyData(Truth()), this->File(), { "guide", "" });
  const std::string ours = ReadBytes(this->File());
  const std::string stored = Model(Resources(Tetrahedron(1), "<item objectid=\"1\"/>"));
  const char* asked = std::getenv("HASP_MUTATIONS");
  std::mt19937 random(3);
  int read = 0;
  const int files = asked ? std::atoi(asked) : 120;
  for (int n = 0; n < files; ++n)
  {
    std::string bytes = n % 2 ? ours : stored;
    bytes[random() % bytes.size()] ^= char(1 << random() % 8);
    try
    {
      const auto loaded = this->ReadThis(bytes);
      for (const glm::dvec3& p : hasp::MakeTriangleMesh(loaded.surface).points)
        ASSERT_LE(std::abs(p.x), 1e6);
      ++read;
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(std::string(error.what()).find("crashed"), std::string::npos) << error.what();
    }
  }
  std::printf("%d of %d files with a flipped bit were read, the others refused\n", read, files);
}

/// Programs in the decoder's place.
class ThreeMfPretender : public ThreeMf
{
protected:
  void Answer(const hasp::ThreeMfRecord& record, const std::string& more) const
  {
    std::string bytes;
    const hasp::XMLFrame answer{ hasp::XMLFrame::Magic, hasp::XMLFrame::Answer, 1.0 };
    AppendBytes(bytes, &answer, 1);
    AppendBytes(bytes, &record, 1);
    WriteBytes(this->Folder / "answer", bytes + more);
    const auto file = this->Folder / "decoder";
    WriteBytes(file, "#!/bin/sh\nexec cat '" + (this->Folder / "answer").string() + "'\n");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("HASP_3MF_DECODER", file.c_str(), 1);
  }
  static hasp::ThreeMfRecord Sound()
  {
    hasp::ThreeMfRecord record{};
    record.unit = 1;
    record.objects = 1;
    record.points = 3;
    record.triangles = 1;
    return record;
  }
  static std::string Object(std::uint64_t points, std::uint32_t lastCorner, const char* name)
  {
    hasp::ThreeMfObject object{};
    object.points = points;
    object.triangles = 1;
    std::strncpy(object.name, name, sizeof object.name - 1);
    const double places[9] = { 0, 0, 0, 10, 0, 0, 0, 10, 0 };
    const std::uint32_t corners[3] = { 0, 1, lastCorner };
    std::string bytes;
    AppendBytes(bytes, &object, 1);
    AppendBytes(bytes, places, 9);
    AppendBytes(bytes, corners, 3);
    return bytes;
  }
};

TEST_F(ThreeMfPretender, AnswersAreHeldToWhatTheyMayBe)
{
  this->Answer(Sound(), Object(3, 2, "guide"));
  const auto loaded = this->ReadThis("x");
  EXPECT_EQ(loaded.passport.triangles, 1U);
  EXPECT_EQ(loaded.passport.pieces.at(0).name, "guide");
  this->Answer(Sound(), Object(3, 3, "guide"));
  this->ExpectRefusal("x", "a corner that is no point");
  this->Answer(Sound(), Object(4, 2, "guide"));
  this->ExpectRefusal("x", "more points or triangles");
  this->Answer(Sound(), Object(3, 2, "guide") + "more");
  this->ExpectRefusal("x", "");
  this->Answer(Sound(), "");
  this->ExpectRefusal("x", "");
  hasp::ThreeMfRecord record = Sound();
  record.unit = 6;
  this->Answer(record, Object(3, 2, "guide"));
  this->ExpectRefusal("x", "size");
  record = Sound();
  record.points = std::uint64_t(1) << 39;
  this->Answer(record, Object(3, 2, "guide"));
  this->ExpectRefusal("x", "at most");
  record = Sound();
  record.objects = 100'001; // of which none has a point
  hasp::ThreeMfObject none{};
  std::string many = Object(3, 2, "guide");
  for (std::uint32_t n = 1; n < record.objects; ++n)
    AppendBytes(many, &none, 1);
  this->Answer(record, many);
  this->ExpectRefusal("x", "size");
  record = Sound();
  record.status = 99;
  this->Answer(record, "");
  this->ExpectRefusal("x", "status");
}

} // namespace
