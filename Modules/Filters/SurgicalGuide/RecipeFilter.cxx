#include "RecipeFilter.h"

#include "vtkCellData.h"
#include "vtkHaspVolumeView.h"
#include "vtkPolyData.h"

namespace hasp
{

void NumberedMeshes::Add(const TriangleMesh& mesh, int number)
{
  const auto first = static_cast<unsigned>(this->All.points.size());
  this->All.points.insert(this->All.points.end(), mesh.points.begin(), mesh.points.end());
  for (const glm::uvec3& t : mesh.triangles)
  {
    this->All.triangles.push_back(t + first);
    this->Numbers->InsertNextValue(number);
  }
}

void NumberedMeshes::Give(vtkPolyData* output, const char* name)
{
  this->Numbers->SetName(name);
  output->ShallowCopy(MakePolyData(this->All));
  output->GetCellData()->AddArray(this->Numbers);
  output->GetCellData()->SetActiveScalars(name);
}

} // namespace hasp
