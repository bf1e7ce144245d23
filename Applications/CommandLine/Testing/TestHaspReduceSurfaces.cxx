// Surfaces that broke, put together again: closed ones, and open ones as sheets.
#include "HaspProcess.h"

#include "Grid/RigidPose.h"
#include "Grid/TriangleMesh.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace
{

using glm::dvec3;
using hasp::TriangleMesh;
using nlohmann::json;

/// The face that the block broke along, mm over z = 0.
double Height(double x, double y)
{
  return 1.5 *
         (std::sin(0.55 * x + 0.3) * std::cos(0.43 * y) + 0.5 * std::sin(0.83 * y - 0.71 * x));
}

/// What lies between two heights over 30 x 22 mm, closed, points 0.5 mm apart.
TriangleMesh Slab(const std::function<double(double, double)>& low,
  const std::function<double(double, double)>& high)
{
  constexpr unsigned across = 61, along = 45;
  TriangleMesh mesh;
  for (const auto& height : { low, high })
    for (unsigned j = 0; j < along; ++j)
      for (unsigned i = 0; i < across; ++i)
      {
        const double x = 0.5 * i - 15.0, y = 0.5 * j - 11.0;
        mesh.points.push_back({ x, y, height(x, y) });
      }
  const auto quad = [&](unsigned a, unsigned b, unsigned c, unsigned d)
  {
    mesh.triangles.push_back({ a, b, c });
    mesh.triangles.push_back({ a, c, d });
  };
  constexpr unsigned top = across * along;
  const auto at = [](unsigned i, unsigned j) { return j * across + i; };
  for (unsigned j = 0; j + 1 < along; ++j)
    for (unsigned i = 0; i + 1 < across; ++i)
    {
      const unsigned a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      quad(top + a, top + b, top + c, top + d);
      quad(a, d, c, b);
    }
  const auto wall = [&](unsigned a, unsigned b) { quad(a, b, top + b, top + a); };
  for (unsigned i = 0; i + 1 < across; ++i)
  {
    wall(at(i, 0), at(i + 1, 0));
    wall(at(i + 1, along - 1), at(i, along - 1));
  }
  for (unsigned j = 0; j + 1 < along; ++j)
  {
    wall(at(across - 1, j), at(across - 1, j + 1));
    wall(at(0, j + 1), at(0, j));
  }
  return mesh;
}

/// The outer face of a pot's wall, 80 mm across and 60 mm high, from one angle to another: a crack
/// at `from` or `to` runs up along waves. Open; it looks outwards.
TriangleMesh Sherd(bool right)
{
  constexpr unsigned around = 60, up = 120;
  constexpr double radius = 40.0;
  const auto crack = [](double z)
  { return (3.0 * std::sin(0.3 * z + 0.4) + 0.8 * std::sin(0.7 * z)) / radius; };
  TriangleMesh mesh;
  for (unsigned j = 0; j <= up; ++j)
    for (unsigned i = 0; i <= around; ++i)
    {
      const double z = 60.0 * j / up - 30.0, share = double(i) / around;
      const double from = right ? crack(z) : -0.7, to = right ? 0.7 : crack(z);
      const double angle = from + share * (to - from);
      mesh.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), z });
    }
  for (unsigned j = 0; j < up; ++j)
    for (unsigned i = 0; i < around; ++i)
    {
      const unsigned a = j * (around + 1) + i, d = a + around + 1;
      mesh.triangles.push_back({ a, a + 1, d + 1 });
      mesh.triangles.push_back({ a, d + 1, d });
    }
  return mesh;
}

/// Two pieces, fragments 2 and 4 of surfaces 1 and 3. The second was scanned `Apart` from its
/// place.
class HaspReduceSurfaces : public HaspTest
{
protected:
  const dvec3 Apart{ 40.0, -5.0, 25.0 };

