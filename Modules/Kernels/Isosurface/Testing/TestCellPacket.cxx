// Rays side by side against rays by themselves: the same bits, in every instruction set there is.
#include "Isosurface/CellPacket.h"
#include "Isosurface/Testing/TracedVolume.h"

#if HASP_WITH_HIGHWAY
#include <hwy/targets.h>
#endif

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <numeric>

namespace
{

using hasp::CellPacket;
using hasp::PacketRays;

/// Runs the body once for each instruction set that Hasp was compiled for and this CPU has.
void ForEachInstructionSet(const std::function<void()>& body)
{
#if HASP_WITH_HIGHWAY
  std::int64_t left = hwy::SupportedTargets();
  while (left != 0)
  {
    const std::int64_t target = left & -left; // the lowest bit is the widest set
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    body();
    left &= left - 1;
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
#else
  body();
#endif
}

/// Cells as walks read them, a box for all of each cluster.
struct Store
{
  std::shared_ptr<const hasp::ClusteredCells> cells;
  std::vector<hasp::CellBox> boxes;
  hasp::CellStore store;

  explicit Store(std::shared_ptr<const hasp::ClusteredCells> from) : cells(std::move(from))
  {
    const glm::ivec3 last = this->cells->geometry.Cells() - 1;
    std::uint32_t number = 0;
    for (const hasp::CellCluster& cluster : this->cells->clusters)
    {
      const glm::ivec3 first = cluster.Origin();
      this->boxes.emplace_back(first, glm::min(first + 7, last), number++);
    }
    this->store = { hasp::ChooseCellWalk(this->cells->cornerType, this->cells->precision),
      this->cells->clusters.data(), this->cells->corners.data(), this->boxes.data(),
      this->cells->isovalue, {} };
    for (int code = 0; code < 256 && !this->cells->levels.empty(); ++code)
      this->store.levels.push_back(
        code & 128 ? -this->cells->levels[code & 127] : this->cells->levels[code & 127]);
  }
};

std::vector<Store> AllKinds()
{
  const glm::ivec3 dims(21, 19, 18);
  std::vector<Store> stores;
  stores.emplace_back(hasp::testing::Noise<std::int16_t>(dims, 1).cells);
  stores.emplace_back(hasp::testing::Noise<std::uint16_t>(dims, 2).cells);
  stores.emplace_back(hasp::testing::Noise<float>(dims, 3).cells);
  stores.emplace_back(
    hasp::testing::Noise<std::int16_t>(dims, 4, hasp::CellPrecision::Compact).cells);
  for (const float scale : { 1e-33F, 1e36F }) // corners that are scaled before the root
  {
    auto samples = hasp::testing::Noise<float>(dims, 5).samples;
    for (float& v : samples)
      v = (v - 99.5F) * scale;
    const hasp::GridGeometry g = hasp::testing::Cube(dims);
    stores.emplace_back(hasp::testing::TracedVolume<float>(std::move(samples), g, 0.0).cells);
  }
  // Smooth: long ways without a surface, and cubics that rise or fall all the way.
  std::vector<std::int16_t> ball;
  for (int n = 0; n < dims.x * dims.y * dims.z; ++n)
  {
    const glm::vec3 p(n % dims.x, n / dims.x % dims.y, n / dims.x / dims.y);
    ball.push_back(static_cast<std::int16_t>(100 * (7 - glm::distance(p, glm::vec3(10, 9, 9)))));
  }
  stores.emplace_back(
    hasp::testing::TracedVolume<std::int16_t>(std::move(ball), hasp::testing::Cube(dims), 0.5)
      .cells);
  return stores;
}

/// Rays of a packet through a volume, of every sort.
class RayMaker
{
public:
  RayMaker(const glm::ivec3& cells, unsigned seed) : Random(seed), Size(cells) {}

  PacketRays Next()
  {
    PacketRays rays;
    const int sort = this->Integer(0, 4);
    const glm::dvec3 eye = this->Point(1.0), middle = this->Point(0.0);
    for (int n = 0; n < CellPacket::Size; ++n)
    {
      const glm::dvec3 beside(0.3 * (n % 4), 0.3 * (n / 4), 0.1 * n);
      hasp::CellRay ray{ this->Point(0.3), this->Point(0.3) - this->Point(0.3) }; // anyhow
      if (sort == 0)                                                              // of a picture
        ray = { eye, middle + beside - eye };
      else if (sort == 1) // parallel, along an axis: two components are 0, of either sign
      {
        const int axis = this->Integer(0, 2);
        ray.origin = middle + beside;
        ray.direction = glm::dvec3(n % 2 ? 0.0 : -0.0);
        ray.direction[axis] = n % 3 ? 1.0 : -2.0;
        ray.origin[axis] = n % 3 ? -1.0 : this->Size[axis] + 1.0;
      }
      else if (sort == 2) // in faces, along edges, through corners of cells
      {
        const auto lattice = [&] { return glm::floor(2.0 * this->Point(0.0)) / 2.0; };
        ray.origin = lattice();
        ray.direction = lattice() - ray.origin;
      }
      if (sort == 3 && n % 3 == 0)
        ray.direction *= n % 2 ? 1e-180 : 1e180; // squares vanish or overflow
      if (n % 5 == 1)
        ray.tMax = 0.6;
      this->Spoil(ray);
      rays.Set(n, ray);
    }
    return rays;
  }

  CellPacket::Rays Some()
  {
    const int sort = this->Integer(0, 3);
    return sort == 0   ? CellPacket::All
           : sort == 1 ? 1U << this->Integer(0, CellPacket::Size - 1)
                       : static_cast<CellPacket::Rays>(this->Integer(0, CellPacket::All));
  }
  int Integer(int least, int most)
  {
    return std::uniform_int_distribution<int>(least, most)(this->Random);
  }
  std::mt19937& Engine() { return this->Random; }

private:
  glm::dvec3 Point(double around)
  {
    std::uniform_real_distribution<double> at(-around, 1.0 + around);
    const double x = at(this->Random), y = at(this->Random), z = at(this->Random);
    return glm::dvec3(x, y, z) * this->Size;
  }
  /// One in 50 is no ray.
  void Spoil(hasp::CellRay& ray)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    switch (this->Integer(0, 349))
    {
      case 0:
        ray.origin.y = std::nan("");
        break;
      case 1:
        ray.origin.z = -infinity;
        break;
      case 2:
        ray.direction = glm::dvec3(0.0);
        break;
      case 3:
        ray.direction.x = std::nan("");
        break;
      case 4:
        ray.direction.y = infinity;
        break;
      case 5:
        ray.tMax = -1.0;
        break;
      case 6:
        ray.tMin = std::nan("");
        break;
      default:;
    }
  }
  std::mt19937 Random;
  glm::dvec3 Size;
};

/// The rows of both that count are equal in every bit, for these rays.
template <typename T>
void ExpectSame(
  const T* one, const T* other, std::size_t rows, CellPacket::Rays rays, const char* what)
{
  for (std::size_t r = 0; r < rows; ++r)
    for (int n = 0; n < CellPacket::Size; ++n)
    {
      const T &a = one[r * CellPacket::Size + n], &b = other[r * CellPacket::Size + n];
      const bool same = (rays >> n & 1U) == 0 || std::memcmp(&a, &b, sizeof(T)) == 0;
      ASSERT_TRUE(same) << what << ' ' << r << ", ray " << n << ": " << a << " and " << b;
    }
}

void ExpectSame(const CellPacket& one, const CellPacket& other, CellPacket::Rays rays)
{
  ExpectSame(one.origin[0], other.origin[0], 3, rays, "origin");
  ExpectSame(one.direction[0], other.direction[0], 3, rays, "direction");
  ExpectSame(one.inverse[0], other.inverse[0], 3, rays, "inverse");
  ExpectSame(one.end, other.end, 1, rays, "end");
  ExpectSame(one.directionF[0], other.directionF[0], 3, rays, "direction, float");
  ExpectSame(one.inverseF[0], other.inverseF[0], 3, rays, "inverse, float");
  ExpectSame(one.delta[0], other.delta[0], 3, rays, "delta");
  ExpectSame(one.t, other.t, 1, rays, "t");
  CellPacket::Rays hits = 0;
  for (int n = 0; n < CellPacket::Size; ++n)
    hits |= CellPacket::Rays(one.t[n] < std::numeric_limits<double>::infinity()) << n;
  hits &= rays;
  ExpectSame(one.cluster, other.cluster, 1, rays, "cluster");
  ExpectSame(one.place, other.place, 1, hits, "place");
  ExpectSame(one.corners[0], other.corners[0], 8, hits, "corner");
  ExpectSame(one.local[0], other.local[0], 3, hits, "local");
}

struct Counts
{
  int hits = 0, again = 0, ties = 0;
};

/// Both ways through all boxes in some order.
void WalkBoth(const Store& scene, const std::vector<std::uint32_t>& order, CellPacket::Rays some,
  CellPacket& packet, CellPacket& single, int& hits)
{
  const hasp::CellPacketWalk walk =
    hasp::ChooseCellPacketWalk(scene.cells->cornerType, scene.cells->precision);
  for (const std::uint32_t box : order)
  {
    const CellPacket::Rays nearer = walk(scene.store, box, some, packet);
    ASSERT_EQ(nearer, hasp::singly::Walk(scene.store, box, some, single)) << "box " << box;
    hits += std::popcount(nearer);
  }
  ExpectSame(packet, single, some);
}

/// Starts rays from the surface where the last were met.
PacketRays LeaveSurface(const Store& scene, const CellPacket& packet, RayMaker& make)
{
  PacketRays rays = make.Next();
  for (int n = 0; n < CellPacket::Size; ++n)
    if (packet.t[n] < std::numeric_limits<double>::infinity())
      for (int axis = 0; axis < 3; ++axis)
        rays.origin[axis][n] = scene.cells->clusters[packet.cluster[n]].Origin()[axis] +
                               (packet.place[n] >> 3 * axis & 7) + double(packet.local[axis][n]);
  return rays;
}

void ExpectSameAsSingly(const Store& scene, unsigned seed, int packets, Counts& counts)
{
  const glm::ivec3 volume = scene.cells->geometry.Cells();
  RayMaker make(volume, seed);
  std::vector<std::uint32_t> order(scene.boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  CellPacket last{};
  std::fill(last.t, last.t + CellPacket::Size, std::numeric_limits<double>::infinity());
  for (int p = 0; p < packets; ++p)
  {
    const bool fromSurface = p % 3 == 2;
    const PacketRays rays = fromSurface ? LeaveSurface(scene, last, make) : make.Next();
    CellPacket packet{}, single{};
    CellPacket::Rays some = hasp::BeginCellPacket(rays, volume, packet);
    ASSERT_EQ(some, hasp::singly::Begin(rays, CellPacket::All, volume, single));
    ExpectSame(packet, single, some);
    if (fromSurface)
    {
      packet.fromSurface = single.fromSurface = make.Some();
      packet.startInside = single.startInside = make.Some();
    }
    some &= make.Some();
    std::shuffle(order.begin(), order.end(), make.Engine());
    ASSERT_NO_FATAL_FAILURE(WalkBoth(scene, order, some, packet, single, counts.hits));

    // The same hit again counts only for a cluster of smaller number.
    CellPacket tied = packet;
    for (int n = 0; n < CellPacket::Size; ++n)
      tied.cluster[n] = std::max(tied.cluster[n] + make.Integer(-1, 1), 0);
    CellPacket tiedSingle = tied;
    ASSERT_NO_FATAL_FAILURE(WalkBoth(scene, order, some, tied, tiedSingle, counts.ties));

    hasp::CellPixels pixels, singlePixels;
    const glm::dmat4 toClip =
      glm::perspective(0.6, 1.0, 5.0, 90.0) *
      glm::lookAt(glm::dvec3(40, 50, 60), glm::dvec3(9), glm::dvec3(0, 0, 1));
    CellPacket::Rays hits = 0;
    for (int n = 0; n < CellPacket::Size; ++n)
      hits |= CellPacket::Rays(packet.t[n] < std::numeric_limits<double>::infinity()) << n;
    hasp::EndCellPacket(scene.store, packet, hits & some, toClip, pixels);
    hasp::singly::End(scene.store, packet, hits & some, toClip, singlePixels);
    ASSERT_EQ(std::memcmp(&pixels, &singlePixels, sizeof pixels), 0);
    last = packet;
  }
}

TEST(CellPacket, WalksAsRaysDoByThemselves)
{
  const auto stores = AllKinds();
  ForEachInstructionSet(
    [&]
    {
      for (std::size_t kind = 0; kind < stores.size(); ++kind)
      {
        SCOPED_TRACE(kind);
        Counts counts;
        ASSERT_NO_FATAL_FAILURE(ExpectSameAsSingly(stores[kind], 7 + unsigned(kind), 200, counts));
        EXPECT_GT(counts.hits, 500);
        EXPECT_GT(counts.ties, 100);
      }
    });
}

TEST(CellPacket, PixelsAreThoseOfPictureRays)
{
  ForEachInstructionSet(
    []
    {
      hasp::PictureView view{ glm::perspective(0.6, 1.0, 5.0, 90.0) *
                                glm::lookAt(
                                  glm::dvec3(40, 50, 60), glm::dvec3(9), glm::dvec3(0, 0, 1)),
        { 63, 41 }, { glm::dvec4(-1, 0.2, 0, 12), glm::dvec4(0, 0, 0, 1) } };
      const auto compare = [&]
      {
        const hasp::PictureRays picture(view);
        for (int y = 0; y < view.size.y; y += 4)
          for (int x = 0; x < view.size.x; x += 4)
          {
            PacketRays one, other;
            const auto some = hasp::PixelsOfPacket(picture, { x, y }, one);
            ASSERT_EQ(some, hasp::singly::Pixels(picture, { x, y }, other));
            ExpectSame(one.origin[0], other.origin[0], 3, some, "origin");
            ExpectSame(one.direction[0], other.direction[0], 3, some, "direction");
            ExpectSame(one.tMin, other.tMin, 1, some, "tMin");
            ExpectSame(one.tMax, other.tMax, 1, some, "tMax");
          }
      };
      compare();
      view.planes.emplace_back(0, 0, 0, -1); // leaves nothing
      compare();
      view.planes.clear();
      view.indexToClip = glm::ortho(-30.0, 30.0, -30.0, 30.0, 1.0, 300.0);
      compare();
    });
}

} // namespace
