#include "Benchmark/DynamicTicks.h"
#include "Haptics/ContactForce.h"
#include "Haptics/DynamicPointShell.h"
#include "Testing/SampledDistance.h"

#include <cmath>
#include <ctime>

namespace ticks::HASP_TICKS
{
namespace
{

using namespace hasp;
using namespace hasp::testing;

double ProcessorMicroseconds()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

const ContactKernels& Kernels()
{
#if HASP_WITH_HIGHWAY
  return FastestContactKernels();
#else
  static const ContactKernels scalar = ScalarContactKernels();
  return scalar;
#endif
}

class Balls : public Runner
{
public:
  explicit Balls(int samples)
    : Samples(samples),
      Field(std::make_shared<SampledDistance>(
        BumpyBall(0.35 * samples, 0.02 * samples), CubeGrid(samples))),
      Map(std::make_shared<DistanceMap>(this->Field->View())),
      Shell(this->Volume(), this->Map, {})
  {
  }

  Tick Run(Way way, int n) override
  {
    const double turns = way == Way::Jumps ? 1.3 * (n / 12) : 0.0;
    const double angle = turns + (way == Way::Along ? 0.1 / (0.69 * this->Samples) * n : 0.0);
    const RigidPose pose{ 0.69 * this->Samples * glm::dvec3(std::cos(angle), std::sin(angle), 0.0),
      TurnBy({}) };
    if (way == Way::Isovalue)
      this->Shell.SetIsovalue(n % 2 == 0 ? 0.05 : 0.0);
    Tick tick;
    const double begin = ProcessorMicroseconds();
    this->Shell.Update(pose, 0.0);
    const double between = ProcessorMicroseconds();
    ContactSums sums;
    Kernels()[ContactTerms::Matrix](
      this->Shell.Points(), { pose }, this->Map->View(), { .stiffness = 1.0F }, sums);
    tick.evaluateUs = ProcessorMicroseconds() - between;
    tick.updateUs = between - begin;
    for (int axis = 0; axis < 3; ++axis)
      tick.force[axis] = sums.contact.force[axis];
    tick.points = this->Shell.LastTick().points;
    tick.contacts = sums.contacts;
    return tick;
  }

private:
  ShellVolume Volume() const
  {
    ShellVolume volume;
    volume.grid = this->Field->View();
    volume.blocks = std::make_shared<MinMaxBlocks>(volume.grid);
    volume.owner = this->Field;
    volume.insideAbove = false;
    return volume;
  }

  int Samples;
  std::shared_ptr<SampledDistance> Field;
  std::shared_ptr<const DistanceMap> Map;
  DynamicPointShell Shell;
};

} // namespace

std::unique_ptr<Runner> Make(int samples)
{
  return std::make_unique<Balls>(samples);
}

} // namespace ticks::HASP_TICKS
