#include "RecipePart.h"

#include "VtkMessages.h"
#include "vtkHaspOutputFile.h"

#include <chrono>
#include <new>

namespace hasp
{

vtkSmartPointer<vtkPolyData> RunPartFilter(
  vtkPolyDataAlgorithm* filter, const char* part, Session& session)
{
  session.progress.Step(std::string("making the ") + part);
  ShowProgress(session, filter);
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  ThrowVtkError(
    ExitCode::BadInput, std::string("no ") + part + " can be made of this recipe and volume");
  vtkSmartPointer<vtkPolyData> made = filter->GetOutput();
  session.resources.push_back(
    { part, 1024 * made->GetActualMemorySize(), spent.count(), "made from the recipe" });
  return made;
}

void WritePart(vtkPolyData* part, const std::string& output, Session& session)
{
  try
  {
    WriteSurface(part, output);
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
  session.result["output"] = FileLabel(output);
}

} // namespace hasp
