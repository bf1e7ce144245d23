#include "Haptics/ShellDisc.h"

namespace hasp
{

std::uint32_t CopyDiscs(
  const ContactPoints& points, std::uint32_t level, std::span<ShellDisc> out) noexcept
{
  std::uint32_t copied = 0;
  for (std::uint32_t n = 0; n < points.count && copied < out.size(); ++n)
    if (points.x[n] != ContactPoints::FarAway)
      out[copied++] = { { points.x[n], points.y[n], points.z[n] },
        points.areas ? points.areas[n] : points.area, { points.nx[n], points.ny[n], points.nz[n] },
        level };
  return copied;
}

} // namespace hasp
