#include "vtkHaspSolidSweep.h"

#include "Distance/Csg.h"
#include "Distance/SolidSweeps.h"
#include "SolidInputs.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspSolid.h"

#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkHaspSolidSweep);

struct vtkHaspSolidSweep::Internals
{
  hasp::SolidInputs surface;
};

namespace
{

struct Line
{
  std::vector<glm::dvec3> points;
  bool closed = false; ///< its last point is not told again
};

std::vector<Line> LinesOf(vtkPolyData* data)
{
  std::vector<Line> lines;
  vtkCellArray* cells = data->GetLines();
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(c, count, ids);
    Line& line = lines.emplace_back();
    line.closed = count > 2 && ids[0] == ids[count - 1];
    for (vtkIdType i = 0; i < count - (line.closed ? 1 : 0); ++i)
    {
      glm::dvec3 point;
      data->GetPoint(ids[i], &point.x);
      line.points.push_back(point);
    }
  }
  if (lines.empty())
    throw std::invalid_argument("input 0 has no lines");
  return lines;
}

} // namespace

vtkHaspSolidSweep::vtkHaspSolidSweep() : Inside(new Internals)
{
  this->SetNumberOfInputPorts(2);
}

vtkHaspSolidSweep::~vtkHaspSolidSweep() = default;

void vtkHaspSolidSweep::SetSurfaceConnection(vtkAlgorithmOutput* surface)
{
  this->SetInputConnection(1, surface);
}

void vtkHaspSolidSweep::SetSurfaceData(vtkDataObject* surface)
{
  this->SetInputData(1, surface);
}

int vtkHaspSolidSweep::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  else
    hasp::SolidInputs::Accept(info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkHaspSolidSweep::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkHaspSolid* output = vtkHaspSolid::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction&)
    {
      const std::vector<hasp::SolidPointer> surface =
        this->Inside->surface.Get(inputs[1], "surface");
      std::vector<hasp::SolidPointer> parts;
      for (Line& line : LinesOf(vtkPolyData::GetData(inputs[0])))
      {
        if (!surface.empty() && line.closed)
          line.points.push_back(line.points.front());
        parts.push_back(surface.empty() ? hasp::MakeTube(line.points, line.closed, this->Radius)
                                        : hasp::MakeRibbon(surface[0], line.points, this->Width,
                                            this->Range[0], this->Range[1]));
      }
      output->SetSolid(hasp::MakeUnion(std::move(parts)));
    });
}

void vtkHaspSolidSweep::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n"
     << indent << "Width: " << this->Width << "\n"
     << indent << "Range: " << this->Range[0] << " " << this->Range[1] << "\n";
}
