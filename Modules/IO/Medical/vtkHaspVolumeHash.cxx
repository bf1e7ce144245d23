#include "vtkHaspVolumeHash.h"
#include "Volumes/CanonicalOrder.h"

#include "Grid/ParallelFor.h"

#if HASP_WITH_OPENSSL
#include <openssl/evp.h>
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace hasp
{

#if HASP_WITH_OPENSSL
namespace
{

using Digest = std::array<unsigned char, 32>;

Digest Sha256(const void* bytes, std::size_t size)
{
  Digest digest;
  unsigned int length = 0;
  if (EVP_Digest(bytes, size, digest.data(), &length, EVP_sha256(), nullptr) != 1 ||
      length != digest.size())
    throw std::runtime_error("SHA-256 is not available; check the installation of OpenSSL");
  return digest;
}

/// Whether all samples are whole and fit int16.
template <typename T>
bool AreInt16(const GridView<const T>& grid)
{
  if constexpr (std::is_same_v<T, std::int16_t> || std::is_same_v<T, std::uint8_t>)
    return true;
  std::atomic<bool> fit{ true };
  const std::size_t inSlice = std::size_t(grid.geometry.dims.x) * grid.geometry.dims.y;
  ParallelFor(0, grid.geometry.dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      const T* from = grid.data + first * inSlice;
      const T* const to = grid.data + last * inSlice;
      const bool all = std::all_of(from, to,
        [](T sample)
        {
          const float value = sample;
          return value >= -32768.0F && value <= 32767.0F && value == std::floor(value);
        });
      if (!all)
        fit = false;
    });
  return fit;
}

/// Hashes canonical slices, each on its own.
template <typename As, typename T>
class SliceDigests
{
public:
  explicit SliceDigests(const GridView<const T>& grid) : Grid(grid)
  {
    const CanonicalOrder order = CanonicalOrderOf(grid.geometry);
    const glm::ivec3& stored = grid.geometry.dims;
    const std::ptrdiff_t strides[] = { 1, stored.x, std::ptrdiff_t(stored.x) * stored.y };
    for (int a = 0; a < 3; ++a)
    {
      this->Dims[a] = stored[order.axis[a]];
      this->Stride[a] = strides[order.axis[a]];
      if (order.turned[a])
      {
        this->First += this->Stride[a] * (this->Dims[a] - 1);
        this->Stride[a] = -this->Stride[a];
      }
    }
    this->Digests.resize(static_cast<std::size_t>(this->Dims[2]));
  }

  const std::vector<Digest>& Run(const ProgressFunction& progress)
  {
    // Rounds, so that the calling thread can report between them.
    const std::int64_t round = std::max<std::int64_t>(32, 4 * ParallelThreads());
    // Where slices follow each other in memory a piece of them shares its cache lines.
    const bool across = std::abs(this->Stride[2]) == 1;
    for (std::int64_t k = 0; k < this->Dims[2]; k += round)
    {
      ParallelFor(k, std::min(k + round, this->Dims[2]), across ? 32 : 1,
        [&](std::int64_t first, std::int64_t last) { this->Piece(first, last); });
      ReportProgress(progress, double(std::min(k + round, this->Dims[2])) / double(this->Dims[2]));
    }
    return this->Digests;
  }

private:
  void Piece(std::int64_t first, std::int64_t last)
  {
    const std::size_t inSlice = static_cast<std::size_t>(this->Dims[0] * this->Dims[1]);
    const bool asStored = std::is_same_v<As, T> && std::is_same_v<T, std::int16_t> &&
                          this->Stride[0] == 1 && this->Stride[1] == this->Dims[0];
    std::vector<As> samples(asStored ? 0 : inSlice * static_cast<std::size_t>(last - first));
    if (!asStored)
      this->Gather(first, last, samples.data());
    for (std::int64_t k = first; k < last; ++k)
    {
      const void* slice =
        asStored ? static_cast<const void*>(this->Grid.data + this->First + k * this->Stride[2])
                 : samples.data() + std::size_t(k - first) * inSlice;
      this->Digests[k] = Sha256(slice, inSlice * sizeof(As));
    }
  }

  void Gather(std::int64_t first, std::int64_t last, As* into) const
  {
    const std::int64_t inSlice = this->Dims[0] * this->Dims[1], count = last - first;
    for (std::int64_t j = 0; j < this->Dims[1]; ++j)
      for (std::int64_t i = 0; i < this->Dims[0]; ++i)
      {
        const T* from = this->Grid.data + this->First + i * this->Stride[0] + j * this->Stride[1] +
                        first * this->Stride[2];
        As* to = into + j * this->Dims[0] + i;
        for (std::int64_t k = 0; k < count; ++k)
          to[k * inSlice] = static_cast<As>(from[k * this->Stride[2]]) + As(0); // -0.0 is 0
      }
  }

  GridView<const T> Grid;
  std::int64_t Dims[3];
  std::ptrdiff_t Stride[3], First = 0; ///< in samples
  std::vector<Digest> Digests;
};

template <typename T>
std::string Hash(const GridView<const T>& grid, const ProgressFunction& progress)
{
  const bool whole = AreInt16(grid);
  const auto place = CanonicalPlace(grid.geometry);
  std::string all = whole ? "hasp volume 1 int16 " : "hasp volume 1 float32 ";
  all.append(reinterpret_cast<const char*>(place.data()), sizeof(place));
  const auto add = [&](const std::vector<Digest>& digests)
  { all.append(reinterpret_cast<const char*>(digests.data()), digests.size() * sizeof(Digest)); };
  if (whole)
    add(SliceDigests<std::int16_t, T>(grid).Run(progress));
  else
    add(SliceDigests<float, T>(grid).Run(progress));
  std::string text;
  for (const unsigned char byte : Sha256(all.data(), all.size()))
  {
    text += "0123456789abcdef"[byte >> 4];
    text += "0123456789abcdef"[byte & 15];
  }
  return text;
}

} // namespace

std::string VolumeHash(const AnyGridView& grid, const ProgressFunction& progress)
{
  return std::visit([&](const auto& view) { return Hash(view, progress); }, grid);
}
#else
std::string VolumeHash(const AnyGridView&, const ProgressFunction&)
{
  return {};
}
#endif

} // namespace hasp
