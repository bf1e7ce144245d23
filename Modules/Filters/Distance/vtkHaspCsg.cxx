#include "vtkHaspCsg.h"

#include "Distance/Csg.h"
#include "SolidInputs.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspSolid.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

vtkStandardNewMacro(vtkHaspCsg);

namespace
{

/// What samples hold nothing of cannot be offset. Throws std::invalid_argument.
void RequireReach(const hasp::SampledFacts& image, double mm)
{
  if (mm == 0.0 || (mm < image.greatest && mm > image.least))
    return;
  std::ostringstream text;
  text << "input " << image.input << ": no sample of the image is " << std::abs(mm) << " mm "
       << (mm > 0.0 ? "outside" : "inside") << ", they go from " << image.least << " to "
       << image.greatest << " mm: in vtkHaspSignedDistance NarrowBandOff (it ends at four voxels), "
       << (mm > 0.0 ? "SetMargin, " : "") << "or a smaller distance";
  throw std::invalid_argument(text.str());
}

} // namespace

struct vtkHaspCsg::Internals
{
  hasp::SolidInputs inputs;

  /// Can images be offset by what is asked?
  void CheckOffsets(vtkHaspCsg& self) const
  {
    const bool shell = self.Operation == Shell;
    if (self.Operation != Offset && !shell)
      return;
    const double most = shell ? self.Range[1] : self.Distance;
    for (const hasp::SampledFacts& image : this->inputs.Sampled())
    {
      RequireReach(image, most);
      if (shell)
        RequireReach(image, self.Range[0]);
      if (most > 0.0 && image.leastOnBorder < most)
        vtkWarningWithObjectMacro(
          &self, "input " << image.input << " reaches to " << std::max(image.leastOnBorder, 0.0F)
                          << " mm from the border of its image, and is "
                          << "offset by " << most
                          << " mm: what lies beyond the border is not true. SetMargin(" << most
                          << ") in vtkHaspSignedDistance makes room");
    }
  }

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
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction&)
    {
      std::vector<hasp::SolidPointer> parts = this->Inside->inputs.Get(inputs[0]);
      this->Inside->CheckOffsets(*this);
      output->SetSolid(this->Inside->Join(*this, std::move(parts)));
    });
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
