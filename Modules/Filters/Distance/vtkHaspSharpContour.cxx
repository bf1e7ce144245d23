#include "vtkHaspSharpContour.h"

#include "Distance/Csg.h"
#include "Distance/NearSurface.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidShapes.h"
#include "SolidInputs.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspVolumeView.h"

#include "vtkFlyingEdges3D.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspSharpContour);

namespace
{

using Box = hasp::ImplicitSolid::Box;

constexpr std::size_t MostSamples = 200'000'000; // of a dense grid
constexpr double Border = 1.37; // cells around a solid. Its flat ends lie beside the grid's points,
                                // also where it is a round number of cells large

[[noreturn]] void Refuse(const std::string& why)
{
  throw std::invalid_argument(why);
}

/// What of a solid lies in the bounds; all of it where there are none.
hasp::SolidPointer CutOff(const hasp::SolidPointer& solid, const double b[6])
{
  const glm::dvec3 low(b[0], b[2], b[4]), high(b[1], b[3], b[5]);
  if (glm::all(glm::lessThan(high, low)))
    return solid;
  for (int a = 0; a < 3; ++a)
    if (!(low[a] < high[a]) || std::isinf(low[a]) || std::isinf(high[a]))
      Refuse(std::string("Bounds along ") + "xyz"[a] +
             " are not a finite range; low is to be below high, or above it along all axes for "
             "none");
  return hasp::MakeIntersection(
    { solid, hasp::MakeBox(0.5 * (low + high), glm::dmat3(1.0), 0.5 * (high - low)) });
}

/// Around the box. None if that is empty.
std::optional<hasp::GridGeometry> GridAround(const Box& box, double spacing)
{
  if (!(spacing > 0.0) || !std::isfinite(spacing))
  {
    std::ostringstream text;
    text << "Spacing is " << spacing << " mm; it must be above 0";
    Refuse(text.str());
  }
  if (glm::any(glm::lessThan(box.high, box.low)))
    return {};
  hasp::GridGeometry grid;
  grid.spacing = glm::dvec3(spacing);
  grid.origin = box.low - Border * spacing;
  for (int a = 0; a < 3; ++a)
  {
    const double cells = std::ceil((box.high[a] - box.low[a]) / spacing + 2.0 * Border);
    if (!std::isfinite(cells) || !std::isfinite(grid.origin[a]))
      Refuse(std::string("the solid has no end along ") + "xyz"[a] + ": SetBounds");
    if (!(cells < std::numeric_limits<int>::max()))
      Refuse(std::string("too many cells along ") + "xyz"[a] + ": set a larger Spacing");
    grid.dims[a] = static_cast<int>(cells) + 1;
  }
  return grid;
}

vtkSmartPointer<vtkImageData> SampleAll(const hasp::ImplicitSolid& solid,
  const hasp::GridGeometry& grid, hasp::NearSurface& near, const hasp::ProgressFunction& progress)
{
  grid.Validate();
  if (grid.Size() > MostSamples)
    Refuse("FlyingEdges would take " + std::to_string(grid.Size()) + " samples, over " +
           std::to_string(MostSamples) + ": set a larger Spacing, or SetMethodToSharpContour");
  near = hasp::EvaluateNearSurface(solid, grid, 3.0 * grid.spacing.x, progress);
  std::vector<float> depth = hasp::DenseValues(near);
  for (float& value : depth)
    value = -value; // Flying Edges looks outward where values fall
  return hasp::MakeImage(grid, depth);
}

} // namespace

struct vtkHaspSharpContour::Internals
{
  hasp::SolidInputs inputs;

  static void Sharp(vtkHaspSharpContour& self, const hasp::ImplicitSolid& solid,
    const hasp::GridGeometry& grid, vtkPolyData* output, const hasp::ProgressFunction& progress)
  {
    hasp::SharpContourFacts facts;
    hasp::SharpContourSettings settings;
    settings.tolerance = self.Tolerance;
    settings.mostTriangles =
      static_cast<std::size_t>(std::max<vtkIdType>(self.MaximumNumberOfTriangles, 0));
    output->ShallowCopy(
      hasp::MakePolyData(hasp::SharpContour(solid, grid, settings, &facts, progress)));
    self.NumberOfBlocks = static_cast<vtkIdType>(facts.blocks);
    self.NumberOfBlocksHeld = static_cast<vtkIdType>(facts.blocksHeld);
  }

  static void Plain(vtkHaspSharpContour& self, const hasp::ImplicitSolid& solid,
    const hasp::GridGeometry& grid, vtkPolyData* output, const hasp::ProgressFunction& progress)
  {
    hasp::NearSurface near;
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(SampleAll(solid, grid, near, progress));
    contour->SetValue(0, 0.0);
    contour->ComputeNormalsOff();
    contour->ComputeGradientsOff();
    contour->ComputeScalarsOff();
    contour->Update();
    output->ShallowCopy(contour->GetOutput());
    self.NumberOfBlocks = static_cast<vtkIdType>(near.sides.size());
    self.NumberOfBlocksHeld = static_cast<vtkIdType>(near.near.size());
  }
};

vtkHaspSharpContour::vtkHaspSharpContour() : Inside(new Internals) {}
vtkHaspSharpContour::~vtkHaspSharpContour() = default;

int vtkHaspSharpContour::FillInputPortInformation(int, vtkInformation* info)
{
  hasp::SolidInputs::Accept(info);
  return 1;
}

int vtkHaspSharpContour::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  this->NumberOfBlocks = this->NumberOfBlocksHeld = 0;
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      const hasp::SolidPointer solid = CutOff(this->Inside->inputs.Get(inputs[0])[0], this->Bounds);
      if (const auto grid = GridAround(solid->Bounds(), this->Spacing))
        (this->Method == FlyingEdges ? Internals::Plain : Internals::Sharp)(
          *this, *solid, *grid, output, progress);
      if (output->GetNumberOfCells() == 0)
        vtkWarningMacro("the surface is empty: nothing of the solid is inside the bounds, or it is "
                        << "thinner than the spacing of " << this->Spacing << " mm");
    });
}

void vtkHaspSharpContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const double* b = this->Bounds;
  os << indent << "Method: " << (this->Method == FlyingEdges ? "Flying Edges" : "sharp contour")
     << "\n"
     << indent << "Spacing: " << this->Spacing << "\n"
     << indent << "Bounds: " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " " << b[4]
     << " " << b[5] << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "MaximumNumberOfTriangles: " << this->MaximumNumberOfTriangles << "\n"
     << indent << "NumberOfBlocks: " << this->NumberOfBlocks << "\n"
     << indent << "NumberOfBlocksHeld: " << this->NumberOfBlocksHeld << "\n";
}
