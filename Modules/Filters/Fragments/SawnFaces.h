#pragma once
#include "FragmentImage.h"
#include "Grid/GridView.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace hasp
{

/// Grey values of a type on either side of an isovalue, of which value >= isovalue is inside.
template <typename T>
class GreySide
{
public:
  explicit GreySide(double isovalue) : Isovalue(isovalue)
  {
    double below = std::ceil(isovalue) - 1.0; // the largest of T that is
    if constexpr (!std::is_integral_v<T>)
    {
      below = T(isovalue);
      if (below >= isovalue)
        below = std::nextafter(T(isovalue), std::numeric_limits<T>::lowest());
    }
    this->MostBelow = std::max(below, Least);
  }
  bool IsInside(double value) const { return value >= this->Isovalue; }
  /// The nearest of T that is outside.
  T Below(double value) const { return T(std::clamp(value, Least, this->MostBelow)); }
  /// What is inside, as far outside.
  T Mirrored(T value) const
  {
    return this->IsInside(double(value)) ? this->Below(2.0 * this->Isovalue - double(value))
                                         : value;
  }
  /// So much above the isovalue; inside, and no more than `most`, which is.
  T Inside(T most, double above) const
  {
    double value = this->Isovalue + above;
    if constexpr (std::is_integral_v<T>)
      value = std::max(std::round(value), std::ceil(this->Isovalue));
    T is = T(std::min(value, double(most)));
    if (!this->IsInside(double(is))) // rounding of float
      is = std::nextafter(is, most);
    return is;
  }

private:
  static constexpr double Least = std::numeric_limits<T>::lowest();
  double Isovalue, MostBelow;
};

/// Where a fragment's image lies in its scan, and one of the boxes that it was cut by.
struct SawnImage
{
  glm::ivec3 first{ 0 }; ///< the scan's sample that is the image's first
  std::uint16_t label = 0;
  double isovalue = 0.0;
  const SawnBox& box;
};

/// Makes the isosurface of an image the faces of a box, where bone is missing in it: see
/// FragmentImage.h. Any thread; O(samples near the box).
template <typename Sample, typename T>
void FlattenFaces(const GridView<Sample>& image, const GridView<const T>& grey,
  const GridView<const std::uint16_t>& labels, const SawnImage& where);

} // namespace hasp
