#pragma once
#include "HaspProcess.h"

#include "Grid/AnalyticSolid.h"
#include "Grid/Phantom.h"

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <map>

using nlohmann::json;
namespace fs = std::filesystem;

/// Corners of all of an STL's triangles.
inline std::vector<std::array<float, 3>> CornersOf(const std::string& stl)
{
  std::vector<std::array<float, 3>> corners;
  for (std::size_t at = 84; at + 50 <= stl.size(); at += 50)
    for (std::size_t corner = 1; corner < 4; ++corner)
      std::memcpy(corners.emplace_back().data(), stl.data() + at + 12 * corner, 12);
  return corners;
}

/// A plan on the phantom's fibula: volume 1, bone 2, cut 3 through its shaft, its pieces 4 (above)
/// and 5 (below, moved 2 mm), guide 6 for the cut, plate 7 on both pieces as planned, group 8 of
/// both, and guide 9 far from the cut.
class HaspRunTest : public HaspTest
{
protected:
  void SetUp() override
  {
    ASSERT_EQ(RunHasp({ "phantom", "--anatomy", "fibula", "--spacing", "1,1,2", "--output",
                        this->Path("leg.mha") })
                .exitCode,
      0);
    ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
    const json passport = json::parse(RunHasp({ "info", this->Path("leg.mha"), "--json" }).out);
    const std::string hash = passport.at("passport").at("hash");
    const json applied =
      this->Apply({ Add("volume", { { "id", 1 }, { "name", "Erika" }, { "hash", hash } }),
        Fragment(2, { { "volume", 1 }, { "isovalue", 226 }, { "seed", { 0, -5, 20 } },
                      { "spacingMm", 1.5 } }),
        { { "add", "cut" }, { "object", Cut(20) } },
        Fragment(4, { { "fragment", 2 }, { "seed", { 0, -5, 40 } } }),
        Fragment(5, { { "fragment", 2 }, { "seed", { 0, -5, 0 } } }), Move(-2), Guide(6, 20, { 3 }),
        Plate(), Add("group", { { "id", 8 }, { "name", "" }, { "fragments", { 4, 5 } } }),
        Guide(9, -60, json::array()) });
    ASSERT_EQ(applied.at("parts").size(), 6U);
  }

  static json Add(const char* kind, const json& object)
  {
    return { { "add", kind }, { "object", object } };
  }
  static json Pose(double z)
  {
    return { { "position", { 0, 0, z } }, { "orientation", { 1, 0, 0, 0 } } };
  }
  static json Fragment(int id, const json& source)
  {
    return Add(
      "fragment", { { "id", id }, { "name", "" }, { "source", source }, { "colour", "#ffffff" },
                    { "state", "kept" }, { "scanToPlanned", Pose(0) }, { "locked", false } });
  }
  static json Cut(double z)
  {
    return { { "id", 3 }, { "name", "" },
      { "blade", { { "point", { 0, -5, z } }, { "normal", { 0, 0, 1 } }, { "along", { 1, 0, 0 } },
                   { "widthMm", 22 }, { "depthMm", 40 }, { "kerfMm", 1.5 } } },
      { "fragments", { 2 } }, { "reachMm", 8 } };
  }
  /// Of the lower piece, along z.
  static json Move(double z)
  {
    return { { "pose", { { { "fragment", 5 }, { "scanToPlanned", Pose(z) } } } } };
  }
  /// On the shaft's front, and on its left side, from the closed form.
  static json Front(double z) { return Surface(z, { 0, -1, 0 }); }
  static json Side(double z) { return Surface(z, { 1, 0, 0 }); }
  static json Surface(double z, const glm::dvec3& way)
  {
    hasp::PhantomSettings settings;
    settings.anatomy = hasp::PhantomAnatomy::Fibula;
    const hasp::AnalyticSolid bone = hasp::PhantomSolid(settings);
    glm::dvec3 place(0.0, -5.0, z);
    while (bone.Distance(place).mm < 0.0)
      place += 0.02 * way;
    return { place.x, place.y, place.z };
  }
  static json Guide(int id, double z, const json& cuts)
  {
    const json recipe{ { "format", "hasp-guide-recipe-2" }, { "isovalue", 226 },
      { "landmarks", { Front(z - 12), Front(z), Front(z + 12) } }, { "outline", "open" },
      { "strokes", json::array() }, { "withdrawal", { 0, -1, 0 } }, { "axisSearchDeg", 0 },
      { "gapMm", 0.3 }, { "thicknessMm", 3 }, { "widthMm", 12 }, { "edgeRadiusMm", 0 },
      { "clearanceMm", 0.25 }, { "wallMm", 3 }, { "sleeveWallMm", 2 },
      { "spacingMm", 0.6 }, // shells under 4.5 spacings keep their thin edges (GuideWalls.h)
      { "ignoreBelowMm3", 100 }, { "slots", json::array() }, { "flanges", json::array() },
      { "holes", json::array() }, { "labels", json::array() } };
    return Add("guide", { { "id", id }, { "name", "" }, { "bone", 2 }, { "recipe", recipe },
                          { "cuts", cuts }, { "side", "none" } });
  }
  static json Plate()
  {
    const json recipe{ { "format", "hasp-plate-recipe-1" }, { "isovalue", 226 },
      { "ignoreBelowMm3", 100 }, { "landmarks", { Side(45), Side(35) } }, { "gapMm", 0.3 },
      { "thicknessMm", 2.5 }, { "widthMm", 6 }, { "bevelMm", 0 }, { "bridgeMm", 0 },
      { "edgeDistanceMm", 1 }, { "holeDistanceMm", 1 }, { "spacingMm", 0.6 },
      { "screws", { { { "point", Side(42) }, { "diameterMm", 2.4 }, { "headDiameterMm", 2.4 },
                    { "headDepthMm", 0 }, { "headAngleDeg", 90 }, { "lengthMm", 4 } } } },
      { "fragments", json::array() } };
    return Add("plate", { { "id", 7 }, { "name", "" }, { "volume", 0 }, { "fragments", { 4, 5 } },
                          { "recipe", recipe } });
  }

