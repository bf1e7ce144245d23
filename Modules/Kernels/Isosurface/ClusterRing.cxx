#include "Isosurface/ClusterRing.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hasp
{

ClusterRing::ClusterRing(std::size_t records, std::size_t words) : Records(records), Corners(words)
{
  if (records == 0 || words < MostWords)
    throw std::invalid_argument(
      "ClusterRing: needs a record and " + std::to_string(MostWords) + " words of corners or more");
}

std::size_t ClusterRing::Bytes() const
{
  return this->Records.size() * sizeof(Record) + this->Corners.size() * sizeof(std::uint32_t);
}

bool ClusterRing::Old(std::uint32_t number) const
{
  // Of both rings what is left until the young end comes round to it; few enough words never let
  // the records fill up, and the other way round.
  const std::size_t records = this->Capacity(), words = this->Corners.size();
  const std::size_t end = this->Oldest + this->Count;
  const std::size_t recordsLeft = (number + 2 * records - end) % records;
  const std::size_t wordsLeft =
    (this->Records[number].cluster.firstWord + words - this->NextWord) % words;
  return 2 * recordsLeft < records || 2 * wordsLeft < words;
}

void ClusterRing::DropOldest(const Dropped& dropped)
{
  const auto number = static_cast<std::uint32_t>(this->Oldest);
  if (this->Records[number].live)
  {
    dropped(number);
    this->Remove(number);
  }
  this->Oldest = (this->Oldest + 1) % this->Capacity();
  --this->Count;
}

std::uint32_t ClusterRing::Add(
  const BlockKey& key, const ClusterLayer& layer, std::uint32_t now, const Dropped& dropped)
{
  const std::size_t words = layer.corners.size();
  std::size_t first = this->NextWord;
  if (first + words > this->Corners.size()) // no cluster is cut in two
  {
    // What lies between here and the end is the oldest, and in the way of the next turn.
    while (this->Count > 0 && this->Records[this->Oldest].cluster.firstWord >= first)
      this->DropOldest(dropped);
    first = 0;
  }
  const auto inTheWay = [&](const Record& oldest)
  {
    const std::size_t begin = oldest.cluster.firstWord;
    return begin < first + words && first < begin + oldest.words;
  };
  while (
    this->Count == this->Capacity() || (this->Count > 0 && inTheWay(this->Records[this->Oldest])))
    this->DropOldest(dropped);

  const std::size_t number = (this->Oldest + this->Count) % this->Capacity();
  Record& record = this->Records[number];
  record = { key, layer.clusters.front(), static_cast<std::uint32_t>(words), now, now, true };
  record.cluster.firstWord = static_cast<std::uint32_t>(first);
  record.cluster.firstCell = 0;
  std::copy(
    layer.corners.begin(), layer.corners.end(), this->Corners.begin() + std::ptrdiff_t(first));
  this->NextWord = first + words;
  ++this->Count;
  ++this->LiveCount;
  return static_cast<std::uint32_t>(number);
}

void ClusterRing::Remove(std::uint32_t number)
{
  this->LiveCount -= this->Records[number].live;
  this->Records[number].live = false;
}

std::vector<std::uint32_t> ClusterRing::Numbers() const
{
  std::vector<std::uint32_t> numbers;
  numbers.reserve(this->LiveCount);
  for (std::size_t n = 0; n < this->Count; ++n)
    if (const std::size_t number = (this->Oldest + n) % this->Capacity();
        this->Records[number].live)
      numbers.push_back(static_cast<std::uint32_t>(number));
  return numbers;
}

bool ClusterRing::Holds(std::uint32_t number, const ClusterLayer& layer) const
{
  const Record& record = this->Records[number];
  CellCluster cluster = layer.clusters.front();
  cluster.firstWord = record.cluster.firstWord;
  cluster.firstCell = record.cluster.firstCell;
  return record.cluster == cluster && std::equal(layer.corners.begin(), layer.corners.end(),
                                        this->Words(record), this->Words(record) + record.words);
}

} // namespace hasp
