#include "Files/AtomicFile.h"
#include "Volumes/VolumeFormat.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkXMLImageDataWriter.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace hasp
{
namespace
{

void WriteXML(const std::filesystem::path& file, vtkImageData* image)
{
  AtomicFile output(file);
  bool failed = false;
  vtkNew<vtkCallbackCommand> note; // catches VTK's error instead of printing it
  note->SetClientData(&failed);
  note->SetCallback(
    [](vtkObject*, unsigned long, void* flag, void*) { *static_cast<bool*>(flag) = true; });
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->AddObserver(vtkCommand::ErrorEvent, note);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, note);
  writer->SetFileName(output.TemporaryName().c_str());
  writer->SetInputData(image);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();  // raw bytes: a quarter smaller than base64
  writer->SetCompressorTypeToLZ4(); // 512 x 512 x 300 in 1 s, where zlib takes 10 s
  if (writer->Write() != 1 || failed || writer->GetErrorCode() != 0)
    ThrowFileError(
      file, "cannot be written (is the disk full?). The earlier file, if any, is unchanged");
  output.Commit();
}

const char* MetaType(const AnyGridView& grid)
{
  const char* const names[] = { "MET_SHORT", "MET_USHORT", "MET_UCHAR", "MET_FLOAT" };
  return names[grid.index()];
}

void WriteMeta(const std::filesystem::path& file, const AnyGridView& grid)
{
  const GridGeometry& g = GeometryOf(grid);
  std::ostringstream header;
  header.imbue(std::locale::classic());
  header.precision(std::numeric_limits<double>::max_digits10); // reads back bit by bit
  const auto three = [&](const char* key, const auto& v)
  { header << key << " = " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            "CompressedData = False\nTransformMatrix =";
  for (int a = 0; a < 3; ++a)
    for (int row = 0; row < 3; ++row)
      header << " " << g.direction[a][row];
  header << "\n";
  three("Offset", g.origin);
  three("ElementSpacing", g.spacing);
  three("DimSize", g.dims);
  header << "ElementType = " << MetaType(grid) << "\nElementDataFile = LOCAL\n";
  AtomicFile output(file);
  const std::string text = header.str();
  output.Write(text.data(), text.size());
  std::visit([&](const auto& view)
    { output.Write(view.data, view.geometry.Size() * sizeof(*view.data)); },
    grid);
  output.Commit();
}

} // namespace

void WriteVolume(vtkImageData* image, const std::string& path)
{
  const AnyGridView grid = ViewImage(image); // refuses what no reader of ours would take
  const std::filesystem::path file = std::filesystem::u8path(path);
  const std::string extension = LowerExtension(file);
  if (extension == ".vti")
    WriteXML(file, image);
  else if (extension == ".mha")
    WriteMeta(file, grid);
  else
    ThrowFileError(file, "volumes are written as .vti or .mha; give the name one of these endings");
}

} // namespace hasp