  /// Number 10, two segments out of the shaft, 30 mm each, in a line far from it.
  static json Transplant(double betweenMm)
  {
    const json transplant{ { "format", "hasp-transplant-1" },
      { "joints", { { { "point", { 60, 0, 0 } }, { "normal", { 1, 0, 0 } } },
                    { { "point", { 90, 0, 0 } }, { "normal", { 1, 0, 0 } } },
                    { { "point", { 120, 0, 0 } }, { "normal", { 1, 0, 0 } } } } },
      { "outward", { { 0, 0, 1 }, { 0, 0, 1 } } },
      { "donor", { { "axis", { { 0, 0, -170 }, { 0, -5, 0 }, { 0, 0, 170 } } },
                   { "lateral", { 1, 0, 0 } }, { "radiusMm", 9 }, { "keepMm", 75 } } },
      { "fromLastTip", false }, { "startOffsetMm", 0 }, { "kerfMm", 1 }, { "betweenMm", betweenMm },
      { "vessel", json::array() } };
    const json nowhere{ { "cut", 0 }, { "fragment", 0 } };
    return Add("transplant",
      { { "id", 10 }, { "name", "" }, { "donor", 2 }, { "first", nowhere }, { "last", nowhere },
        { "transplant", transplant }, { "mostGapMm", 0.5 }, { "mostOverlapMm", 0.5 } });
  }

  HaspRun Plan(const std::vector<std::string>& more)
  {
    std::vector<std::string> words{ "plan", this->Path("case.hasp") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  json Apply(const json& edits)
  {
    this->WriteText("edits.json", json{ { "format", "hasp-edits-3" }, { "edits", edits } }.dump());
    const HaspRun run = this->Plan({ "--apply", this->Path("edits.json"), "--json" });
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return json::parse(run.exitCode == 0 ? run.out : "{}");
  }
  HaspRun Make(const std::string& output, const std::vector<std::string>& more)
  {
    std::vector<std::string> words{ "run", this->Path("case.hasp"), "--output",
      this->Path(output) };
    words.insert(words.end(), more.begin(), more.end());
    const HaspRun run = RunHasp(words);
    EXPECT_EQ((run.out + run.err).find("Erika"), std::string::npos) << run.out << run.err;
    return run;
  }
  std::vector<std::string> Scan() const { return { "--volume", this->Path("leg.mha") }; }
  /// The ids of the objects that were made, not taken from the plan.
  static std::vector<int> Made(const HaspRun& run)
  {
    EXPECT_EQ(run.exitCode, 0) << run.err;
    std::vector<int> made;
    const json document = json::parse(run.exitCode == 0 ? run.out : "{\"parts\":[]}");
    for (const json& part : document.at("parts"))
      if (part.at("made").get<bool>())
        made.push_back(part.at("object"));
    return made;
  }
  std::map<std::string, std::string> Files(const std::string& folder) const
  {
    std::map<std::string, std::string> files;
    for (const auto& file : fs::directory_iterator(this->Path(folder)))
      files[file.path().filename().string()] = ReadBytes(file.path().string());
    return files;
  }
  std::vector<int> OutOfDate()
  {
    std::vector<int> objects;
    const json shown = json::parse(this->Plan({ "--json" }).out);
    for (const json& part : shown.at("parts"))
      if (!part.at("in_date").get<bool>())
        objects.push_back(part.at("object"));
    return objects;
  }
};
