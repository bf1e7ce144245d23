#pragma once
#include "Planning/Osteotomy.h"

#include <array>

/// A blade by the handles that a pointer drags it by. Pure; any thread; world mm.
namespace hasp
{

enum class BladeHandle
{
  Middle, ///< shifts it in its plane
  Normal, ///< shifts it along its normal
  Corner0,
  Corner1,
  Corner2,
  Corner3 ///< corners turn it about its middle
};
inline constexpr std::array BladeHandleList{ BladeHandle::Middle, BladeHandle::Normal,
  BladeHandle::Corner0, BladeHandle::Corner1, BladeHandle::Corner2, BladeHandle::Corner3 };

/// Where a handle is: corners go around the blade; that of the normal is a quarter of the blade's
/// shorter side off its middle, 5 mm at least.
glm::dvec3 HandlePlace(const Osteotomy& blade, BladeHandle handle);

/// What a pixel of a view looks along; direction unit, into the picture.
struct PointerRay
{
  glm::dvec3 origin{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, 1.0 };
};

/// The blade after a drag of a handle, as it was pressed until now.
///
/// start      when the handle was pressed
/// from, to   the pointer then and now
/// Shifted, what was pressed stays under the pointer; where the blade, or its normal, is seen so
/// much from its edge that a pixel is worth more than ten times as much along it as across the
/// view, it goes by what it is seen to go. Turned, the corner stays on the ball that it was on,
/// under the pointer or, beyond the ball's rim, next to it. Sizes and kerf stay.
Osteotomy DraggedBlade(
  const Osteotomy& start, BladeHandle handle, const PointerRay& from, const PointerRay& to);

} // namespace hasp
