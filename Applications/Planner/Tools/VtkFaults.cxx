#include "Tools/VtkFaults.h"

#include "vtkCommand.h"
#include "vtkObject.h"

#include <utility>

namespace hasp
{

QString VtkFaultText(const char* error)
{
  // "ERROR: In file, line 1\nvtkHaspFoo (0x55): text\n\n"
  const QString all = QString::fromUtf8(error).trimmed();
  const int address = all.indexOf(QStringLiteral(" (0x"));
  const int begin = address < 0 ? -1 : all.indexOf(QStringLiteral("): "), address);
  return begin < 0 ? all : all.mid(begin + 3);
}

VtkFaults::VtkFaults(std::function<void(const QString&)> say) : Say(std::move(say))
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void* text)
    {
      if (self && text)
        static_cast<VtkFaults*>(self)->Say(VtkFaultText(static_cast<const char*>(text)));
    });
}

VtkFaults::~VtkFaults()
{
  this->Command->SetClientData(nullptr);
}

void VtkFaults::Follow(vtkObject* object)
{
  object->AddObserver(vtkCommand::ErrorEvent, this->Command);
}

} // namespace hasp
