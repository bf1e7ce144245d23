#pragma once
#include "Grid/RigidPose.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// What the Haply Inverse Service says and hears: JSON, one message at a time. From public sources
/// (its maker's pages for service 3.1 to 3.5, and programs that talk to it); no device was at hand.
///
/// The service counts in metres and newtons, right-handed, x to the user's right, y forward (away
/// from the user), z up. Device axes (HapticDevice.h) are (x, z, -y) of those, in mm; turns follow.
namespace hasp
{

/// What one message says of one Inverse3 and of the grip at its end.
struct HaplyState
{
  std::string deviceId;    ///< what commands are for; 1 to 64 bytes. No text for logs
  glm::dvec3 positionMm{}; ///< device axes; from where the service counts: see centred. Within 2 m
  bool centred = false;    ///< counted from the workspace's middle, not from the device's base
  bool turnedAxes = false; ///< the service was told to use other axes: positionMm is wrong
  std::optional<bool> calibrated;        ///< nothing: this message does not say
  std::optional<glm::dquat> orientation; ///< device axes, unit; nothing: there is no grip awake
  std::uint32_t buttons = 0;             ///< bits 0, 1, 2: a, b, c of the grip; 0 without one
};

/// Reads `inverse3[].state.cursor_position`, `wireless_verse_grip[0].state.orientation` and
/// `.buttons` (without one of those `verse_grip[0]`, whose one `button` is bit 0), and, where they
/// are, `inverse3[].status.calibrated`, `.config.preset` and `.config.basis.permutation`.
///
/// deviceId  the Inverse3 that is meant; empty: the first
/// Gives nothing where the message has no such device. Throws std::invalid_argument if it is no
/// JSON (which has no NaN and no infinity), a key that is read is missing or of another type, a
/// position is further than 2 m away, or an orientation's length is not 1 within 0.01; says which,
/// in words of our own. Keys that are not read may be anything. All zeros is no orientation: a grip
/// asleep. Limit: the first grip is the one; with two hands there is no telling which arm holds it.
/// Any thread. Time and memory as the text's length: some 20 us for a message of 2 kB.
std::optional<HaplyState> ReadHaplyState(std::string_view text, std::string_view deviceId = {});

/// The command that sets the force that the hand feels: device axes, N; it holds until the next.
/// Throws std::invalid_argument if that is not finite, or if deviceId is no UTF-8.
std::string WriteHaplyForce(std::string_view deviceId, const glm::dvec3& forceN);

} // namespace hasp
