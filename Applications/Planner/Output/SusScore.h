#pragma once
#include <array>

namespace hasp
{

constexpr std::size_t SusItems = 10;
/// Of the System Usability Scale, in its order: 1 (strongly disagree) to 5 (strongly agree).
using SusAnswers = std::array<int, SusItems>;

/// [0, 100], in steps of 2.5 (Brooke 1996): of the first, third, … statement its answer less 1, of
/// the others 5 less theirs; the sum times 2.5. Throws std::invalid_argument, naming the item, on
/// an answer outside [1, 5]. Any thread.
double SusScore(const SusAnswers& answers);

} // namespace hasp
