#include "View/SliceAxis.h"

#include <QCoreApplication>

#include <glm/common.hpp>

namespace hasp
{

const SliceFrame& FrameOf(SliceAxis axis)
{
  static const std::array<SliceFrame, 3> frames{
    SliceFrame{ { 1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 }, { 0, 0, 1 }, 2, QColor(0xf0, 0x4d, 0x3e) },
    SliceFrame{ { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 }, { 0, -1, 0 }, 1, QColor(0x5f, 0xc2, 0x5f) },
    SliceFrame{ { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 0, 0 }, 0, QColor(0xed, 0xd5, 0x4c) }
  };
  return frames.at(std::size_t(axis));
}

QString SideLetter(const glm::dvec3& direction)
{
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const bool negative = direction[axis] < 0.0;
  switch (axis)
  {
    case 0:
      return negative ? QCoreApplication::translate("Orientation", "R", "right side")
                      : QCoreApplication::translate("Orientation", "L", "left side");
    case 1:
      return negative ? QCoreApplication::translate("Orientation", "A", "anterior")
                      : QCoreApplication::translate("Orientation", "P", "posterior");
    default:
      return negative ? QCoreApplication::translate("Orientation", "I", "inferior")
                      : QCoreApplication::translate("Orientation", "S", "superior");
  }
}

} // namespace hasp
