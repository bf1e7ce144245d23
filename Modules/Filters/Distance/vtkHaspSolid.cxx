#include "vtkHaspSolid.h"

#include "Distance/ImplicitSolid.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <limits>

vtkStandardNewMacro(vtkHaspSolid);

vtkHaspSolid::vtkHaspSolid() = default;
vtkHaspSolid::~vtkHaspSolid() = default;

void vtkHaspSolid::SetSolid(std::shared_ptr<const hasp::ImplicitSolid> solid)
{
  this->Solid = std::move(solid);
  this->Modified();
}

std::shared_ptr<const hasp::ImplicitSolid> vtkHaspSolid::GetSolid() const
{
  return this->Solid;
}

double vtkHaspSolid::EvaluateDistance(const double place[3])
{
  return this->Solid ? this->Solid->At({ place[0], place[1], place[2] })
                     : std::numeric_limits<double>::infinity();
}

void vtkHaspSolid::EvaluateGradient(const double place[3], double gradient[3])
{
  glm::dvec3 g(0.0);
  if (this->Solid)
    g = this->Solid->SampleAt({ place[0], place[1], place[2] }).gradient;
  for (int a = 0; a < 3; ++a)
    gradient[a] = g[a];
}

vtkIdType vtkHaspSolid::GetNumberOfFaces()
{
  return this->Solid ? static_cast<vtkIdType>(this->Solid->Faces()) : 0;
}

void vtkHaspSolid::GetBounds(double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  if (!this->Solid)
    return;
  const hasp::ImplicitSolid::Box box = this->Solid->Bounds();
  if (glm::any(glm::lessThan(box.high, box.low)))
    return;
  for (int a = 0; a < 3; ++a)
  {
    bounds[2 * a] = box.low[a];
    bounds[2 * a + 1] = box.high[a];
  }
}

void vtkHaspSolid::Initialize()
{
  this->Superclass::Initialize();
  this->Solid.reset();
}

void vtkHaspSolid::ShallowCopy(vtkDataObject* source)
{
  if (auto* other = vtkHaspSolid::SafeDownCast(source))
    this->SetSolid(other->Solid);
  this->Superclass::ShallowCopy(source);
}

void vtkHaspSolid::DeepCopy(vtkDataObject* source)
{
  if (auto* other = vtkHaspSolid::SafeDownCast(source))
    this->SetSolid(other->Solid);
  this->Superclass::DeepCopy(source);
}

vtkHaspSolid* vtkHaspSolid::GetData(vtkInformation* info)
{
  return info ? vtkHaspSolid::SafeDownCast(info->Get(DATA_OBJECT())) : nullptr;
}

vtkHaspSolid* vtkHaspSolid::GetData(vtkInformationVector* vector, int i)
{
  return vtkHaspSolid::GetData(vector->GetInformationObject(i));
}

void vtkHaspSolid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Faces: " << this->GetNumberOfFaces() << "\n";
  double b[6];
  this->GetBounds(b);
  os << indent << "Bounds: " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " " << b[4]
     << " " << b[5] << "\n";
}
