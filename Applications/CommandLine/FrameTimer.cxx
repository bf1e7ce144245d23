#include "FrameTimer.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"

#include <utility>

namespace hasp
{
FrameTimer::FrameTimer(vtkRenderWindowInteractor* interactor, std::function<void()> call)
  : Interactor(interactor),
    Call(std::move(call))
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* self, void* id)
    { static_cast<FrameTimer*>(self)->Fire(id); });
  this->Tag = interactor->AddObserver(vtkCommand::TimerEvent, command);
}

FrameTimer::~FrameTimer()
{
  this->Interactor->RemoveObserver(this->Tag);
}

void FrameTimer::Start(int ms)
{
  if (this->Id == 0 && this->Interactor->GetInitialized())
    this->Id = this->Interactor->CreateOneShotTimer(ms);
}

void FrameTimer::Fire(void* id)
{
  if (!id || this->Id == 0 || *static_cast<int*>(id) != this->Id)
    return; // another's
  if (this->Spent)
    this->Interactor->DestroyTimer(this->Spent); // VTK would remember it
  this->Spent = std::exchange(this->Id, 0);
  this->Call();
}

} // namespace hasp
