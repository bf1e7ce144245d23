#include "Grid/LabelTable.h"

#include "Grid/ParallelFor.h"

#include <atomic>
#include <cmath>
#include <set>

namespace hasp
{
namespace
{

template <typename T>
std::vector<std::uint16_t> Occurring(const GridView<const T>& labels)
{
  std::vector<std::atomic<bool>> seen(65536);
  constexpr std::int64_t grain = 1 << 18;
  ParallelFor(0, static_cast<std::int64_t>(labels.geometry.Size()), grain,
    [&](std::int64_t first, std::int64_t last)
    {
      T before = 0; // most samples are as the one before them
      for (std::int64_t n = first; n < last; ++n)
        if (const T label = labels.data[n]; label != before)
        {
          seen[label].store(true, std::memory_order_relaxed);
          before = label;
        }
    });
  std::vector<std::uint16_t> occurring;
  for (std::size_t label = 1; label < seen.size(); ++label)
    if (seen[label])
      occurring.push_back(static_cast<std::uint16_t>(label));
  return occurring;
}

} // namespace

std::vector<std::uint16_t> LabelsOf(GridView<const std::uint16_t> labels)
{
  return Occurring(labels);
}

std::vector<std::uint16_t> LabelsOf(GridView<const std::uint8_t> labels)
{
  return Occurring(labels);
}

LabelEntry UnnamedLabel(std::uint16_t value)
{
  if (value == 1)
    return { value, "Bone" };
  LabelEntry entry{ value, "Fragment " + std::to_string(value) };
  for (int c = 0; c < 3; ++c)
  {
    const double turn = 0.381966 * value + c / 3.0;
    entry.colour[c] =
      static_cast<std::uint8_t>(std::lround(140.0 + 100.0 * std::cos(6.283185 * turn)));
  }
  return entry;
}

LabelTable WithUnnamedLabels(LabelTable table, const std::vector<std::uint16_t>& labels)
{
  std::set<std::uint16_t> named;
  for (const LabelEntry& entry : table)
    named.insert(entry.value);
  for (const std::uint16_t label : labels)
    if (named.insert(label).second)
      table.push_back(UnnamedLabel(label));
  return table;
}

} // namespace hasp
