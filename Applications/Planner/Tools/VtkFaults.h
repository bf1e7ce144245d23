#pragma once
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <QString>

#include <functional>

namespace hasp
{

/// Tells what objects of VTK call errors, as VtkMessageText has it. Those that are followed tell
/// nobody else. Threads: RENDER; objects that outlive it
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

} // namespace hasp
