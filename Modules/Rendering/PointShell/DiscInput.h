#ifndef DiscInput_h
#define DiscInput_h

#include "Haptics/ShellDisc.h"

#include <memory>
#include <string>
#include <vector>

namespace hasp
{
class PointShell;
}
class vtkPolyData;

using Discs = std::vector<hasp::ShellDisc>;

/// Data coordinates; none: high < low.
struct DiscBounds
{
  glm::dvec3 low{ 1.0 }, high{ -1.0 };
  bool Any() const { return this->low.x <= this->high.x; }
};

/// The first `levels` levels, 0: all. Each disc has the area that a point stands for when the last
/// of them is drawn.
std::shared_ptr<const Discs> DiscsOfShell(const hasp::PointShell& shell, int levels);

/// See vtkHaspPointShellMapper.h. Throws std::invalid_argument.
std::shared_ptr<const Discs> DiscsOfPoints(vtkPolyData* points, const std::string& areaArray);

/// Holds each disc, as large as drawn. Throws std::invalid_argument if one is not finite, a normal
/// not unit within 1 % or an area negative.
DiscBounds CheckDiscs(const Discs& discs, double overlap);

#endif
