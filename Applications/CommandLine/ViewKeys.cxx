#include "ViewKeys.h"

namespace hasp
{

int IsoValueStep(const std::string& key)
{
  if (key == "Right" || key == "Up" || key == "plus" || key == "equal" || key == "KP_Add")
    return 1;
  if (key == "Left" || key == "Down" || key == "minus" || key == "KP_Subtract")
    return -1;
  return key == "Prior" ? 10 : key == "Next" ? -10 : 0; // Page Up, Page Down
}

std::string ViewKeys()
{
  return "Mouse: left turns, middle (or Shift and left) pans, right and wheel zoom; drag the "
         "slider\n"
         "Keys:\n"
         "  Right Up + / Left Down -   raise / lower the isovalue by 1% of its range\n"
         "  Page Up / Page Down        by 10%\n"
         "  p   where the pointer's surface is, mm LPS     r   back to the first view\n"
         "  s   save the window as it is: hasp-view-1.png (-2, ...) in the current folder\n"
         "  q Esc   quit\n";
}

} // namespace hasp
