#include "DrawingChoice.h"

#include <iomanip>
#include <sstream>

std::string DrawingChoice::Text() const
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  const auto say = [&](const Cost& cost)
  {
    if (cost.times == 0)
      text << "not measured";
    else
      text << cost.least << " ms";
  };
  text << "cache ";
  say(this->Measured[0].cache);
  text << ", all active cells ";
  say(this->Measured[0].whole);
  text << "; after a change ";
  say(this->Measured[1].cache);
  text << " and ";
  say(this->Measured[1].whole);
  return text.str();
}
