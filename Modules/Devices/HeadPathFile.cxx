#include "Devices/HeadPath.h"
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
constexpr std::size_t MostPoses = 1'000'000;
constexpr std::size_t MostBytes = std::size_t(256) << 20; // no double needs more than 24 characters
constexpr std::size_t LeastLine = 16; // eight digits, seven commas and the end of the line

[[noreturn]] void Refuse(std::size_t line, const std::string& why)
{
  throw std::invalid_argument(std::string(What) + ": line " + std::to_string(line) + ": " + why);
}

/// Takes the next line off the text, without its end; "\r\n" ends one, too.
std::string_view NextLine(std::string_view& text)
{
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  return line;
}

std::array<double, 8> Numbers(std::string_view line, std::size_t number)
{
  std::array<double, 8> values{};
  const char *at = line.data(), *const end = line.data() + line.size();
  for (std::size_t c = 0; c < values.size(); ++c)
  {
    if (c > 0 && (at == end || *at++ != ','))
      Refuse(number, "there must be eight numbers with commas between them");
    const auto [next, error] = std::from_chars(at, end, values[c]);
    if (error != std::errc())
      Refuse(number, "column " + std::to_string(c + 1) + " is no number that a double holds");
    at = next;
  }
  if (at != end)
    Refuse(number, "something stands behind the eighth number");
  return values;
}
} // namespace

HeadPath ParseHeadPath(std::string_view text)
{
  if (NextLine(text) != Columns)
    Refuse(1, "it must be " + std::string(Columns));
  HeadPath path;
  path.reserve(std::min(MostPoses, text.size() / LeastLine + 1));
  for (std::size_t line = 2; !text.empty(); ++line)
  {
    if (path.size() == MostPoses)
      Refuse(line, "there are more than " + std::to_string(MostPoses) + " poses");
    const auto v = Numbers(NextLine(text), line);
    path.push_back({ v[0], { { v[1], v[2], v[3] }, { v[4], v[5], v[6], v[7] } } });
    try
    {
      // The pose and its time against the one before: what a whole path is held against.
      ValidateHeadPath(std::span(path).last(std::min<std::size_t>(path.size(), 2)));
    }
    catch (const std::invalid_argument& error)
    {
      Refuse(line, error.what());
    }
  }
  if (path.empty())
    Refuse(2, "there is no pose; one is the least");
  return path;
}

std::string FormatHeadPath(std::span<const TimedHeadPose> path)
{
  ValidateHeadPath(path);
  if (path.size() > MostPoses)
    throw std::invalid_argument("head path: there are " + std::to_string(path.size()) +
                                " poses, at most " + std::to_string(MostPoses));
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
