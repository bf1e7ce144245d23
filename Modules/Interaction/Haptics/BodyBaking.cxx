#include "BodyBaking.h"

#include "Grid/MinMaxBlocks.h"
#include "Haptics/ContactForce.h"
#include "Realtime/SignalsBlocked.h"

#include <chrono>
#include <utility>

namespace hasp
{

BodyBaking::BodyBaking(BakingJob job)
{
  const SignalsBlocked inherited;
  this->Result =
    std::async(std::launch::async, [this, job = std::move(job)] { return this->Bake(job); });
}

BodyBaking::~BodyBaking()
{
  this->Cancel.store(true, std::memory_order_relaxed);
  if (this->Result.valid())
    this->Result.wait();
}

bool BodyBaking::Done() const
{
  return this->Result.valid() &&
         this->Result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

BakedBody BodyBaking::Bake(const BakingJob& job)
{
  const auto part = [this](double from, double to)
  {
    return [this, from, to](double share)
    {
      this->Share.store(from + share * (to - from), std::memory_order_relaxed);
      return !this->Cancel.load(std::memory_order_relaxed);
    };
  };
  BakedBody baked;
  const auto* volume = std::get_if<BakedVolume>(&job.body);
  if (job.shell && job.dynamic && volume != nullptr)
  {
    ShellVolume samples;
    samples.grid = volume->grid;
    samples.blocks = std::make_shared<const MinMaxBlocks>(volume->grid);
    samples.owner = volume->owner;
    samples.isovalue = volume->isovalue;
    baked.dynamic = std::make_shared<const DynamicShellSource>(
      DynamicShellSource{ std::move(samples), job.origin, {} });
  }
  if (job.shell)
    FastestContactKernels(); // times them, once: 5 ms that the first grab would take on RENDER
  const bool shell = job.shell && !baked.dynamic;
  if (!job.map && !shell)
    return baked;
  const BodyDistanceSettings settings{ .spacingMm = job.spacingMm };
  const BodyDistance distance =
    volume != nullptr ? DistanceOfVolume(volume->grid, volume->isovalue, settings, part(0.0, 0.7))
                      : DistanceOfMesh(std::get<TriangleMesh>(job.body), settings, part(0.0, 0.7));
  if (job.map)
    baked.map = std::make_shared<const DistanceMap>(
      distance.View(), DistanceMapSettings{ .origin = job.origin }, part(0.7, 0.8));
  if (shell)
    baked.shell =
      PointShell::OfSurface(distance.View(), job.origin, { .points = job.points }, part(0.8, 1.0));
  return baked;
}

} // namespace hasp
