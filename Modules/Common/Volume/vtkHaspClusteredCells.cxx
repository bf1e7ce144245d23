#include "vtkHaspClusteredCells.h"

#include "Isosurface/ClusteredCells.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkHaspClusteredCells);

namespace
{
const std::shared_ptr<const hasp::ClusteredCells>& NoCells()
{
  static const auto none = std::make_shared<const hasp::ClusteredCells>();
  return none;
}
}

vtkHaspClusteredCells::vtkHaspClusteredCells() : Cells(NoCells()) {}
vtkHaspClusteredCells::~vtkHaspClusteredCells() = default;

void vtkHaspClusteredCells::SetCells(std::shared_ptr<const hasp::ClusteredCells> cells)
{
  this->Cells = cells ? std::move(cells) : NoCells();
  this->Modified();
}

std::shared_ptr<const hasp::ClusteredCells> vtkHaspClusteredCells::GetCells() const
{
  return this->Cells;
}

vtkIdType vtkHaspClusteredCells::GetNumberOfCells()
{
  return static_cast<vtkIdType>(this->Cells->Count());
}

vtkIdType vtkHaspClusteredCells::GetNumberOfClusters()
{
  return static_cast<vtkIdType>(this->Cells->clusters.size());
}

double vtkHaspClusteredCells::GetIsoValue()
{
  return this->Cells->isovalue;
}

bool vtkHaspClusteredCells::GetCompact()
{
  return this->Cells->precision == hasp::CellPrecision::Compact;
}

void vtkHaspClusteredCells::GetDimensions(int dimensions[3])
{
  for (int a = 0; a < 3; ++a)
    dimensions[a] = this->Cells->geometry.dims[a];
}

void vtkHaspClusteredCells::GetBounds(double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  const hasp::GridGeometry& g = this->Cells->geometry;
  if (std::min({ g.dims.x, g.dims.y, g.dims.z }) < 1)
    return;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 end(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 world = g.IndexToWorld(end * (g.dims - 1));
    for (int a = 0; a < 3; ++a)
    {
      bounds[2 * a] = corner == 0 ? world[a] : std::min(bounds[2 * a], world[a]);
      bounds[2 * a + 1] = corner == 0 ? world[a] : std::max(bounds[2 * a + 1], world[a]);
    }
  }
}

unsigned long vtkHaspClusteredCells::GetActualMemorySize()
{
  return this->Superclass::GetActualMemorySize() +
         static_cast<unsigned long>((this->Cells->Bytes() + 1023) / 1024);
}

void vtkHaspClusteredCells::Initialize()
{
  this->Superclass::Initialize();
  this->Cells = NoCells();
}

void vtkHaspClusteredCells::ShallowCopy(vtkDataObject* source)
{
  if (auto* other = vtkHaspClusteredCells::SafeDownCast(source))
    this->SetCells(other->Cells);
  this->Superclass::ShallowCopy(source);
}

void vtkHaspClusteredCells::DeepCopy(vtkDataObject* source)
{
  if (auto* other = vtkHaspClusteredCells::SafeDownCast(source))
    this->SetCells(std::make_shared<const hasp::ClusteredCells>(*other->Cells));
  this->Superclass::DeepCopy(source);
}

vtkHaspClusteredCells* vtkHaspClusteredCells::GetData(vtkInformation* info)
{
  return info ? vtkHaspClusteredCells::SafeDownCast(info->Get(DATA_OBJECT())) : nullptr;
}

vtkHaspClusteredCells* vtkHaspClusteredCells::GetData(vtkInformationVector* vector, int i)
{
  return vtkHaspClusteredCells::GetData(vector->GetInformationObject(i));
}

void vtkHaspClusteredCells::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const glm::ivec3& dims = this->Cells->geometry.dims;
  os << indent << "Active cells: " << this->Cells->Count() << "\n"
     << indent << "Clusters: " << this->Cells->clusters.size() << "\n"
     << indent << "Bytes: " << this->Cells->Bytes() << "\n"
     << indent << "IsoValue: " << this->Cells->isovalue << "\n"
     << indent << "Precision: " << (this->GetCompact() ? "compact" : "exact") << "\n"
     << indent << "Dimensions: " << dims.x << " " << dims.y << " " << dims.z << "\n";
}
