#include "QuietReader.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>

using hasp::XMLImageRecord;
using hasp::XMLStatus;
using ImageReader = QuietReader<vtkXMLImageDataReader>;

namespace
{

void Copy(vtkInformation* info, vtkInformationDoubleVectorKey* key, double* into, int count)
{
  if (info->Has(key) && info->Length(key) == count)
    std::copy_n(info->Get(key), count, into);
}

XMLStatus Describe(ImageReader* reader, XMLImageRecord& record, const char*& samples)
{
  reader->UpdateInformation();
  if (reader->HasFailed())
    return XMLStatus::Damaged;
  vtkInformation* info = reader->GetOutputInformation(0);
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    info, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  samples = scalars ? scalars->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  if (!samples)
    return XMLStatus::NoScalars;
  if (!info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    return XMLStatus::Damaged;
  info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), record.extent);
  record.vtkType = scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE());
  record.components = scalars->Has(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS())
                        ? scalars->Get(vtkDataObject::FIELD_NUMBER_OF_COMPONENTS())
                        : 1;
  Copy(info, vtkDataObject::ORIGIN(), record.origin, 3);
  Copy(info, vtkDataObject::SPACING(), record.spacing, 3);
  record.direction[0] = record.direction[4] = record.direction[8] = 1.0;
  Copy(info, vtkDataObject::DIRECTION(), record.direction, 9);
  return XMLStatus::Good;
}

/// The samples alone: nobody has checked how large other arrays are.
vtkDataArray* Samples(ImageReader* reader, const char* name)
{
  reader->GetCellDataArraySelection()->DisableAllArrays();
  reader->GetPointDataArraySelection()->DisableAllArrays();
  reader->GetPointDataArraySelection()->EnableArray(name);
  reader->Update();
  return reader->HasFailed() ? nullptr : reader->GetOutput()->GetPointData()->GetScalars();
}

} // namespace

int WriteImage(BeatingFile& file, bool withSamples)
{
  vtkNew<ImageReader> reader;
  reader->SetFile(&file);
  XMLImageRecord record{};
  const char* name = nullptr;
  XMLStatus status = Describe(reader, record, name);
  vtkDataArray* samples = nullptr;
  if (status == XMLStatus::Good && withSamples)
  {
    samples = Samples(reader, name);
    double points = 1.0;
    for (int a = 0; a < 3; ++a)
      points *= double(record.extent[2 * a + 1]) - double(record.extent[2 * a]) + 1.0;
    status = reader->HasFailed() ? XMLStatus::Damaged
             : !samples || double(samples->GetNumberOfTuples()) != points ||
                 samples->GetDataType() != record.vtkType || samples->GetNumberOfComponents() != 1
               ? XMLStatus::TooFew
               : XMLStatus::Good;
  }
  if (status != XMLStatus::Good)
    record = {};
  record.status = static_cast<std::uint32_t>(status);
  const bool good = status == XMLStatus::Good && samples;
  if (good)
    record.sampleBytes =
      static_cast<std::uint64_t>(samples->GetNumberOfValues()) * samples->GetDataTypeSize();
  WriteFrame(hasp::XMLFrame::Answer, 1.0);
  Write(&record, sizeof(record));
  if (good)
    Write(samples->GetVoidPointer(0), record.sampleBytes);
  return 0;
}
