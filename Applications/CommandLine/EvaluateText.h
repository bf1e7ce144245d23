#pragma once
#include "Evaluation/PoseDifference.h"
#include "Evaluation/StepAndGap.h"
#include "Evaluation/SurfaceDifference.h"
#include "Evaluation/SurfaceRegistration.h"
#include "Evaluation/TrialTable.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What `hasp evaluate` found, as text, JSON and CSV.
namespace hasp
{

struct FragmentResult
{
  std::uint32_t id = 0; ///< 0: of no plan
  std::string called;
  SurfaceDifference surface;
  std::optional<PoseDifference> pose;    ///< where both are the same bone
  std::optional<PoseDifference> aligned; ///< after best common alignment of all
};

/// Of two fragments that face each other.
struct FractureResult
{
  std::string first, second;
  std::uint32_t firstId = 0, secondId = 0; ///< 0: of no plan
  StepAndGap measured;
};

struct FracturesResult
{
  std::vector<FractureResult> fractures;
  std::vector<std::string> unmeasured; ///< fragments, each with why: "fragment 2: …"
};

struct PairResult
{
  std::string reference; ///< empty: none
  bool referenceMoved = false;
  std::vector<FragmentResult> fragments;
  std::vector<std::string> onlyFirst, onlySecond;
  FracturesResult firstFractures, secondFractures;
};

struct ScanResult
{
  std::string reference;
  SurfaceRegistration registration;
  struct Fragment
  {
    std::uint32_t id = 0;
    std::string called;
    DirectedDifference toOther;
  };
  std::vector<Fragment> fragments;
};

/// A key as it may be shown: no control characters, which a terminal would obey.
std::string PrintableName(const std::string& key);

nlohmann::ordered_json JsonOf(const PairResult& result);
std::string TextOf(const PairResult& result);
std::string CsvOf(const PairResult& result);

nlohmann::ordered_json JsonOf(const FracturesResult& result);
std::string TextOf(const FracturesResult& result);
std::string CsvOf(const FracturesResult& result);

nlohmann::ordered_json JsonOf(const ScanResult& result);
std::string TextOf(const ScanResult& result);

/// Cases, operators and fragments are named in the table as they are to be said.
nlohmann::ordered_json JsonOf(const TrialTable& table);
std::string TextOf(const TrialTable& table);
std::string CsvOf(const TrialTable& table);

} // namespace hasp
