#pragma once
#include "Devices/HeadPose.h"

#include <cstdint>
#include <memory>

namespace hasp
{

/// A tracker behind somebody else's shared library: HeadPosePlugin.h says how to write one.
///
/// The library is code that runs in this process; load only what the user names. What it says is
/// not believed: ages and poses out of range leave the view as it is, with a warning once a kind.
///
/// Threads: as HeadPoseSource; what the plugin starts is its own.
/// Cost: dlopen at construction, one call of the plugin a frame.
class PluginHeadPose : public HeadPoseSource
{
public:
  /// file      the library; a name without a slash is one in the current folder, never searched for
  /// settings  for the plugin, as its maker documents it; may be empty
  /// Throws std::runtime_error if there is no such file, it is no library that can be loaded, lacks
  /// the symbol, is of another version, or cannot open its tracker; says which and what to do.
  explicit PluginHeadPose(const std::string& file, const std::string& settings = {});
  ~PluginHeadPose() override; ///< closes the tracker, unloads the library

  /// What the plugin calls its tracker, anything but printable ASCII as question marks. Text of
  /// somebody else: for the user's eyes, not for logs.
  const std::string& TrackerName() const noexcept { return this->Tracker; }

  std::optional<TimedHeadPose> Latest(double nowS) override;
  const char* Name() const noexcept override { return "plugin"; }
  std::vector<std::string> TakeWarnings() override;

private:
  class Library;
  enum Fault
  {
    BadAge,
    NotFinite,
    TooFar,
    NotUnit,
    BadAnswer,
    Lost,
    Faults
  };
  void Note(Fault fault);

  std::unique_ptr<Library> Loaded;
  std::string Tracker;
  std::optional<TimedHeadPose> Newest;
  std::uint64_t Counts[Faults] = {};
  bool Warned[Faults] = {};
};

} // namespace hasp
