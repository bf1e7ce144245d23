#include "Volumes/VolumeFormat.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"

#include <stdexcept>

namespace hasp
{
namespace
{

/// VTK's reader with its errors caught instead of printed.
class QuietReader
{
public:
  explicit QuietReader(const std::filesystem::path& file) : File(file)
  {
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&this->Failed);
    note->SetCallback(
      [](vtkObject*, unsigned long, void* failed, void*) { *static_cast<bool*>(failed) = true; });
    this->Reader->SetFileName(file.c_str());
    this->Reader->AddObserver(vtkCommand::ErrorEvent, note);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, note);
    // The XML parser inside tells its errors here.
    this->Reader->SetParserErrorObserver(note);
    this->Reader->SetReaderErrorObserver(note);
  }
  vtkXMLImageDataReader* operator->() { return this->Reader; }
  void Check() const
  {
    if (this->Failed || this->Reader->GetErrorCode() != 0)
      ThrowFileError(this->File, "is damaged or no VTK image file (.vti); write it again");
  }

private:
  std::filesystem::path File;
  bool Failed = false;
  vtkNew<vtkXMLImageDataReader> Reader;
};

vtkSmartPointer<vtkImageData> Load(
  const std::filesystem::path& file, const GridGeometry& geometry, const ProgressFunction& progress)
{
  ReportProgress(progress, 0.0);
  QuietReader reader(file);
  // The samples alone: nobody has checked how large other arrays are, and field data may hold the
  // patient's name.
  reader->UpdateInformation();
  vtkInformation* scalarsInfo =
    vtkDataObject::GetActiveFieldInformation(reader->GetOutputInformation(0),
      vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  const char* samples = scalarsInfo ? scalarsInfo->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  reader->GetCellDataArraySelection()->DisableAllArrays();
  reader->GetPointDataArraySelection()->DisableAllArrays();
  reader->GetPointDataArraySelection()->EnableArray(samples);
  reader->Update();
  reader.Check();
  vtkDataArray* scalars = reader->GetOutput()->GetPointData()->GetScalars();
  if (!scalars || std::size_t(scalars->GetNumberOfTuples()) != geometry.Size())
    ThrowFileError(file, "its samples do not fill the extent it declares");
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->CopyStructure(reader->GetOutput());
  image->GetPointData()->SetScalars(scalars);
  const glm::ivec3 last = geometry.dims - 1;
  image->SetExtent(0, last.x, 0, last.y, 0, last.z); // the geometry's origin is sample (0,0,0)
  image->SetOrigin(geometry.origin.x, geometry.origin.y, geometry.origin.z);
  return image;
}

} // namespace

OpenedVolume OpenXMLImage(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  QuietReader reader(file);
  reader->UpdateInformation();
  reader.Check();
  vtkInformation* info = reader->GetOutputInformation(0);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  std::int64_t n[3];
  for (int a = 0; a < 3; ++a)
    n[a] = std::int64_t(extent[2 * a + 1]) - extent[2 * a] + 1;
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    info, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (!scalars)
    ThrowFileError(file, "has no active point scalars");
  const int type = scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE());
  const int components = scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS())
                           ? scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS())
                           : 1;
  if (components != 1 || SampleTypeName(type).empty())
    ThrowFileError(
      file, "has scalars of " + std::to_string(components) + " components and type " +
              vtkImageScalarTypeNameMacro(type) +
              "; one component of short, unsigned short, unsigned char or float is read");
  CheckSampleBytes(
    file, n[0], n[1], n[2], vtkDataArray::GetDataTypeSize(type), settings.memoryLimitBytes);
  // An image without samples, so that one function turns VTK's geometry into ours.
  vtkNew<vtkImageData> frame;
  frame->SetExtent(extent);
  frame->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  frame->SetSpacing(info->Get(vtkDataObject::SPACING()));
  if (info->Has(vtkDataObject::DIRECTION()))
    frame->SetDirectionMatrix(info->Get(vtkDataObject::DIRECTION()));
  OpenedVolume opened;
  opened.passport.format = "VTI";
  try
  {
    opened.passport.geometry = ImageGeometry(frame);
  }
  catch (const std::invalid_argument& error)
  {
    ThrowFileError(file, error.what());
  }
  opened.passport.sampleType = SampleTypeName(type);
  opened.load = [file, geometry = opened.passport.geometry](const ProgressFunction& progress)
  { return Load(file, geometry, progress); };
  return opened;
}

} // namespace hasp
