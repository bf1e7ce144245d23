#include "vtkHaspClusteredCellLocator.h"

#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspPickedCell.h"

#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStructuredData.h"

#include <algorithm>

vtkStandardNewMacro(vtkHaspClusteredCellLocator);

vtkHaspClusteredCellLocator::vtkHaspClusteredCellLocator() = default;
vtkHaspClusteredCellLocator::~vtkHaspClusteredCellLocator() = default;

void vtkHaspClusteredCellLocator::SetMapper(vtkHaspClusteredCellMapper* mapper)
{
  if (this->Mapper == mapper)
    return;
  this->Mapper = mapper;
  this->Modified();
}

vtkHaspClusteredCellMapper* vtkHaspClusteredCellLocator::GetMapper()
{
  return this->Mapper;
}

vtkDataSet* vtkHaspClusteredCellLocator::GetDataSet()
{
  return this->Mapper ? this->Mapper->GetInput() : nullptr;
}

int vtkHaspClusteredCellLocator::IntersectWithLine(const double p1[3], const double p2[3], double,
  double& t, double x[3], double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataSet());
  vtkNew<vtkHaspPickedCell> picked;
  if (!image || !this->Mapper->UpdateCells() || !this->Mapper->PickFirstCell(p1, p2, picked))
    return 0;
  const int* extent = image->GetExtent();
  int ijk[3];
  for (int a = 0; a < 3; ++a)
  {
    ijk[a] = extent[2 * a] + picked->GetIJK()[a];
    pcoords[a] = picked->GetPCoords()[a];
  }
  t = picked->GetT();
  picked->GetPosition(x);
  subId = 0;
  cellId = vtkStructuredData::ComputeCellIdForExtent(extent, ijk);
  if (cell)
    image->GetCell(cellId, cell);
  return 1;
}

void vtkHaspClusteredCellLocator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mapper: " << this->Mapper.Get() << "\n";
}
