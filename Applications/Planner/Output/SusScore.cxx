#include "Output/SusScore.h"

#include <stdexcept>
#include <string>

namespace hasp
{

double SusScore(const SusAnswers& answers)
{
  int sum = 0;
  for (std::size_t n = 0; n < answers.size(); ++n)
  {
    if (answers[n] < 1 || answers[n] > 5)
      throw std::invalid_argument("answer " + std::to_string(n + 1) + " is " +
                                  std::to_string(answers[n]) + ", must be in [1, 5]");
    sum += n % 2 == 0 ? answers[n] - 1 : 5 - answers[n];
  }
  return 2.5 * sum;
}

} // namespace hasp
