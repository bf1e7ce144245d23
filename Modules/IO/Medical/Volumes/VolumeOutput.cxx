#include "Files/AtomicFile.h"
#include "Volumes/VolumeFormat.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeSlabs.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkXMLImageDataWriter.h"

#include <span>

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

} // namespace

void WriteVolume(vtkImageData* image, const std::string& path, const VolumeWriteSettings& settings)
{
  const AnyGridView grid = ViewImage(image); // refuses what no reader of ours would take
  const std::filesystem::path file = std::filesystem::u8path(path);
  if (LowerExtension(file) == ".vti")
    return WriteXML(file, image);
  std::visit(
    [&](const auto& view)
    {
      VolumeSlabWriter writer(
        path, view.geometry, static_cast<SampleType>(grid.index()), settings.compress);
      writer.Append(std::span(view.data, view.geometry.Size()));
      writer.Commit();
    },
    grid);
}

} // namespace hasp
