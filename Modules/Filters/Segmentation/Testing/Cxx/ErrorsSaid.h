#pragma once
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <string>

/// What an algorithm and its executive say in an update, in place of printing it: errors, or
/// warnings.
inline std::string SaidInUpdate(vtkAlgorithm* of, unsigned long event)
{
  std::string said;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&said);
  listen->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
    { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
  of->AddObserver(event, listen);
  of->GetExecutive()->AddObserver(event, listen);
  of->Update();
  of->RemoveObserver(listen);
  of->GetExecutive()->RemoveObserver(listen);
  return said;
}

inline std::string ErrorsOfUpdate(vtkAlgorithm* of)
{
  return SaidInUpdate(of, vtkCommand::ErrorEvent);
}
