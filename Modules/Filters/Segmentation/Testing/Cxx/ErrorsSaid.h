#pragma once
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <string>

/// What an algorithm and its executive say in an update, in place of printing it.
inline std::string ErrorsOfUpdate(vtkAlgorithm* of)
{
  std::string said;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&said);
  listen->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
    { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
  of->AddObserver(vtkCommand::ErrorEvent, listen);
  of->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, listen);
  of->Update();
  of->RemoveObserver(listen);
  of->GetExecutive()->RemoveObserver(listen);
  return said;
}
