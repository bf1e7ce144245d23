#include "Light/RadianceFile.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

namespace
{

using Rgbe = std::array<std::uint8_t, 4>;
constexpr int MostColumns = 16384, MostRows = 8192;
constexpr std::size_t LongestLine = 4096; // of a header
constexpr int MostLines = 1000;

/// Bytes of a file one after the other, and what to say when there are no more.
class Bytes
{
public:
  Bytes(const std::filesystem::path& path) : Name(path.filename().string())
  {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    this->File.open(path, std::ios::binary);
    if (error || !this->File)
      this->Fail("cannot be read; is it there, and a file?");
    this->Size = size;
  }
  [[noreturn]] void Fail(const std::string& what) const
  {
    throw std::runtime_error("environment " + this->Name + ": " + what);
  }
  [[noreturn]] void FailInRow(int row, const std::string& what) const
  {
    this->Fail(what + " in row " + std::to_string(row + 1) +
               "; the file is damaged or incomplete, so get it again");
  }
  std::uintmax_t Left() { return this->Size - static_cast<std::uintmax_t>(this->File.tellg()); }
  std::uint8_t Next(int row)
  {
    const int byte = this->File.get();
    if (byte == std::char_traits<char>::eof())
      this->FailInRow(row, "the file ends");
    return static_cast<std::uint8_t>(byte);
  }
  Rgbe NextPixel(int row)
  {
    Rgbe pixel;
    for (std::uint8_t& byte : pixel)
      byte = this->Next(row);
    return pixel;
  }
  std::string Line()
  {
    std::string line;
    for (int byte = this->File.get(); byte != '\n'; byte = this->File.get())
    {
      if (byte == std::char_traits<char>::eof())
        this->Fail("ends within its header; get it again");
      if (line.size() == LongestLine)
        this->Fail("is no Radiance picture: a line of its header does not end");
      line += static_cast<char>(byte);
    }
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    return line;
  }

private:
  std::string Name;
  std::ifstream File;
  std::uintmax_t Size = 0;
};

/// Reads on to the empty line; what the values are to be divided by.
double ReadHeader(Bytes& bytes)
{
  if (bytes.Line().rfind("#?", 0) != 0)
    bytes.Fail("is no Radiance picture (.hdr): it does not begin with #?");
  double exposure = 1.0;
  for (int lines = 0; lines < MostLines; ++lines)
  {
    const std::string line = bytes.Line();
    if (line.empty())
      return exposure;
    if (line.rfind("FORMAT=", 0) == 0 && line != "FORMAT=32-bit_rle_rgbe")
      bytes.Fail("has the pixels '" + line.substr(7) +
                 "'; 32-bit_rle_rgbe is read, so convert it (ra_xyze -r)");
    if (line.rfind("EXPOSURE=", 0) == 0)
    {
      double factor = 0.0;
      const char* from = line.data() + 9;
      while (*from == ' ')
        ++from;
      std::from_chars(from, line.data() + line.size(), factor);
      exposure *= factor;
      if (!(exposure > 0.0) || !std::isfinite(exposure))
        bytes.Fail("has the exposure '" + line.substr(9) + "', which is not above 0");
    }
  }
  bytes.Fail(
    "is no Radiance picture: its header has more than " + std::to_string(MostLines) + " lines");
}

glm::ivec2 ReadSize(Bytes& bytes)
{
  const std::string line = bytes.Line();
  int rows = 0, columns = 0, read = 0;
  if (std::sscanf(line.c_str(), "-Y %9d +X %9d%n", &rows, &columns, &read) != 2 ||
      std::size_t(read) != line.size())
    bytes.Fail("has the size '" + line.substr(0, 60) +
               "'; -Y rows +X columns is read: rows from the top, each from the left");
  if (rows < 1 || columns < 1 || rows > MostRows || columns > MostColumns)
    bytes.Fail("has " + std::to_string(columns) + " x " + std::to_string(rows) +
               " pixels; 1 x 1 to 16384 x 8192 are read, so scale it");
  return { columns, rows };
}

bool HasRuns(const Rgbe& first, int columns)
{
  return first[0] == 2 && first[1] == 2 && columns >= 8 && columns <= 32767 &&
         (first[2] << 8 | first[3]) == columns;
}

/// Channel by channel: runs of one value, and what is plain.
void ReadRuns(Bytes& bytes, int row, std::vector<Rgbe>& pixels)
{
  for (int channel = 0; channel < 4; ++channel)
    for (std::size_t x = 0; x < pixels.size();)
    {
      const std::uint8_t code = bytes.Next(row);
      const std::size_t count = code > 128 ? code - 128 : code;
      if (count == 0 || count > pixels.size() - x)
        bytes.FailInRow(row, "a run goes beyond the end");
      const std::uint8_t same = code > 128 ? bytes.Next(row) : std::uint8_t(0);
      for (std::size_t n = 0; n < count; ++n)
        pixels[x++][channel] = code > 128 ? same : bytes.Next(row);
    }
}

/// Pixel by pixel; 1, 1, 1 and a count repeat the last one, each further such 256 times as often.
void ReadPlain(Bytes& bytes, int row, Rgbe pixel, std::vector<Rgbe>& pixels)
{
  int shift = 0;
  for (std::size_t x = 0; x < pixels.size();)
  {
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1)
    {
      const std::size_t count = shift <= 16 ? std::size_t(pixel[3]) << shift : pixels.size() + 1;
      if (x == 0 || count > pixels.size() - x)
        bytes.FailInRow(row, "a run goes beyond the end");
      for (std::size_t n = 0; n < count; ++n, ++x)
        pixels[x] = pixels[x - 1];
      shift += 8;
    }
    else
    {
      pixels[x++] = pixel;
      shift = 0;
    }
    if (x < pixels.size())
      pixel = bytes.NextPixel(row);
  }
}

} // namespace

EnvironmentMap ReadRadianceFile(const std::filesystem::path& path)
{
  Bytes bytes(path);
  const double exposure = ReadHeader(bytes);
  EnvironmentMap map;
  map.size = ReadSize(bytes);
  // The shortest row: runs of 127 of each channel; plain, one pixel and its repeats.
  const std::uintmax_t least = std::uintmax_t(map.size.y) * std::min(4 + 8 * (map.size.x / 127), 8);
  if (bytes.Left() < (map.size.x == 1 ? std::uintmax_t(map.size.y) * 4 : least))
    bytes.Fail("says that it has " + std::to_string(map.size.x) + " x " +
               std::to_string(map.size.y) + " pixels, but ends after " +
               std::to_string(bytes.Left()) + " bytes of them; get it again");
  map.pixels.reserve(std::size_t(map.size.x) * std::size_t(map.size.y));
  std::vector<Rgbe> row(static_cast<std::size_t>(map.size.x));
  for (int y = 0; y < map.size.y; ++y)
  {
    const Rgbe first = bytes.NextPixel(y);
    if (HasRuns(first, map.size.x))
      ReadRuns(bytes, y, row);
    else
      ReadPlain(bytes, y, first, row);
    for (const Rgbe& pixel : row)
    {
      const double scale = pixel[3] == 0 ? 0.0 : std::ldexp(1.0, pixel[3] - 136) / exposure;
      map.pixels.emplace_back(glm::dvec3(pixel[0], pixel[1], pixel[2]) * scale);
    }
  }
  return map;
}

} // namespace hasp
