// Scalar colours of vtkHaspClusteredCellMapper: vtkMapper maps them, for the stored corners alone.
#include "ClusteredCellAttributes.h"

#include "Isosurface/CellAttributes.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>

namespace
{

/// Point data in which `array` is replaced, among empty ones, so that a scalar mode finds it by
/// whichever way it is asked for.
vtkSmartPointer<vtkPolyData> Replace(
  vtkPointData* data, vtkAbstractArray* array, vtkDataArray* replacement)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* from = data->GetAbstractArray(n);
    vtkSmartPointer<vtkAbstractArray> to = replacement;
    if (from != array)
      to.TakeReference(from->NewInstance());
    to->SetName(from->GetName());
    result->GetPointData()->AddArray(to);
    if (from == data->GetScalars())
      result->GetPointData()->SetActiveAttribute(n, vtkDataSetAttributes::SCALARS);
  }
  return result;
}

std::uint32_t Pack(const unsigned char* color, int components) // grey, grey and alpha, RGB or RGBA
{
  const std::uint32_t alpha = components % 2 == 0 ? color[components - 1] : 255;
  const int step = components >= 3 ? 1 : 0;
  return color[0] | color[step] << 8 | color[2 * step] << 16 | alpha << 24;
}

void PackAll(vtkUnsignedCharArray* from, std::span<std::uint32_t> to)
{
  const int components = from->GetNumberOfComponents();
  for (std::size_t n = 0; n < to.size(); ++n)
    to[n] = Pack(from->GetPointer(static_cast<vtkIdType>(n) * components), components);
}

/// The first row of a colour texture, and the colour of NaN: that of the second row.
std::vector<std::uint32_t> Table(vtkImageData* texture)
{
  auto* colors = vtkUnsignedCharArray::SafeDownCast(texture->GetPointData()->GetScalars());
  const int width = texture->GetDimensions()[0];
  std::vector<std::uint32_t> table(width + 1);
  PackAll(colors, { table.data(), static_cast<std::size_t>(width) });
  const int components = colors->GetNumberOfComponents();
  table.back() =
    Pack(colors->GetPointer((colors->GetNumberOfTuples() - 1) * components), components);
  return table;
}

/// Texture coordinates (place, row) as places in the table; NaN in the second row.
void PackCoordinates(vtkFloatArray* from, std::span<std::uint32_t> to)
{
  for (std::size_t n = 0; n < to.size(); ++n)
  {
    float place[2];
    from->GetTypedTuple(static_cast<vtkIdType>(n), place);
    to[n] = std::bit_cast<std::uint32_t>(
      place[1] > 0.5F ? std::numeric_limits<float>::quiet_NaN() : place[0]);
  }
}

/// As the shader does.
std::uint32_t LookUp(const std::vector<std::uint32_t>& table, std::uint32_t place)
{
  const auto size = static_cast<float>(table.size() - 1);
  const float at = std::bit_cast<float>(place) * size;
  return at == at ? table[static_cast<std::size_t>(std::clamp(at, 0.0F, size - 1.0F))]
                  : table.back();
}

bool AnyAlpha(std::span<const std::uint32_t> colors)
{
  return std::any_of(
    colors.begin(), colors.end(), [](std::uint32_t color) { return color >> 24 != 255; });
}

} // namespace

vtkAbstractArray* vtkHaspClusteredCellMapper::FindColorArray(vtkImageData* image)
{
  int where = 0; // 1: cell data, 2: field data
  vtkAbstractArray* array = vtkAbstractMapper::GetAbstractScalars(
    image, this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, where);
  if (where != 0)
    throw std::invalid_argument(
      "cell and field data cannot colour an isosurface; use point data (scalar mode)");
  if (!array)
    throw std::invalid_argument("the image has no such point array to colour by; it has: " +
                                hasp::PointArrayNames(image->GetPointData()));
  return array;
}

