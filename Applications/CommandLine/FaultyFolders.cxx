#include "FaultyFolders.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{

namespace fs = std::filesystem;

using Slices = std::vector<fs::path>;

std::string Load(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

void Save(const fs::path& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
}

/// An attribute with a 16-bit length in explicit little endian: where it begins and its value.
struct Attribute
{
  std::size_t at, length;
};

Attribute Find(const std::string& bytes, std::uint16_t group, std::uint16_t element, const char* vr)
{
  const std::string key{ static_cast<char>(group), static_cast<char>(group >> 8),
    static_cast<char>(element), static_cast<char>(element >> 8), vr[0], vr[1] };
  const std::size_t at = bytes.find(key);
  if (at == bytes.npos || at + 8 > bytes.size())
    throw std::runtime_error("the sound series lacks an attribute that a fault is made of");
  const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(bytes[at + n]); };
  return { at, std::size_t(byte(6)) + 256 * std::size_t(byte(7)) };
}

std::string ValueOf(
  const fs::path& file, std::uint16_t group, std::uint16_t element, const char* vr)
{
  const std::string bytes = Load(file);
  const Attribute a = Find(bytes, group, element, vr);
  return bytes.substr(a.at + 8, a.length);
}

void SetValue(const fs::path& file, std::uint16_t group, std::uint16_t element, const char* vr,
  std::string value)
{
  if (value.size() % 2 != 0)
    value += vr[0] == 'U' ? '\0' : ' '; // values have even lengths
  std::string bytes = Load(file);
  const Attribute a = Find(bytes, group, element, vr);
  bytes[a.at + 6] = static_cast<char>(value.size());
  bytes[a.at + 7] = static_cast<char>(value.size() >> 8);
  bytes.replace(a.at + 8, a.length, value);
  Save(file, bytes);
}

void Remove(const fs::path& file, std::uint16_t group, std::uint16_t element, const char* vr)
{
  std::string bytes = Load(file);
  const Attribute a = Find(bytes, group, element, vr);
  bytes.erase(a.at, 8 + a.length);
  Save(file, bytes);
}

/// Adds to the three numbers of Image Position (Patient).
void Move(const fs::path& file, double x, double y, double z)
{
  std::istringstream numbers(ValueOf(file, 0x0020, 0x0032, "DS"));
  std::ostringstream moved;
  moved.precision(10);
  const double by[] = { x, y, z };
  for (int n = 0; n < 3; ++n)
  {
    std::string number;
    std::getline(numbers, number, '\\');
    moved << (n > 0 ? "\\" : "") << std::stod(number) + by[n];
  }
  SetValue(file, 0x0020, 0x0032, "DS", moved.str());
}

struct Fault
{
  const char* name;
  std::function<void(const Slices&)> make;
};

const std::vector<Fault>& Faults()
{
  static const std::vector<Fault> faults{
    { "one slice is missing", [](const Slices& s) { fs::remove(s[s.size() / 2]); } },
    { "a slice is there twice, another not", [](const Slices& s) { Save(s[2], Load(s[3])); } },
    { "one slice is 0.6 mm off along the stack", [](const Slices& s) { Move(s[2], 0, 0, 0.6); } },
    { "the stack is sheared (gantry tilt)",
      [](const Slices& s)
      {
        for (std::size_t k = 0; k < s.size(); ++k)
          Move(s[k], 0, 0.2 * double(k), 0);
      } },
    { "two series are mixed",
      [](const Slices& s)
      {
        for (std::size_t k = 0; k < s.size(); k += 2)
          SetValue(s[k], 0x0020, 0x000e, "UI", "1.2.826.0.1.1");
      } },
    { "no pixel spacing",
      [](const Slices& s)
      {
        for (const auto& file : s)
          Remove(file, 0x0028, 0x0030, "DS");
      } },
    { "pixel spacing 0",
      [](const Slices& s)
      {
        for (const auto& file : s)
          SetValue(file, 0x0028, 0x0030, "DS", "0\\0");
      } },
    { "no positions",
      [](const Slices& s)
      {
        for (const auto& file : s)
          Remove(file, 0x0020, 0x0032, "DS");
      } },
    { "a position that is no number",
      [](const Slices& s) { SetValue(s[1], 0x0020, 0x0032, "DS", "nan\\nan\\nan"); } },
    { "one slice is turned",
      [](const Slices& s) { SetValue(s[1], 0x0020, 0x0037, "DS", "0\\1\\0\\-1\\0\\0"); } },
    { "rescale slope 0",
      [](const Slices& s)
      {
        for (const auto& file : s)
          SetValue(file, 0x0028, 0x1053, "DS", "0");
      } },
    { "one slice is cut off",
      [](const Slices& s)
      {
        const std::string bytes = Load(s[4]);
        Save(s[4], bytes.substr(0, bytes.size() * 2 / 3));
      } },
    { "one slice declares another size",
      [](const Slices& s) { SetValue(s[1], 0x0028, 0x0010, "US", std::string("\x20\x00", 2)); } },
  };
  return faults;
}

Slices SlicesIn(const fs::path& folder)
{
  Slices slices;
  for (const auto& entry : fs::directory_iterator(folder))
    slices.push_back(entry.path());
  std::sort(slices.begin(), slices.end());
  if (slices.size() < 6)
    throw std::runtime_error("the sound series has fewer than six slices");
  return slices;
}

} // namespace

std::vector<FaultyFolder> MakeFaultyFolders(const fs::path& soundSeries, const fs::path& into)
{
  std::vector<FaultyFolder> made;
  for (const Fault& fault : Faults())
  {
    const fs::path folder = into / ("fault" + std::to_string(made.size()));
    fs::copy(soundSeries, folder, fs::copy_options::recursive);
    fault.make(SlicesIn(folder));
    made.push_back({ fault.name, folder });
  }
  return made;
}

} // namespace hasp
