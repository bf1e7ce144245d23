#ifndef ErrorListener_h
#define ErrorListener_h

#include "vtkCommand.h"

#include <string>
#include <utility>

/// Hears what the mappers inside another say is wrong, for the other to say it: their own observers
/// nobody has. Threads: RENDER.
class ErrorListener : public vtkCommand
{
public:
  static ErrorListener* New() { return new ErrorListener; }
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    const std::string all = static_cast<const char*>(text);
    // "ERROR: In FILE, line N\nCLASS (ADDRESS): MESSAGE\n\n"
    const std::size_t begin = all.find("): "), end = all.find_last_not_of("\n");
    this->Said = begin < end ? all.substr(begin + 3, end - begin - 2) : all;
  }
  /// What was said last, once; empty if nothing.
  std::string Take() { return std::exchange(this->Said, {}); }

private:
  std::string Said;
};

#endif
