#include "Devices/NumberTable.h"
#include "Devices/TextFile.h"
#include "Devices/TrackerCalibration.h"

namespace hasp
{
namespace
{
constexpr const char* What = "calibration points";
constexpr std::string_view Columns = "trackerXMm,trackerYMm,trackerZMm,roomXMm,roomYMm,roomZMm";
constexpr std::size_t MostPairs = 10'000; // as FitTrackerToRoom
constexpr std::size_t MostBytes = std::size_t(4) << 20;
} // namespace

std::vector<CalibrationPair> ParseCalibrationPairs(std::string_view text)
{
  NumberTable<6> table(What, Columns, text);
  std::vector<CalibrationPair> pairs;
  while (!table.AtEnd())
  {
    const auto v = table.Next();
    if (pairs.size() == MostPairs)
      table.Refuse("there are more than " + std::to_string(MostPairs) + " pairs");
    pairs.push_back({ { v[0], v[1], v[2] }, { v[3], v[4], v[5] } });
  }
  return pairs;
}

std::vector<CalibrationPair> ReadCalibrationPairs(const std::string& file)
{
  return ParseCalibrationPairs(ReadTextFile(file, MostBytes, What));
}

} // namespace hasp
