// C++17: VTK 9.1's vtkSMPTools.h is no C++20.
#include "VtkThreads.h"

#include "vtkSMPTools.h"

namespace hasp
{

std::string UseVtkThreads(int threads)
{
  vtkSMPTools::SetBackend("TBB"); // stays what it was in a VTK without it
  vtkSMPTools::Initialize(threads);
  return std::string(vtkSMPTools::GetBackend()) + ", " +
         std::to_string(vtkSMPTools::GetEstimatedNumberOfThreads()) + " threads";
}

} // namespace hasp
