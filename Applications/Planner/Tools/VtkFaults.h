#pragma once
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <QString>

#include <functional>

namespace hasp
{

/// Tells what objects of VTK call errors, in their own words without file, line, class and address.
/// Those that are followed write nothing to the console. Threads: RENDER; objects that outlive it
/// are told nothing more.
class VtkFaults
{
public:
  explicit VtkFaults(std::function<void(const QString&)> say);
  ~VtkFaults();
  VtkFaults(const VtkFaults&) = delete;
  VtkFaults& operator=(const VtkFaults&) = delete;

  void Follow(vtkObject* object);

private:
  std::function<void(const QString&)> Say;
  vtkNew<vtkCallbackCommand> Command;
};

/// The sentence in an error's text; the text where none is found.
QString VtkFaultText(const char* error);

} // namespace hasp
