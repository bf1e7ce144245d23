#include "CanaryFiles.h"

#include <cstdint>
#include <functional>
#include <map>
#include <utility>

// DICOM by hand, explicit little endian: what a library would refuse to write is wanted here.
namespace canary
{
namespace
{

using Tag = std::pair<std::uint16_t, std::uint16_t>;

struct Element
{
  std::string vr, value;
};
using Elements = std::map<Tag, Element>; // in the order of tags, as the standard wants it

template <typename T>
std::string Little(T number)
{
  std::string bytes;
  for (std::size_t n = 0; n < sizeof(T); ++n)
    bytes.push_back(static_cast<char>(number >> (8 * n) & 0xff));
  return bytes;
}

std::string Encode(const Elements& elements)
{
  std::string bytes;
  for (const auto& [tag, element] : elements)
  {
    std::string value = element.value;
    if (value.size() % 2 != 0)
      value.push_back(element.vr == "UI" || element.vr == "OB" ? '\0' : ' ');
    bytes += Little(tag.first) + Little(tag.second) + element.vr;
    const bool wide = element.vr == "OB" || element.vr == "OW" || element.vr == "UT" ||
                      element.vr == "UN" || element.vr == "UC" || element.vr == "UR" ||
                      element.vr == "SQ";
    if (wide)
      bytes += std::string(2, '\0') + Little(static_cast<std::uint32_t>(value.size()));
    else
      bytes += Little(static_cast<std::uint16_t>(value.size()));
    bytes += value;
  }
  return bytes;
}

std::string Upper(std::string text)
{
  for (char& c : text)
    c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return text;
}

/// A token in the form each value representation has, for the places of the standard's attributes.
std::string TextFor(const std::string& vr)
{
  if (vr == "PN")
    return Family + "^" + Given + "^\xc4\xd6^Dr="; // Latin-1 beside it
  if (vr == "CS" || vr == "AE")
    return Upper(Family) + "_X";
  if (vr == "SH")
    return Given + "\xe9";
  if (vr == "UI")
    return "1.2." + Number;
  if (vr == "DA" || vr == "DT")
    return Day;
  if (vr == "TM" || vr == "AS")
    return vr == "TM" ? "191919" : "058Y";
  return Family + "_" + Upper(Given) + " \xc3\xa9\\" + Given; // UTF-8; two values
}

Elements Slice(int k)
{
  const auto word = [](int n) { return Little(static_cast<std::uint16_t>(n)); };
  Elements e{ { { 0x0008, 0x0016 }, { "UI", "1.2.840.10008.5.1.4.1.1.2" } },
    { { 0x0008, 0x0018 }, { "UI", "1.2." + Number + "." + std::to_string(k + 1) } },
    { { 0x0008, 0x0060 }, { "CS", "CT" } }, { { 0x0020, 0x000d }, { "UI", "1.2." + Number } },
    { { 0x0020, 0x000e }, { "UI", "1.2." + Number } },
    { { 0x0020, 0x0052 }, { "UI", "1.2." + Number } },
    { { 0x0020, 0x0013 }, { "IS", std::to_string(k + 1) } },
    { { 0x0020, 0x0032 }, { "DS", "0\\0\\" + std::to_string(2 * k) } },
    { { 0x0020, 0x0037 }, { "DS", "1\\0\\0\\0\\1\\0" } }, { { 0x0028, 0x0002 }, { "US", word(1) } },
    { { 0x0028, 0x0004 }, { "CS", "MONOCHROME2" } }, { { 0x0028, 0x0010 }, { "US", word(8) } },
    { { 0x0028, 0x0011 }, { "US", word(8) } }, { { 0x0028, 0x0030 }, { "DS", "2\\2" } },
    { { 0x0028, 0x0100 }, { "US", word(16) } }, { { 0x0028, 0x0101 }, { "US", word(16) } },
    { { 0x0028, 0x0102 }, { "US", word(15) } }, { { 0x0028, 0x0103 }, { "US", word(1) } },
    { { 0x0028, 0x1052 }, { "DS", "0" } }, { { 0x0028, 0x1053 }, { "DS", "1" } },
    { { 0x0028, 0x1054 }, { "LO", "HU" } },
    { { 0x7fe0, 0x0010 }, { "OW", Ball().substr(static_cast<std::size_t>(k) * 128, 128) } } };
  // Names, numbers, days, places, comments and descriptions; private ones, and one in a sequence.
  for (const auto& [group, element, vr] : std::vector<std::tuple<int, int, std::string>>{
         { 0x0008, 0x0020, "DA" }, { 0x0008, 0x0022, "DA" }, { 0x0008, 0x002a, "DT" },
         { 0x0008, 0x0030, "TM" }, { 0x0008, 0x0050, "SH" }, { 0x0008, 0x0054, "AE" },
         { 0x0008, 0x0070, "LO" }, { 0x0008, 0x0080, "LO" }, { 0x0008, 0x0081, "ST" },
         { 0x0008, 0x0090, "PN" }, { 0x0008, 0x0092, "ST" }, { 0x0008, 0x1010, "SH" },
         { 0x0008, 0x1030, "LO" }, { 0x0008, 0x103e, "LO" }, { 0x0008, 0x1040, "LO" },
         { 0x0008, 0x1048, "PN" }, { 0x0008, 0x1070, "PN" }, { 0x0008, 0x1080, "LO" },
         { 0x0008, 0x1090, "LO" }, { 0x0008, 0x2111, "ST" }, { 0x0009, 0x0010, "LO" },
         { 0x0009, 0x1001, "UN" }, { 0x0009, 0x1002, "UT" }, { 0x0010, 0x0010, "PN" },
         { 0x0010, 0x0020, "LO" }, { 0x0010, 0x0030, "DA" }, { 0x0010, 0x1000, "LO" },
         { 0x0010, 0x1001, "PN" }, { 0x0010, 0x1010, "AS" }, { 0x0010, 0x1040, "LO" },
         { 0x0010, 0x2154, "SH" }, { 0x0010, 0x21b0, "LT" }, { 0x0010, 0x4000, "LT" },
         { 0x0018, 0x0015, "CS" }, { 0x0018, 0x1000, "LO" }, { 0x0018, 0x1030, "LO" },
         { 0x0018, 0x1210, "SH" }, { 0x0020, 0x0010, "SH" }, { 0x0020, 0x1040, "LO" },
         { 0x0020, 0x4000, "LT" }, { 0x0032, 0x1032, "PN" }, { 0x0032, 0x4000, "LT" },
         { 0x0038, 0x0500, "LO" }, { 0x0040, 0x0254, "LO" }, { 0x0040, 0x0280, "ST" },
         { 0x0040, 0xa160, "UT" }, { 0x4008, 0x010b, "ST" } })
    e[{ static_cast<std::uint16_t>(group), static_cast<std::uint16_t>(element) }] = { vr,
      TextFor(vr) };
  const std::string item = Encode({ { { 0x0010, 0x0010 }, { "PN", TextFor("PN") } } });
  e[{ 0x0010, 0x1002 }] = { "SQ", Little<std::uint16_t>(0xfffe) + Little<std::uint16_t>(0xe000) +
                                    Little(static_cast<std::uint32_t>(item.size())) + item };
  return e;
}

std::string File(const Elements& data)
{
  const std::string meta = Encode({ { { 0x0002, 0x0002 }, { "UI", "1.2.840.10008.5.1.4.1.1.2" } },
    { { 0x0002, 0x0003 }, { "UI", "1.2." + Number } },
    { { 0x0002, 0x0010 }, { "UI", "1.2.840.10008.1.2.1" } },
    { { 0x0002, 0x0012 }, { "UI", "1.2." + Number } },
    { { 0x0002, 0x0013 }, { "SH", TextFor("SH") } },
    { { 0x0002, 0x0016 }, { "AE", TextFor("AE") } } });
  std::string preamble = Family + Given; // it may hold anything
  preamble.resize(128, '\0');
  return preamble + "DICM" +
         Encode(
           { { { 0x0002, 0x0000 }, { "UL", Little(static_cast<std::uint32_t>(meta.size())) } } }) +
         meta + Encode(data);
}

} // namespace

std::vector<Input> MakeDicomFolders(const std::filesystem::path& folder)
{
  using Change = std::function<void(int, Elements&)>;
  const auto text = [](std::uint16_t group, std::uint16_t element, const std::string& vr) {
    return Change([=](int, Elements& e) { e[{ group, element }] = { vr, TextFor(vr) }; });
  };
  const std::vector<std::tuple<std::string, bool, Change>> kinds{
    { "plain", true, [](int, Elements&) {} },
    { "modality", true, text(0x0008, 0x0060, "CS") },
    { "rescale", true, text(0x0028, 0x1054, "LO") },
    { "type", true, text(0x0008, 0x0008, "CS") },
    { "burned", true, text(0x0028, 0x0301, "CS") },
    { "photometric", false, text(0x0028, 0x0004, "CS") },
    { "position", false, text(0x0020, 0x0032, "DS") },
    { "spacing", false, text(0x0028, 0x0030, "DS") },
    { "slope", false, text(0x0028, 0x1053, "DS") },
    { "two series", false,
      [](int k, Elements& e)
      {
        if (k >= 4)
          e[{ 0x0020, 0x000e }] = { "UI", "1.2." + Number + ".7" };
        e[{ 0x0008, 0x0060 }] = { "CS", TextFor("CS") };
      } },
    { "missing", false,
      [](int k, Elements& e) {
        e[{ 0x0020, 0x0032 }].value = "0\\0\\" + std::to_string(k < 4 ? 2 * k : 2 * k + 4);
      } },
  };
  std::vector<Input> inputs;
  for (const auto& [kind, opens, change] : kinds)
  {
    const auto series = folder / (Name() + " " + kind);
    for (int k = 0; k < 8; ++k)
    {
      Elements slice = Slice(k);
      change(k, slice);
      WriteTo(series / (Name() + std::to_string(k) + ".dcm"), File(slice));
    }
    inputs.push_back({ series.string(), opens });
  }
  return inputs;
}

} // namespace canary