  void WritePly(
    const std::string& name, const TriangleMesh& mesh, const dvec3& shift = dvec3(0.0)) const
  {
    char line[120];
    std::string text = "ply\nformat ascii 1.0\ncomment SPACE=LPS\nelement vertex " +
                       std::to_string(mesh.points.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                       std::to_string(mesh.triangles.size()) +
                       "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const dvec3& point : mesh.points)
    {
      const dvec3 p = point + shift;
      std::snprintf(line, sizeof line, "%.9g %.9g %.9g\n", p.x, p.y, p.z);
      text += line;
    }
    for (const glm::uvec3& t : mesh.triangles)
    {
      std::snprintf(line, sizeof line, "3 %u %u %u\n", t.x, t.y, t.z);
      text += line;
    }
    this->WriteText(name, text);
  }
  void WriteBlock() const
  {
    this->WritePly("a.ply", Slab([](double, double) { return -15.0; }, Height));
    this->WritePly("b.ply", Slab(Height, [](double, double) { return 15.0; }), this->Apart);
  }
  HaspRun OfPlan(const std::vector<std::string>& more) const
  {
    std::vector<std::string> words{ "plan", this->Path("case.hasp"), "--quiet" };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  /// Both entered, and the second one brought back by hand: 2.7 mm and 4 degrees off.
  void MakePlan(const std::vector<std::string>& more = {}) const
  {
    ASSERT_EQ(this->OfPlan({ "--new" }).exitCode, 0);
    std::vector<std::string> words{ "--surface", this->Path("a.ply"), "--surface",
      this->Path("b.ply") };
    words.insert(words.end(), more.begin(), more.end());
    const HaspRun entered = this->OfPlan(words);
    ASSERT_EQ(entered.exitCode, 0) << entered.err;
    const HaspRun moved = this->OfPlan(
      { "--move", "4", "--shift", "-38,6,-23.5", "--turn", "3,-2,2", "--about", "40,-5,32" });
    ASSERT_EQ(moved.exitCode, 0) << moved.err;
  }
  HaspRun Reduce(
    const std::vector<std::string>& surfaces, const std::vector<std::string>& more) const
  {
    std::vector<std::string> words{ "reduce", this->Path("case.hasp"), "--quiet", "--reference",
      "2", "--start-mm", "4", "--start-degrees", "6", "--starts", "8" };
    for (const std::string& name : surfaces)
      words.insert(words.end(), { "--surface", this->Path(name) });
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  json Plan() const { return json::parse(ReadBytes(this->Path("case.hasp/plan.json"))).at("plan"); }
  /// How far the plan's pose puts places of the second piece from where they belong, mm at most.
  double Off(const TriangleMesh& piece) const
  {
    const json pose = this->Plan().at("fragments")[1].at("scanToPlanned");
    const json &p = pose.at("position"), &q = pose.at("orientation");
    const hasp::RigidPose there{ { p[0], p[1], p[2] }, { q[0], q[1], q[2], q[3] } };
    double most = 0.0;
    for (const dvec3& x : piece.points)
      most = std::max(most, glm::length(there.Place(x + this->Apart) - x));
    return most;
  }
};

TEST_F(HaspReduceSurfaces, ABrokenBlockIsWholeAgain)
{
  this->WriteBlock();
  this->MakePlan();
  const TriangleMesh upper = Slab(Height, [](double, double) { return 15.0; });
  const json before = this->Plan();
  EXPECT_GT(this->Off(upper), 2.5);
  // One surface in any format, and in any order.
  ASSERT_EQ(
    RunHasp({ "convert", this->Path("b.ply"), this->Path("b.stl"), "--quiet" }).exitCode, 0);
  const HaspRun run = this->Reduce(
    { "b.stl", "a.ply" }, { "--snap", "--json", "--write-edits", this->Path("edits.json") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json said = json::parse(run.out);
  EXPECT_TRUE(said.at("soft_value").is_null()); // of scans
  ASSERT_EQ(said.at("units").size(), 2U);
  EXPECT_TRUE(said.at("units")[1].at("placed").get<bool>());
  RecordProperty("off_mm", std::to_string(this->Off(upper)));
  EXPECT_LT(this->Off(upper), 0.5); // the bar; the grid's spacing
  EXPECT_EQ(this->Plan().at("fragments")[0], before.at("fragments")[0]);
  const json after = this->Plan();
  ASSERT_EQ(this->OfPlan({ "--undo" }).exitCode, 0);
  EXPECT_EQ(this->Plan(), before);
  ASSERT_EQ(this->OfPlan({ "--apply", this->Path("edits.json") }).exitCode, 0);
  EXPECT_EQ(this->Plan(), after);
}

TEST_F(HaspReduceSurfaces, OpenSherdsAreSheets)
{
  this->WritePly("a.ply", Sherd(false));
  this->WritePly("b.ply", Sherd(true), this->Apart);
  this->MakePlan({ "--thickness", "5" });
  EXPECT_GT(this->Off(Sherd(true)), 2.5);
  const auto evaluated = [this]
  {
    const HaspRun run = RunHasp({ "evaluate", this->Path("case.hasp"), "--surface",
      this->Path("a.ply"), "--surface", this->Path("b.ply"), "--quiet", "--json" });
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return json::parse(run.out).at("fractures").at(0);
  };
  const json before = evaluated();
  const HaspRun run = this->Reduce({ "a.ply", "b.ply" }, { "--snap" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  RecordProperty("off_mm", std::to_string(this->Off(Sherd(true))));
  EXPECT_LT(this->Off(Sherd(true)), 0.5);
  const json after = evaluated();
  EXPECT_LT(after.at("step").at("p95_abs_mm"), 0.5);
  EXPECT_LT(after.at("gap").at("p95_abs_mm"), 0.5);
  EXPECT_GT(before.at("gap").at("p95_abs_mm"), 1.0);
}

TEST_F(HaspReduceSurfaces, SaysWhichSurfaceIsWrongOrMissing)
{
  this->WriteBlock();
  this->MakePlan();
  ExpectFailure(this->Reduce({}, {}), 2, "surface 1 of fragment 2, surface 3 of fragment 4: not ");
  ExpectFailure(this->Reduce({ "a.ply" }, {}), 2, "surface 3 of fragment 4: not among the files");
  this->WritePly("c.ply", Sherd(true));
  ExpectFailure(this->Reduce({ "a.ply", "c.ply", "b.ply" }, {}), 2,
    "--surface number 2 is none of the plan's surfaces");
  ExpectFailure(this->Reduce({ "a.ply", "none.ply" }, {}), 2, "no such file");
  const json before = this->Plan();
  ExpectFailure(
    this->OfPlan({ "--surface", this->Path("c.ply") }), 2, "--surface number 1: it is open");
  ExpectFailure(
    this->OfPlan({ "--surface", this->Path("a.ply") }), 2, "the triangles of surface 1");
  ExpectFailure(this->OfPlan({ "--thickness", "3" }), 1, "--thickness requires --surface");
  EXPECT_EQ(this->Plan(), before);
  const HaspRun shown = RunHasp({ "plan", this->Path("case.hasp") });
  EXPECT_NE(shown.out.find("fragment 4: surface 3, closed; moved"), std::string::npos) << shown.out;
}

} // namespace
