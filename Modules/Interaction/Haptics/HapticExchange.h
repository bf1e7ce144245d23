#ifndef HapticExchange_h
#define HapticExchange_h

#include "Devices/HapticDevice.h" // for DeviceStatus
#include "Haptics/HapticStep.h"   // for settings
#include "Haptics/ShellDisc.h"    // for discs

#include <array>    // for isovalues
#include <cstdint>  // for counts
#include <limits>   // for NaN
#include <memory>   // for scenes
#include <optional> // for starts
#include <vector>   // for discs

/// What RENDER and HAPTIC tell each other. All of it mm, N, N mm, radians.
namespace hasp
{

/// RENDER to HAPTIC, the newest wins: what may change while ticks go on. Slewed in the tick, so
/// that no change of it is felt as a knock; after axes that turn by more than 0.1 at once, or a
/// scale that changes by more than a quarter, forces grow from zero. Contact and spring that
/// WrongIn names, and axes and scales that WorkspaceMapping refuses, stay as they were.
struct HapticControl
{
  ContactSettings contact{};
  CouplingSpring spring{}; ///< wanted; SpringFor makes of it what the device stands
  bool attract = false;    ///< Snap-to-fit
  int levels = 99;         ///< of static shells, at most; >= 1
  /// Device to world: the camera's, so that right is right. Taken when they change.
  glm::dquat axes{ 1, 0, 0, 0 };
  double scale = 1.0;       ///< world mm for a mm of the device
  std::uint32_t clutch = 0; ///< buttons, as bits: while one is held the tool stays
  bool clutched = false;    ///< the same, said by RENDER (a key)
  /// Where the device stands in the world, its axes too: taken when `placed` changes, and the tool
  /// jumps.
  RigidPose place{};
  std::uint32_t placed = 0;
  /// Of the scene's shells, those that are dynamic; NaN: as it is.
  static constexpr std::size_t MostIsovalues = 8;
  std::array<double, MostIsovalues> isovalues = []
  {
    std::array<double, MostIsovalues> none{};
    none.fill(std::numeric_limits<double>::quiet_NaN());
    return none;
  }();
};

/// HAPTIC to RENDER, the newest wins: one tick, as it went.
struct HapticSnapshot
{
  std::uint64_t ticks = 0; ///< made so far, this one included
  std::int64_t nowNs = 0;
  DeviceStatus status = DeviceStatus::NotHomed;
  std::uint32_t buttons = 0;
  RigidPose raw{};    ///< the device as it said; device axes
  RigidPose device{}; ///< the same in the world: where the hand wants the tool
  RigidPose tool{};   ///< where the contacts let it be; world
  Wrench onDevice{};  ///< sent to the motors, before the device's own limits; device axes
  Wrench felt{};      ///< the same in the world, about the device's point; unscaled
  Wrench contact{}, attraction{}; ///< on the tool; world, about its origin
  double contactAreaMm2 = 0.0, attractedAreaMm2 = 0.0;
  double deepestMm = 0.0; ///< the least distance felt: negative inside, 0 without contact
  double levels = 0.0;
  std::uint32_t contacts = 0, points = 0;
  std::uint32_t stepStatus = 0; ///< CouplingTick::Status
  std::uint64_t scene = 0;      ///< number of the scene that was touched; 0: none yet
  std::uint64_t away = 0;       ///< ticks in which the device took no force
};

/// RENDER to HAPTIC and back: the scene before comes back in it.
struct HapticSceneOffer
{
  std::unique_ptr<HapticScene> scene; ///< not null: where nothing can be touched it has no bodies
  std::optional<RigidPose> start;     ///< a tool is taken in hand here (world); none: it goes on
  std::uint64_t number = 0;
};

/// RENDER to HAPTIC and back: filled with the dynamic shells' points, tool axes.
struct HapticDiscRequest
{
  std::vector<ShellDisc> room; ///< its size is the most that is copied: 32 bytes and 8 ns each
  std::uint32_t count = 0;
  RigidPose tool{}; ///< where it was then
};

} // namespace hasp

#endif
