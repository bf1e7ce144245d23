#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>

namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

/// A broken phantom: fragments 3 (cranium) and 4 (jaw) are locked, 5 (condyle) and 6 (ramus) not.
class HaspReduce : public HaspTest
{
protected:
  void SetUp() override
  {
    HaspTest::SetUp();
    ASSERT_EQ(RunHasp({ "fracture", "--quiet", "--fragments", "3", "--shift", "8", "--turn", "8",
                        "--fine", "0.8", "--output", this->Path("case") })
                .exitCode,
      0);
  }

  HaspRun Reduce(const std::vector<std::string>& more) const
  {
    std::vector<std::string> words{ "reduce", this->Path("case/plan.hasp"), "--volume",
      this->Path("case/fractured_ct.mha"), "--obstacle", "3", "--quiet", "--starts", "8",
      "--start-mm", "8", "--start-degrees", "8" };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }

  json Plan() const
  {
    return json::parse(ReadBytes(this->Path("case/plan.hasp/plan.json"))).at("plan");
  }

  /// How far a plan's pose puts the centroid of a piece from where the bone was whole, mm.
  double Off(const json& pose, const json& piece) const
  {
    const auto& p = pose.at("position");
    const auto& q = pose.at("orientation");
    const std::array<double, 4> o{ q[0], q[1], q[2], q[3] };
    const json centroid = piece.at("centroid_anatomical_mm"), &moved = piece.at("displacement_4x4");
    std::array<double, 3> x{};
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        x[row] +=
          moved[row][column].get<double>() * (column < 3 ? centroid[column].get<double>() : 1.0);
    // x + 2 w (v x x) + 2 v x (v x x)
    const std::array<double, 3> v{ o[1], o[2], o[3] };
    const auto cross = [](const std::array<double, 3>& a, const std::array<double, 3>& b)
    {
      return std::array<double, 3>{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0] };
    };
    const auto once = cross(v, x), twice = cross(v, once);
    double squares = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double at = x[k] + 2.0 * (o[0] * once[k] + twice[k]) + p[k].get<double>();
      squares += (at - centroid[k].get<double>()) * (at - centroid[k].get<double>());
    }
    return std::sqrt(squares);
  }
};

TEST_F(HaspReduce, SnapsFragmentsAndTakesThemBack)
{
  const json before = this->Plan();
  const HaspRun shown = this->Reduce({ "--json" }); // nothing is stored
  ASSERT_EQ(shown.exitCode, 0) << shown.err;
  EXPECT_EQ(this->Plan(), before);
  const json said = json::parse(shown.out);
  ASSERT_EQ(said.at("units").size(), 4U);
  EXPECT_FALSE(said.at("stored").get<bool>());
  EXPECT_TRUE(said.at("units")[0].at("fixed").get<bool>());
  const json& ramus = said.at("units")[3];
  EXPECT_EQ(ramus.at("fragments"), (json{ 6 }));
  EXPECT_TRUE(ramus.at("placed").get<bool>());
  EXPECT_GT(ramus.at("within_95_mm").get<double>(), 0.0);
  EXPECT_FALSE(ramus.at("proposals").empty());

  const HaspRun snapped = this->Reduce({ "--snap" });
  ASSERT_EQ(snapped.exitCode, 0) << snapped.err;
  const json after = this->Plan(), truth = json::parse(ReadBytes(this->Path("case/truth.json")));
  EXPECT_EQ(after.at("fragments")[1], before.at("fragments")[1]); // locked
  const json& piece = truth.at("fragments")[1];
  const double start = this->Off(before.at("fragments")[3].at("scanToPlanned"), piece);
  const double end = this->Off(after.at("fragments")[3].at("scanToPlanned"), piece);
  EXPECT_GT(start, 7.0);
  EXPECT_LT(end, 0.5); // the bar
  ASSERT_EQ(RunHasp({ "plan", this->Path("case/plan.hasp"), "--undo", "--quiet" }).exitCode, 0);
  EXPECT_EQ(this->Plan(), before);
}

TEST_F(HaspReduce, WritesEditsThatAPlanTakes)
{
  const std::string edits = this->Path("edits.json");
  ASSERT_EQ(this->Reduce({ "--fragment", "6", "--write-edits", edits }).exitCode, 0);
  const json before = this->Plan();
  ASSERT_EQ(
    RunHasp({ "plan", this->Path("case/plan.hasp"), "--apply", edits, "--quiet" }).exitCode, 0);
  const json after = this->Plan();
  EXPECT_NE(after.at("fragments")[3], before.at("fragments")[3]);
  // plan.json alone is read, and never written.
  const std::string alone = this->Path("case/plan.hasp/plan.json");
  ExpectFailure(RunHasp({ "reduce", alone, "--snap" }), 1, "plan.json alone is only read");
}

TEST_F(HaspReduce, SaysWhatIsWrong)
{
  ExpectFailure(this->Reduce({ "--fragment", "99" }), 2, "object 99 is not a fragment of the plan");
  ExpectFailure(this->Reduce({ "--take", "5" }), 1, "--take takes a value ID:NUMBER");
  ExpectFailure(this->Reduce({ "--take", "6:0" }), 1, "--take takes a value ID:NUMBER");
  ExpectFailure(this->Reduce({ "--fragment", "6", "--take", "6:19" }), 1, "proposals");
  ExpectFailure(this->Reduce({ "--start-mm", "nan" }), 1, "--start-mm");
  ExpectFailure(RunHasp({ "reduce", this->Path("case/plan.hasp"), "--quiet" }), 2, "volume 1");
  // From too far away nothing can be placed, and nothing is stored.
  const json before = this->Plan();
  ASSERT_EQ(RunHasp({ "plan", this->Path("case/plan.hasp"), "--move", "6", "--shift", "0,0,300",
                      "--quiet" })
              .exitCode,
    0);
  const json moved = this->Plan();
  ExpectFailure(this->Reduce({ "--fragment", "6", "--snap" }), 3, "no fragment has a face");
  EXPECT_EQ(this->Plan(), moved);
}

TEST_F(HaspReduce, IsTheSameWithAnyNumberOfThreads)
{
  const HaspRun one = this->Reduce({ "--json", "--fragment", "6", "--threads", "1" });
  const HaspRun two = this->Reduce({ "--json", "--fragment", "6", "--threads", "2" });
  ASSERT_EQ(one.exitCode, 0);
  EXPECT_EQ(one.out, two.out);
}

} // namespace
