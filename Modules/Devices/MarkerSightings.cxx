#include "Devices/NumberTable.h"
#include "Devices/TextFile.h"
#include "Devices/TrackerCalibration.h"

namespace hasp
{
namespace
{
constexpr const char* What = "sightings of the marker";
constexpr std::string_view Columns =
  "trackerXMm,trackerYMm,trackerZMm,qw,qx,qy,qz,roomXMm,roomYMm,roomZMm";
constexpr double LeastDistanceMm = 50.0;
constexpr std::size_t MostSightings = 10'000;
constexpr std::size_t MostBytes = std::size_t(4) << 20;
} // namespace

std::vector<MarkerSighting> ParseMarkerSightings(std::string_view text)
{
  NumberTable<10> table(What, Columns, text);
  std::vector<MarkerSighting> sightings;
  while (!table.AtEnd())
  {
    const auto v = table.Next();
    if (sightings.size() == MostSightings)
      table.Refuse("there are more than " + std::to_string(MostSightings) + " sightings");
    const MarkerSighting sighting{ { { v[0], v[1], v[2] }, { v[3], v[4], v[5], v[6] } },
      { { v[7], v[8], v[9] }, { 1, 0, 0, 0 } } };
    try
    {
      ValidateHeadPose(sighting.marker);
      ValidateHeadPose(sighting.head);
    }
    catch (const std::invalid_argument& error)
    {
      table.Refuse(error.what());
    }
    if (v[9] < LeastDistanceMm)
      table.Refuse("the eyes are " + std::to_string(v[9]) +
                   " mm in front of the screen, must be at least 50: are these millimetres?");
    sightings.push_back(sighting);
  }
  return sightings;
}

std::vector<MarkerSighting> ReadMarkerSightings(const std::string& file)
{
  return ParseMarkerSightings(ReadTextFile(file, MostBytes, What));
}

} // namespace hasp
