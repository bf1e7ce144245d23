#pragma once
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"

#include <exception>

class vtkPolyData;

/// What the filters share that make something of a recipe. Private to this module.
namespace hasp
{

/// Runs `work`; what it throws is the filter's error, and false. True if it was cancelled: nothing
/// is what was asked for then.
template <typename Work>
bool Succeeds(vtkAlgorithm* filter, const Work& work)
{
  try
  {
    work();
    return true;
  }
  catch (const Cancelled&)
  {
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(filter, << error.what());
    return false;
  }
}

/// Shows how far it is, and asks whether to go on. For as long as the filter lives.
inline ProgressFunction ProgressOf(vtkAlgorithm* filter)
{
  return [filter](double share)
  {
    filter->UpdateProgress(share);
    return !filter->GetAbortExecute();
  };
}

/// Recipes are JSON files. Always false.
inline bool CannotReadRecipe(vtkAlgorithm* filter)
{
  vtkErrorWithObjectMacro(filter, "cannot read a recipe: built without HASP_ENABLE_JSON");
  return false;
}

/// A scan on port 0, and on port 1, if there is one, another that may be left out.
inline int AskForImages(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  if (port == 1)
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

/// A column of the field data: value(item) of each.
template <typename Items, typename Value>
void AddField(vtkDataObject* output, const char* name, const Items& items, const Value& value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const auto& item : items)
    array->InsertNextValue(double(value(item)));
  output->GetFieldData()->AddArray(array);
}

/// Meshes in one, and the number that each triangle's has, as the active scalars of its cells.
class NumberedMeshes
{
public:
  void Add(const TriangleMesh& mesh, int number);
  void Give(vtkPolyData* output, const char* name);

private:
  TriangleMesh All;
  vtkNew<vtkIntArray> Numbers;
};

} // namespace hasp
