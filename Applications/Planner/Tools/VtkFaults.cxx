#include "Tools/VtkFaults.h"

#include "VtkMessages.h"

#include "vtkCommand.h"
#include "vtkObject.h"

#include <utility>

namespace hasp
{

VtkFaults::VtkFaults(std::function<void(const QString&)> say) : Say(std::move(say))
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void* text)
    {
      if (self && text)
        static_cast<VtkFaults*>(self)->Say(
          QString::fromStdString(VtkMessageText(static_cast<const char*>(text))));
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
