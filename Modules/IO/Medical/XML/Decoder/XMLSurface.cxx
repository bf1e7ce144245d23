#include "QuietReader.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <vector>

using hasp::XMLStatus;
using hasp::XMLSurfaceRecord;
using SurfaceReader = QuietReader<vtkXMLPolyDataReader>;

namespace
{

template <typename Visit>
void ForEachCell(vtkCellArray* cells, const Visit& visit)
{
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cell->GetCurrentCell(count, points);
    visit(count, points);
  }
}

/// 3D Slicer says it in the field data. Nothing else of that comes over: it may hold names.
void TakeSpace(vtkPolyData* surface, XMLSurfaceRecord& record)
{
  const auto* space =
    vtkStringArray::SafeDownCast(surface->GetFieldData()->GetAbstractArray("SPACE"));
  if (!space || const_cast<vtkStringArray*>(space)->GetNumberOfValues() < 1)
    return;
  const std::string said = const_cast<vtkStringArray*>(space)->GetValue(0);
  record.saysLps = said == "LPS";
  record.saysRas = said == "RAS";
  record.saysOther = !record.saysLps && !record.saysRas;
}

XMLSurfaceRecord Describe(vtkPolyData* surface)
{
  XMLSurfaceRecord record{};
  const bool narrow = surface->GetPoints() && surface->GetPoints()->GetDataType() == VTK_FLOAT;
  record.coordinateBytes = narrow ? 4 : 8;
  record.points = surface->GetNumberOfPoints();
  record.faces = surface->GetNumberOfPolys();
  record.corners = surface->GetPolys()->GetNumberOfConnectivityIds();
  ForEachCell(surface->GetStrips(),
    [&](vtkIdType count, const vtkIdType*)
    {
      record.faces += std::max<vtkIdType>(0, count - 2);
      record.corners += 3 * std::max<vtkIdType>(0, count - 2);
    });
  record.otherCells = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  TakeSpace(surface, record);
  return record;
}

void WritePoints(vtkPoints* points, bool narrow)
{
  if (!points)
    return;
  const vtkIdType count = points->GetNumberOfPoints();
  const int type = points->GetDataType();
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
    return Write(points->GetVoidPointer(0), std::size_t(3) * count * (narrow ? 4 : 8));
  for (vtkIdType n = 0; n < count; ++n)
    Write(points->GetPoint(n), 3 * sizeof(double));
}

/// A point that does not fit is sent as one that is not there, and so refused.
std::uint32_t Corner(vtkIdType point)
{
  return point >= 0 && point < 0xFFFFFFFF ? static_cast<std::uint32_t>(point) : 0xFFFFFFFF;
}

void WriteFaces(vtkPolyData* surface)
{
  std::vector<std::uint32_t> words;
  ForEachCell(surface->GetPolys(),
    [&](vtkIdType count, const vtkIdType* points)
    {
      words.assign(1, static_cast<std::uint32_t>(count));
      std::transform(points, points + count, std::back_inserter(words), Corner);
      Write(words.data(), words.size() * sizeof(words[0]));
    });
  ForEachCell(surface->GetStrips(),
    [&](vtkIdType count, const vtkIdType* points)
    {
      for (vtkIdType n = 0; n + 2 < count; ++n) // every second one runs the other way round
      {
        const std::uint32_t triangle[] = { 3, Corner(points[n + n % 2]),
          Corner(points[n + 1 - n % 2]), Corner(points[n + 2]) };
        Write(triangle, sizeof(triangle));
      }
    });
}

} // namespace

int WriteSurface(BeatingFile& file)
{
  vtkNew<SurfaceReader> reader;
  reader->SetFile(&file);
  reader->UpdateInformation();
  // Points and cells alone: nobody has checked how large other arrays are.
  reader->GetCellDataArraySelection()->DisableAllArrays();
  reader->GetPointDataArraySelection()->DisableAllArrays();
  if (!reader->HasFailed())
    reader->Update();
  XMLSurfaceRecord record{};
  const bool bad = reader->HasFailed() || !reader->GetOutput()->GetPolys()->IsValid() ||
                   !reader->GetOutput()->GetStrips()->IsValid();
  if (bad)
    record.status = static_cast<std::uint32_t>(XMLStatus::Damaged);
  else
    record = Describe(reader->GetOutput());
  WriteFrame(hasp::XMLFrame::Answer, 1.0);
  Write(&record, sizeof(record));
  if (!bad)
  {
    WritePoints(reader->GetOutput()->GetPoints(), record.coordinateBytes == 4);
    WriteFaces(reader->GetOutput());
  }
  return 0;
}
