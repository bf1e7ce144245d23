#pragma once
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <functional>
#include <string>

/// What an algorithm and its executive say while `work` runs, in place of printing it.
inline std::string ErrorsOf(
  vtkAlgorithm* of, const std::function<void()>& work, unsigned long event = vtkCommand::ErrorEvent)
{
  std::string said;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&said);
  listen->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
    { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
  for (vtkObject* object :
    { static_cast<vtkObject*>(of), static_cast<vtkObject*>(of->GetExecutive()) })
    object->AddObserver(event, listen);
  work();
  for (vtkObject* object :
    { static_cast<vtkObject*>(of), static_cast<vtkObject*>(of->GetExecutive()) })
    object->RemoveObserver(listen);
  return said;
}

inline std::string ErrorsOfUpdate(vtkAlgorithm* of)
{
  return ErrorsOf(of, [of] { of->Update(); });
}

inline std::string WarningsOfUpdate(vtkAlgorithm* of)
{
  return ErrorsOf(
    of, [of] { of->Update(); }, vtkCommand::WarningEvent);
}

/// Ends an algorithm at its first word of progress.
class AbortAtOnce
{
public:
  explicit AbortAtOnce(vtkAlgorithm* of)
  {
    this->Command->SetCallback([](vtkObject* self, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(self)->AbortExecuteOn(); });
    of->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }

private:
  vtkNew<vtkCallbackCommand> Command;
};
