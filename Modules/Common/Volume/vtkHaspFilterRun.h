#ifndef vtkHaspFilterRun_h
#define vtkHaspFilterRun_h

#include "Grid/Progress.h" // for ProgressFunction
#include "vtkAlgorithm.h"  // for progress and errors
#include "vtkErrorCode.h"  // for what went wrong

#include <exception> // for what work throws
#include <new>       // for std::bad_alloc

namespace hasp
{

/// Runs what a filter does, in RequestData: `work` gets the filter's progress, which ends it after
/// AbortExecute. Returns 1, also where that was asked for, or 0 after an error, which is said, and
/// kept in the filter's error code. What `work` has not yet put into the output when it throws is
/// not there.
template <typename Work>
int RunFilter(vtkAlgorithm* filter, unsigned long& errorCode, const Work& work)
{
  errorCode = vtkErrorCode::UserError;
  try
  {
    work(ProgressFunction(
      [filter](double share)
      {
        filter->UpdateProgress(share);
        return !filter->GetAbortExecute();
      }));
    errorCode = vtkErrorCode::NoError;
    return 1;
  }
  catch (const Cancelled&)
  {
    errorCode = vtkErrorCode::NoError;
    return 1; // what was asked for: nothing
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(
      filter, "there is not enough memory: take a coarser grid, or less of the image");
    return 0;
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(filter, << error.what());
    return 0;
  }
}

} // namespace hasp

#endif