void vtkHaspClusteredCellMapper::MapColors(vtkPointData* data, vtkAbstractArray* array,
  vtkDataArray* values, std::span<std::uint32_t> colors)
{
  if (auto* own = vtkDataArray::SafeDownCast(array); own && own->GetLookupTable())
    values->SetLookupTable(own->GetLookupTable());
  const auto corners = Replace(data, array, values);
  int where = 0;
  if (vtkUnsignedCharArray* mapped = this->Superclass::MapScalars(corners, 1.0, where))
    PackAll(mapped, colors);
  else if (this->ColorCoordinates && this->ColorTextureMap)
  {
    this->Attribute->Coloring.table = Table(this->ColorTextureMap);
    PackCoordinates(this->ColorCoordinates, colors);
  }
  else
    throw std::runtime_error("the scalars could not be mapped to colours");
  this->ClearColorArrays();
}

void vtkHaspClusteredCellMapper::ColorByDensity(vtkPointData* data, float isovalue)
{
  vtkNew<vtkDoubleArray> value;
  value->InsertNextValue(isovalue);
  std::uint32_t color = 0;
  this->MapColors(data, data->GetScalars(), value, { &color, 1 });
  hasp::CellColoring& coloring = this->Attribute->Coloring;
  if (!coloring.table.empty())
    color = LookUp(coloring.table, color);
  coloring.table = {};
  coloring.uniform =
    glm::vec4(color & 255, color >> 8 & 255, color >> 16 & 255, color >> 24) / 255.0F;
  coloring.translucent = coloring.uniform->a < 1.0F;
}

void vtkHaspClusteredCellMapper::ColorByArray(
  hasp::ClusteredCells& cells, vtkPointData* data, vtkAbstractArray* array)
{
  auto* scalars = vtkDataArray::SafeDownCast(array);
  if (!scalars || scalars->GetNumberOfTuples() != static_cast<vtkIdType>(cells.geometry.Size()))
    throw std::invalid_argument("the point array to colour by does not hold a number a point");
  const auto colorOf = [&](std::span<const std::int64_t> samples, std::span<std::uint32_t> colors)
  {
    vtkNew<vtkIdList> ids;
    ids->SetNumberOfIds(static_cast<vtkIdType>(samples.size()));
    std::copy(samples.begin(), samples.end(), ids->GetPointer(0));
    auto values = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
    values->SetNumberOfComponents(scalars->GetNumberOfComponents());
    values->SetNumberOfTuples(ids->GetNumberOfIds());
    scalars->GetTuples(ids, values);
    this->MapColors(data, array, values, colors);
  };
  hasp::AddColors(cells, colorOf);
  Attributes& own = *this->Attribute;
  own.ColorArray = scalars;
  own.Coloring.translucent =
    AnyAlpha(own.Coloring.table.empty() ? cells.colors : own.Coloring.table);
}

void vtkHaspClusteredCellMapper::UpdateColors(hasp::ClusteredCells& cells, vtkImageData* image)
{
  Attributes& own = *this->Attribute;
  if (own.ColoredCells == this->GetCellsTime() && own.ColorsTime == this->Superclass::GetMTime())
    return;
  if (!cells.colors.empty() || own.Coloring.uniform)
    own.Time.Modified();
  cells.colors = {};
  cells.firstColors = {};
  own.Coloring = {};
  own.ColorArray = nullptr;
  own.ColorsMilliseconds = 0.0;
  if (this->ScalarVisibility)
  {
    const hasp::Stopwatch watch;
    vtkAbstractArray* array = this->FindColorArray(image);
    if (array == image->GetPointData()->GetScalars())
      this->ColorByDensity(image->GetPointData(), cells.isovalue);
    else if (cells.Count() > 0)
      this->ColorByArray(cells, image->GetPointData(), array);
    own.Time.Modified();
    own.ColorsMilliseconds = watch.Milliseconds();
  }
  own.ColoredCells = this->GetCellsTime();
  own.ColorsTime = this->Superclass::GetMTime();
}

void vtkHaspClusteredCellMapper::UseColorsOf(const hasp::ClusteredCells& finished)
{
  Attributes& own = *this->Attribute;
  if (own.ColoredCells == this->GetCellsTime())
    return;
  own.Coloring = {};
  own.Coloring.translucent = AnyAlpha(finished.colors);
  own.ColorArray = nullptr;
  own.LabelsMilliseconds = own.ColorsMilliseconds = 0.0;
  own.ColoredCells = this->GetCellsTime();
  own.LabelledCells = 0;
  own.Time.Modified();
}
