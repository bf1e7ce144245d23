#include "Dicom/StoredValues.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace hasp
{
namespace
{

constexpr double Levels = 65535.0;

double Clamped(double sample, const StoredValues& how)
{
  return std::clamp(std::nearbyint((sample - how.intercept) / how.slope), 0.0, Levels);
}

StoredValues ChooseForFloats(const GridView<const float>& grid)
{
  const float *first = grid.data, *last = grid.data + grid.geometry.Size();
  if (!std::all_of(first, last, [](float v) { return std::isfinite(v); }))
    throw std::invalid_argument("volume: has samples that are NaN or infinite; replace them first");
  const auto [least, most] = std::minmax_element(first, last);
  StoredValues how;
  how.intercept = FromDecimalString(DecimalString(*least));
  const bool whole = *most - how.intercept <= Levels && std::all_of(first, last,
                                                          [&](float v)
                                                          {
                                                            const double above = v - how.intercept;
                                                            return above == std::nearbyint(above);
                                                          });
  if (!whole)
  {
    const double step = (double(*most) - double(*least)) / Levels;
    how.slope = FromDecimalString(DecimalString(step));
    if (!(how.slope > 0.0) || !std::isfinite(how.slope))
      how.slope = 1.0; // all but equal: rounded to one value
  }
  for (const float* v = first; v != last; ++v) // as a reader computes it
    how.error = std::max(how.error,
      std::abs(double(*v) - double(float(how.slope * Clamped(*v, how) + how.intercept))));
  return how;
}

} // namespace

std::string DecimalString(double value)
{
  for (int digits = std::numeric_limits<double>::max_digits10; digits > 0; --digits)
  {
    char text[40];
    const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
    if (end.ptr - text <= 16)
      return { text, end.ptr };
  }
  throw std::logic_error("a number that no 16 characters hold"); // one digit always fits
}

double FromDecimalString(const std::string& text)
{
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

StoredValues ChooseStoredValues(const AnyGridView& grid)
{
  return std::visit(
    [](const auto& view)
    {
      using Sample = std::remove_cv_t<std::remove_pointer_t<decltype(view.data)>>;
      if constexpr (std::is_same_v<Sample, float>)
        return ChooseForFloats(view);
      else
        return StoredValues{ std::is_signed_v<Sample>, 1.0, 0.0, 0.0 };
    },
    grid);
}

void StoreSlice(
  const AnyGridView& grid, const StoredValues& how, int k, std::vector<std::uint16_t>& into)
{
  std::visit(
    [&](const auto& view)
    {
      const auto* from = view.data + into.size() * k;
      using Sample = std::remove_cv_t<std::remove_pointer_t<decltype(view.data)>>;
      std::transform(from, from + into.size(), into.begin(),
        [&](Sample v)
        {
          if constexpr (std::is_same_v<Sample, float>)
            return static_cast<std::uint16_t>(Clamped(v, how));
          else
            return static_cast<std::uint16_t>(v);
        });
    },
    grid);
}

} // namespace hasp
