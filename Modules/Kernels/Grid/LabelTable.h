#pragma once
#include "Grid/GridView.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// What a label of a label map is called and how it is drawn. The name is a user's words, or a
/// file's, a patient's name perhaps: it is for the eyes of who wrote or opened it, not for logs.
struct LabelEntry
{
  std::uint16_t value = 1; ///< [1, 65535]; 0 is nothing and has no entry
  std::string name;        ///< UTF-8
  std::array<std::uint8_t, 3> colour{ 227, 218, 201 }; ///< red, green, blue
  bool bone = true; ///< files say so in a terminology's code; false: they say nothing of it
  bool operator==(const LabelEntry&) const noexcept = default;
};

/// Each value once, in the order in which they are listed to a user.
using LabelTable = std::vector<LabelEntry>;

/// The labels that occur, 0 left out, in ascending order. Any thread; no state kept; O(samples), on
/// all cores.
std::vector<std::uint16_t> LabelsOf(GridView<const std::uint16_t> labels);
std::vector<std::uint16_t> LabelsOf(GridView<const std::uint8_t> labels);

/// What a label is called before anybody names it: "Bone" is 1, "Fragment 2" is 2. Hues of
/// neighbours are a golden angle apart, the same on every run.
LabelEntry UnnamedLabel(std::uint16_t value);

/// The table, and behind it UnnamedLabel for each of these labels that it lacks, in their order.
LabelTable WithUnnamedLabels(LabelTable table, const std::vector<std::uint16_t>& labels);

} // namespace hasp
