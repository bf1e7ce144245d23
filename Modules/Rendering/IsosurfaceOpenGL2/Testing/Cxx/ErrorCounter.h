#pragma once
#include "vtkCommand.h"

namespace hasp::testing
{

/// Counts errors and lets none be printed.
struct ErrorCounter : vtkCommand
{
  static ErrorCounter* New() { return new ErrorCounter; }
  int Count = 0;
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Count; }
};

} // namespace hasp::testing
