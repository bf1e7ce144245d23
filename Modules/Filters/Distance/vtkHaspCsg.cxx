#include "vtkHaspCsg.h"

#include "Distance/Csg.h"
#include "FilterRun.h"
#include "SolidInputs.h"
#include "vtkHaspSolid.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <utility>

vtkStandardNewMacro(vtkHaspCsg);

struct vtkHaspCsg::Internals
{
  hasp::SolidInputs inputs;

  /// At least one part.
  hasp::SolidPointer Join(const vtkHaspCsg& self, std::vector<hasp::SolidPointer> parts) const
  {
    switch (self.Operation)
    {
      case Intersection:
        return hasp::MakeIntersection(std::move(parts));
      case Difference:
      {
        if (parts.size() == 1)
          return parts[0];
        const hasp::SolidPointer body = parts[0];
        parts.erase(parts.begin());
        return hasp::MakeDifference(body, hasp::MakeUnion(std::move(parts)));
      }
      case SmoothUnion:
      {
        hasp::SolidPointer joined = parts[0];
        for (std::size_t i = 1; i < parts.size(); ++i)
          joined = hasp::MakeSmoothUnion(joined, parts[i], self.Radius);
        return joined;
      }
      case Offset:
        return hasp::MakeOffset(hasp::MakeUnion(std::move(parts)), self.Distance);
      case Shell:
        return hasp::MakeShell(hasp::MakeUnion(std::move(parts)), self.Range[0], self.Range[1]);
      default:
        return hasp::MakeUnion(std::move(parts));
    }
  }
};

vtkHaspCsg::vtkHaspCsg() : Inside(new Internals) {}
vtkHaspCsg::~vtkHaspCsg() = default;

int vtkHaspCsg::FillInputPortInformation(int, vtkInformation* info)
{
  hasp::SolidInputs::Accept(info);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkHaspCsg::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkHaspSolid* output = vtkHaspSolid::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, [&](const hasp::ProgressFunction&)
    { output->SetSolid(this->Inside->Join(*this, this->Inside->inputs.Get(inputs[0]))); });
}

void vtkHaspCsg::PrintSelf(ostream& os, vtkIndent indent)
{
  static constexpr const char* Names[] = { "union", "intersection", "difference", "smooth union",
    "offset", "shell" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Operation: " << Names[this->Operation] << "\n"
     << indent << "Radius: " << this->Radius << "\n"
     << indent << "Distance: " << this->Distance << "\n"
     << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
}
