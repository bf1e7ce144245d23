#include "Realtime/NanosecondHistogram.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace hasp
{

namespace
{
constexpr int SubBits = 5, Sub = 1 << SubBits; // bins an octave
} // namespace

int NanosecondCounts::BinOf(std::int64_t ns) noexcept
{
  if (ns < Sub)
    return static_cast<int>(std::max<std::int64_t>(ns, 0));
  const auto value = static_cast<std::uint64_t>(ns);
  const int octave = std::bit_width(value) - 1 - SubBits; // 0 for 32 to 63
  return std::min(Sub * octave + static_cast<int>(value >> octave), Bins - 1);
}

std::int64_t NanosecondCounts::FirstOf(int bin) noexcept
{
  if (bin < Sub)
    return bin;
  const int octave = bin / Sub - 1;
  return static_cast<std::int64_t>(Sub + bin % Sub) << octave;
}

double NanosecondCounts::MeanNs() const noexcept
{
  return this->total == 0 ? 0.0 : this->sumNs / static_cast<double>(this->total);
}

double NanosecondCounts::PercentileNs(double share) const noexcept
{
  if (this->total == 0)
    return 0.0;
  const double wanted = std::ceil(std::clamp(share, 0.0, 1.0) * static_cast<double>(this->total));
  const auto rank = std::max<std::uint64_t>(static_cast<std::uint64_t>(wanted), 1);
  std::uint64_t seen = 0;
  int bin = 0;
  while (bin < Bins - 1 && (seen += this->counts[bin]) < rank)
    ++bin;
  const auto first = static_cast<double>(FirstOf(bin));
  const auto last = bin < Bins - 1 ? static_cast<double>(FirstOf(bin + 1) - 1) : first;
  return std::clamp(0.5 * (first + last), static_cast<double>(this->leastNs),
    static_cast<double>(std::max(this->leastNs, this->mostNs)));
}

std::uint64_t NanosecondCounts::Above(std::int64_t ns) const noexcept
{
  std::uint64_t above = 0;
  for (int bin = BinOf(ns) + 1; bin < Bins; ++bin)
    above += this->counts[bin];
  return above;
}

NanosecondCounts NanosecondCounts::Since(const NanosecondCounts& earlier) const noexcept
{
  NanosecondCounts since;
  for (int bin = 0; bin < Bins; ++bin)
  {
    const std::uint64_t count = since.counts[bin] = this->counts[bin] - earlier.counts[bin];
    if (count == 0)
      continue;
    if (since.total == 0)
      since.leastNs = FirstOf(bin);
    since.mostNs = bin < Bins - 1 ? FirstOf(bin + 1) - 1 : this->mostNs;
    since.total += count;
  }
  since.sumNs = this->sumNs - earlier.sumNs;
  return since;
}

void NanosecondHistogram::Add(std::int64_t ns) noexcept
{
  // One thread adds: it reads back what it wrote itself, and needs no locked addition.
  constexpr auto relaxed = std::memory_order_relaxed;
  ns = std::max<std::int64_t>(ns, 0);
  auto& count = this->Counts[NanosecondCounts::BinOf(ns)];
  count.store(count.load(relaxed) + 1, relaxed);
  this->SumNs.store(this->SumNs.load(relaxed) + static_cast<double>(ns), relaxed);
  if (ns < this->LeastNs.load(relaxed))
    this->LeastNs.store(ns, relaxed);
  if (ns > this->MostNs.load(relaxed))
    this->MostNs.store(ns, relaxed);
}

NanosecondCounts NanosecondHistogram::Read() const noexcept
{
  constexpr auto relaxed = std::memory_order_relaxed;
  NanosecondCounts read;
  for (int bin = 0; bin < NanosecondCounts::Bins; ++bin)
    read.total += read.counts[bin] = this->Counts[bin].load(relaxed);
  read.sumNs = this->SumNs.load(relaxed);
  read.mostNs = this->MostNs.load(relaxed);
  read.leastNs = std::min(this->LeastNs.load(relaxed), read.mostNs);
  return read;
}

} // namespace hasp
