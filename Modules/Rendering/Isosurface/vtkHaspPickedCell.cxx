#include "vtkHaspPickedCell.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHaspPickedCell);

vtkHaspPickedCell::vtkHaspPickedCell() = default;
vtkHaspPickedCell::~vtkHaspPickedCell() = default;

void vtkHaspPickedCell::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto three = [&](const char* name, const auto* values)
  { os << indent << name << ": " << values[0] << ", " << values[1] << ", " << values[2] << "\n"; };
  os << indent << "CellId: " << this->CellId << "\n";
  three("IJK", this->IJK);
  three("PCoords", this->PCoords);
  os << indent << "T: " << this->T << "\n";
  three("Position", this->Position);
  three("Normal", this->Normal);
  os << indent << "Value: " << this->Value << "\n";
  os << indent << "Label: " << this->Label << "\n";
}
