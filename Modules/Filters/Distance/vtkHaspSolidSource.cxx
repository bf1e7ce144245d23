#include "vtkHaspSolidSource.h"

#include "Distance/SolidShapes.h"
#include "Distance/SolidSweeps.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspSolid.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <exception>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspSolidSource);

namespace
{

glm::dvec3 Vector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

glm::dmat3 Axes(const double rows[9])
{
  glm::dmat3 axes;
  for (int i = 0; i < 9; ++i)
    axes[i % 3][i / 3] = rows[i];
  return axes;
}

} // namespace

vtkHaspSolidSource::vtkHaspSolidSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkHaspSolidSource::~vtkHaspSolidSource() = default;

template <typename Make>
bool vtkHaspSolidSource::Set(const Make& make)
{
  try
  {
    this->Solid = make();
    this->Modified();
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

bool vtkHaspSolidSource::SetToPlane(const double point[3], const double normal[3])
{
  return this->Set([&] { return hasp::MakePlane(Vector(point), Vector(normal)); });
}

bool vtkHaspSolidSource::SetToSlab(const double point[3], const double normal[3], double width)
{
  return this->Set([&] { return hasp::MakeSlab(Vector(point), Vector(normal), width); });
}

bool vtkHaspSolidSource::SetToBox(const double center[3], const double half[3])
{
  return this->Set([&] { return hasp::MakeBox(Vector(center), glm::dmat3(1.0), Vector(half)); });
}

bool vtkHaspSolidSource::SetToBox(
  const double center[3], const double half[3], const double axes[9])
{
  return this->Set([&] { return hasp::MakeBox(Vector(center), Axes(axes), Vector(half)); });
}

bool vtkHaspSolidSource::SetToRoundedBox(
  const double center[3], const double half[3], double radius)
{
  return this->Set(
    [&] { return hasp::MakeRoundedBox(Vector(center), glm::dmat3(1.0), Vector(half), radius); });
}

bool vtkHaspSolidSource::SetToRoundedBox(
  const double center[3], const double half[3], double radius, const double axes[9])
{
  return this->Set(
    [&] { return hasp::MakeRoundedBox(Vector(center), Axes(axes), Vector(half), radius); });
}

bool vtkHaspSolidSource::SetToCylinder(const double a[3], const double b[3], double radius)
{
  return this->Set([&] { return hasp::MakeCylinder(Vector(a), Vector(b), radius); });
}

bool vtkHaspSolidSource::SetToStadium(
  const double a[3], const double b[3], const double normal[3], double radius, double height)
{
  return this->Set(
    [&] { return hasp::MakeStadium(Vector(a), Vector(b), Vector(normal), radius, height); });
}

bool vtkHaspSolidSource::SetToCapsule(const double a[3], const double b[3], double radius)
{
  return this->Set([&] { return hasp::MakeCapsule(Vector(a), Vector(b), radius); });
}

bool vtkHaspSolidSource::SetToText(const std::string& text, const double origin[3],
  const double right[3], const double up[3], double height, double stroke)
{
  return this->Set([&]
    { return hasp::MakeText(text, Vector(origin), Vector(right), Vector(up), height, stroke); });
}

double vtkHaspSolidSource::GetTextWidth(const std::string& text, double height)
{
  return hasp::TextWidth(text.size(), height);
}

int vtkHaspSolidSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkHaspSolid* output = vtkHaspSolid::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction&)
    {
      if (!this->Solid)
        throw std::invalid_argument("there is no shape: call one of SetTo...");
      output->SetSolid(this->Solid);
    });
}

void vtkHaspSolidSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << (this->Solid ? "there" : "none") << "\n";
}
