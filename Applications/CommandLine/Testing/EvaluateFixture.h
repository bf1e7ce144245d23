#ifndef EvaluateFixture_h
#define EvaluateFixture_h

// Plans and boxes to be measured.
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace
{

using nlohmann::json;

class HaspEvaluate : public HaspTest
{
protected:
  /// A closed box, as text.
  void WriteBox(const std::string& name, double x, double side = 10.0) const
  {
    const double low[3] = { x, 0, 0 }, high[3] = { x + side, 2 * side, 3 * side };
    std::string text = "solid box\n";
    const auto corner = [&](int c)
    {
      char line[120];
      std::snprintf(line, sizeof line, "vertex %.9g %.9g %.9g\n", c & 1 ? high[0] : low[0],
        c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2]);
      text += line;
    };
    const int faces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
      { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    for (const auto& f : faces)
      for (const auto& t : { std::array{ f[0], f[1], f[2] }, std::array{ f[0], f[2], f[3] } })
      {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int c : t)
          corner(c);
        text += "endloop\nendfacet\n";
      }
    this->WriteText(name, text + "endsolid box\n");
  }
  static json Pose(double x, double degreesAboutZ = 0.0, double y = 0.0)
  {
    const double half = 0.5 * degreesAboutZ * std::acos(-1.0) / 180.0;
    return { { "position", { x, y, 0 } },
      { "orientation", { std::cos(half), 0, 0, std::sin(half) } } };
  }
  static json Fragment(int id, const std::string& name, const json& pose, bool locked = false,
    const json& seed = { 0, 0, 0 })
  {
    return { { "add", "fragment" },
      { "object", { { "id", id }, { "name", name },
                    { "source", { { "volume", 1 }, { "isovalue", 226 }, { "seed", seed },
                                  { "spacingMm", 1.5 } } },
                    { "colour", "#ffffff" }, { "state", "kept" }, { "scanToPlanned", pose },
                    { "locked", locked } } } };
  }
  void WritePlan(const std::string& name, const json& fragments,
    const std::string& hash = std::string(64, 'a')) const
  {
    ASSERT_EQ(RunHasp({ "plan", this->Path(name), "--new" }).exitCode, 0);
    json edits{ { { "add", "volume" },
      { "object", { { "id", 1 }, { "name", "Erika" }, { "hash", hash } } } } };
    edits.insert(edits.end(), fragments.begin(), fragments.end());
    this->WriteText("edits.json", json{ { "format", "hasp-edits-3" }, { "edits", edits } }.dump());
    const HaspRun run = RunHasp({ "plan", this->Path(name), "--apply", this->Path("edits.json") });
    ASSERT_EQ(run.exitCode, 0) << run.err;
  }
  /// The skull as id 2, the jaw as 3.
  void WriteTrial(const std::string& name, double jaw, double skull = 0.0) const
  {
    this->WritePlan(
      name, { Fragment(2, "skull", Pose(skull), true), Fragment(3, "jaw", Pose(jaw)) });
  }
  HaspRun Evaluate(const std::vector<std::string>& paths, const std::vector<std::string>& more = {})
  {
    std::vector<std::string> words{ "evaluate" };
    for (const std::string& path : paths)
      words.push_back(this->Path(path));
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  json Found(const std::vector<std::string>& paths, std::vector<std::string> more = {})
  {
    more.push_back("--json");
    const HaspRun run = this->Evaluate(paths, more);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return run.exitCode == 0 ? json::parse(run.out) : json();
  }
};

} // namespace

#endif
