#include "Devices/PluginHeadPose.h"

#include "Devices/HeadPosePlugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double MostAgeS = 10.0;
constexpr std::size_t MostName = 63;

[[noreturn]] void Refuse(const std::string& why)
{
  throw std::runtime_error("head pose plugin: " + why);
}

struct Unload
{
  void operator()(void* handle) const { dlclose(handle); }
};

std::string PrintableName(const char* name)
{
  if (!name)
    return {};
  std::string text(name, strnlen(name, MostName));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}
} // namespace

/// The library, its table and its session, undone in the opposite order.
class PluginHeadPose::Library
{
public:
  Library(const std::string& file, const std::string& settings)
  {
    std::error_code error;
    const auto path = std::filesystem::absolute(file, error); // with a slash: dlopen searches not
    if (error || !std::filesystem::is_regular_file(path, error))
      Refuse("there is no such file");
    // dlerror's text names files, so it is not passed on.
    this->Handle.reset(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
    if (!this->Handle)
      Refuse("the file is no shared library that can be loaded here; ldd says whether it is one"
             " for this machine and which of its own libraries are missing");
    const auto entry = reinterpret_cast<HaspGetHeadPosePluginFunction>(
      dlsym(this->Handle.get(), HASP_HEAD_POSE_PLUGIN_ENTRY));
    if (!entry)
      Refuse("the library has no function " HASP_HEAD_POSE_PLUGIN_ENTRY
             "; it is no plugin, or its symbols are hidden");
    this->Table = entry();
    this->CheckTable();
    this->Session = this->Table->open(settings.c_str());
    if (!this->Session)
      Refuse(
        "the plugin could not open its tracker; is it plugged in, and are the settings right?");
  }
  ~Library()
  {
    if (this->Session)
      this->Table->close(this->Session);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  const char* Name() const { return this->Table->name; }
  int Poll(double nowS, HaspHeadPoseSample& sample) const
  {
    return this->Table->poll(this->Session, nowS, &sample);
  }

private:
  void CheckTable() const
  {
    if (!this->Table)
      Refuse("the plugin gives no table");
    // Size and version stand first in every version.
    if (this->Table->version != HASP_HEAD_POSE_PLUGIN_VERSION)
      Refuse("the plugin is of version " + std::to_string(this->Table->version) +
             ", this Hasp loads version " + std::to_string(HASP_HEAD_POSE_PLUGIN_VERSION) +
             "; compile it with this Hasp's HeadPosePlugin.h");
    if (this->Table->size < sizeof(HaspHeadPosePlugin))
      Refuse("the plugin's table has " + std::to_string(this->Table->size) + " bytes, must be " +
             std::to_string(sizeof(HaspHeadPosePlugin)) + " or more");
    if (!this->Table->open || !this->Table->poll || !this->Table->close)
      Refuse("the plugin's table lacks open, poll or close");
  }

  std::unique_ptr<void, Unload> Handle;
  const HaspHeadPosePlugin* Table = nullptr;
  void* Session = nullptr;
};

PluginHeadPose::PluginHeadPose(const std::string& file, const std::string& settings)
  : Loaded(std::make_unique<Library>(file, settings)),
    Tracker(PrintableName(this->Loaded->Name()))
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
