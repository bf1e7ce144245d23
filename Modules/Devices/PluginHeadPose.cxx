#include "Devices/PluginHeadPose.h"

#include "Devices/HeadPosePlugin.h"
#include "Devices/PluginLibrary.h"

namespace hasp
{

namespace
{
constexpr double MostAgeS = 10.0;
constexpr std::size_t MostName = 63;
constexpr PluginKind Kind{ "head pose plugin", HASP_HEAD_POSE_PLUGIN_ENTRY, "HeadPosePlugin.h",
  HASP_HEAD_POSE_PLUGIN_VERSION };
} // namespace

/// The library, its table and its session, undone in the opposite order.
class PluginHeadPose::Library
{
public:
  Library(const std::string& file, const std::string& settings)
    : Loaded(Kind, file),
      Table(this->Loaded.Get<HaspHeadPosePlugin>())
  {
    if (!this->Table.open || !this->Table.poll || !this->Table.close)
      this->Loaded.Refuse("the plugin's table lacks open, poll or close");
    this->Session = this->Table.open(settings.c_str());
    if (!this->Session)
      this->Loaded.Refuse(
        "the plugin could not open its tracker; is it plugged in, and are the settings right?");
  }
  ~Library() { this->Table.close(this->Session); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  const char* Name() const { return this->Table.name; }
  int Poll(double nowS, HaspHeadPoseSample& sample) const
  {
    return this->Table.poll(this->Session, nowS, &sample);
  }

private:
  PluginLibrary Loaded;
  const HaspHeadPosePlugin& Table;
  void* Session = nullptr;
};

PluginHeadPose::PluginHeadPose(const std::string& file, const std::string& settings)
  : Loaded(std::make_unique<Library>(file, settings)),
    Tracker(PrintableText(this->Loaded->Name(), MostName))
{
}

PluginHeadPose::~PluginHeadPose() = default;

std::optional<TimedHeadPose> PluginHeadPose::Latest(double nowS)
{
  if (this->Counts[Lost] > 0)
    return this->Newest;
  HaspHeadPoseSample sample{};
  sample.size = sizeof sample;
  switch (this->Loaded->Poll(nowS, sample))
  {
    case HASP_HEAD_POSE_NONE:
      return this->Newest;
    case HASP_HEAD_POSE_GIVEN:
      break;
    case HASP_HEAD_POSE_LOST:
      this->Note(Lost);
      return this->Newest;
    default:
      this->Note(BadAnswer);
      return this->Newest;
  }
  const auto& p = sample.positionMm;
  const auto& q = sample.orientation;
  const TimedHeadPose given{ nowS - sample.ageS,
    { { p[0], p[1], p[2] }, { q[0], q[1], q[2], q[3] } } };
  if (!(sample.ageS >= 0.0 && sample.ageS <= MostAgeS))
    this->Note(BadAge);
  else if (const HeadPoseFault fault = FaultOf(given.pose); fault == HeadPoseFault::NotFinite)
    this->Note(NotFinite);
  else if (fault == HeadPoseFault::TooFar)
    this->Note(TooFar);
  else if (fault == HeadPoseFault::NotUnit)
    this->Note(NotUnit);
  else
    this->Newest = given;
  return this->Newest;
}

void PluginHeadPose::Note(Fault fault)
{
  ++this->Counts[fault];
}

std::vector<std::string> PluginHeadPose::TakeWarnings()
{
  static constexpr const char* Texts[Faults] = {
    "poses with an age that is not in [0, 10] s",
    "poses with numbers that are not finite",
    "poses further than 10 m away; are they in mm?",
    "poses whose quaternion is not unit",
    "answers that are none of NONE, GIVEN and LOST",
    "tracker is gone; begin anew when it is back",
  };
  std::vector<std::string> warnings;
  for (int f = 0; f < Faults; ++f)
    if (this->Counts[f] > 0 && !this->Warned[f])
    {
      this->Warned[f] = true;
      warnings.push_back("head pose plugin: " + std::to_string(this->Counts[f]) + " " + Texts[f]);
    }
  return warnings;
}

} // namespace hasp
