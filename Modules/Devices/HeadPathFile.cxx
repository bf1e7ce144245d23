#include "Devices/HeadPath.h"
#include "Devices/NumberTable.h"
#include "Devices/TextFile.h"

#include <array>
#include <charconv>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* What = "head path";
constexpr std::string_view Columns = "timeS,xMm,yMm,zMm,qw,qx,qy,qz";
constexpr std::size_t MostBytes = std::size_t(256) << 20; // no double needs more than 24 characters
constexpr std::size_t LeastLine = 16; // eight digits, seven commas and the end of the line
} // namespace

HeadPath ParseHeadPath(std::string_view text)
{
  NumberTable<8> table(What, Columns, text);
  HeadPath path;
  path.reserve(std::min(MostHeadPathPoses, table.BytesLeft() / LeastLine + 1));
  while (!table.AtEnd())
  {
    const auto v = table.Next();
    if (path.size() == MostHeadPathPoses)
      table.Refuse("there are more than " + std::to_string(MostHeadPathPoses) + " poses");
    path.push_back({ v[0], { { v[1], v[2], v[3] }, { v[4], v[5], v[6], v[7] } } });
    try
    {
      // The pose and its time against the one before: what a whole path is held against.
      ValidateHeadPath(std::span(path).last(std::min<std::size_t>(path.size(), 2)));
    }
    catch (const std::invalid_argument& error)
    {
      table.Refuse(error.what());
    }
  }
  if (path.empty())
    table.Refuse(2, "there is no pose; one is the least");
  return path;
}

std::string FormatHeadPath(std::span<const TimedHeadPose> path)
{
  ValidateHeadPath(path);
  if (path.size() > MostHeadPathPoses)
    throw std::invalid_argument("head path: there are " + std::to_string(path.size()) +
                                " poses, at most " + std::to_string(MostHeadPathPoses));
  std::string text(Columns);
  for (const TimedHeadPose& timed : path)
  {
    const auto& [p, q] = timed.pose;
    char separator = '\n';
    for (const double value : { timed.timeS, p.x, p.y, p.z, q.w, q.x, q.y, q.z })
    {
      std::array<char, 32> digits{};
      const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
      text += separator;
      text.append(digits.data(), end);
      separator = ',';
    }
  }
  return text + '\n';
}

HeadPath ReadHeadPath(const std::string& file)
{
  return ParseHeadPath(ReadTextFile(file, MostBytes, What));
}

void WriteHeadPath(const std::string& file, std::span<const TimedHeadPose> path)
{
  WriteTextFile(file, FormatHeadPath(path), What);
}

} // namespace hasp
