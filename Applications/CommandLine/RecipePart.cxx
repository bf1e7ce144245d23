#include "RecipePart.h"

#include "VtkMessages.h"

#if HASP_WITH_OPENSSL
#include "Planning/Sha256.h"
#endif

#include <chrono>
#include <fstream>
#include <new>
#include <sstream>

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

PartLabel LabelOfRecipe(const std::string& name, const std::string& recipe)
{
  PartLabel label{ .name = name, .hash = {} };
#if HASP_WITH_OPENSSL
  std::ostringstream bytes;
  bytes << std::ifstream(recipe, std::ios::binary).rdbuf();
  label.hash = Sha256(bytes.str());
#else
  static_cast<void>(recipe);
#endif
  return label;
}

void WritePart(vtkPolyData* part, const std::string& output, Session& session,
  const PartLabel& label, const InspectPart& inspect)
{
  try
  {
    WriteSurface(part, output, label, inspect);
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
