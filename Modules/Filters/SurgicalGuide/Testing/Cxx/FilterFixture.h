#pragma once
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <initializer_list>
#include <string>

/// What tests of filters share.
namespace parttest
{

/// Appends what the filter says, errors unless other events are named, to a text that outlives it.
inline void KeepWords(vtkAlgorithm* filter, std::string& text,
  std::initializer_list<unsigned long> events = { vtkCommand::ErrorEvent })
{
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&text);
  keep->SetCallback([](vtkObject*, unsigned long, void* kept, void* said)
    { *static_cast<std::string*>(kept) += static_cast<const char*>(said); });
  for (const unsigned long event : events)
  {
    filter->AddObserver(event, keep);
    filter->GetExecutive()->AddObserver(event, keep);
  }
}

/// Keeps the largest share of its work that the filter tells, below the end.
inline void KeepProgress(vtkAlgorithm* filter, double& share)
{
  vtkNew<vtkCallbackCommand> keep;
  keep->SetClientData(&share);
  keep->SetCallback(
    [](vtkObject*, unsigned long, void* kept, void* told)
    {
      double& most = *static_cast<double*>(kept);
      if (const double now = *static_cast<double*>(told); now < 1.0 && now > most)
        most = now;
    });
  filter->AddObserver(vtkCommand::ProgressEvent, keep);
}

} // namespace parttest
