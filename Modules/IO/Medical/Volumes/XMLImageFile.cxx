#include "Volumes/VolumeFormat.h"
#include "XML/XMLProcess.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <stdexcept>

namespace hasp
{
namespace
{

/// The child may take the samples four times over: packed, unpacked, turned, and room to grow.
XMLProcess::Limits LimitsOf(const VolumeReadSettings& settings, std::size_t sampleBytes)
{
  return { XMLProcess::RoomBytes + 4 * sampleBytes, settings.decoderSilenceSeconds,
    settings.decoderTotalSeconds, ". Is it damaged? Write it again, or crop or resample the scan" };
}

void CheckStatus(const std::filesystem::path& file, std::uint32_t status)
{
  if (status == static_cast<std::uint32_t>(XMLStatus::NoScalars))
    ThrowFileError(file, "has no active point scalars");
  if (status == static_cast<std::uint32_t>(XMLStatus::TooFew))
    ThrowFileError(file, "its samples do not fill the extent it declares");
  if (status != static_cast<std::uint32_t>(XMLStatus::Good))
    ThrowFileError(file, "is damaged or no VTK image file (.vti); write it again");
}

/// Of a record whose type is one that is read. `limitBytes` of the samples.
std::size_t BytesOf(
  const std::filesystem::path& file, const XMLImageRecord& record, std::size_t limitBytes)
{
  std::int64_t n[3];
  for (int a = 0; a < 3; ++a)
    n[a] = std::int64_t(record.extent[2 * a + 1]) - record.extent[2 * a] + 1;
  return CheckSampleBytes(
    file, n[0], n[1], n[2], vtkDataArray::GetDataTypeSize(record.vtkType), limitBytes);
}

GridGeometry GeometryOf(const std::filesystem::path& file, const XMLImageRecord& record)
{
  // An image without samples, so that one function turns VTK's geometry into ours.
  vtkNew<vtkImageData> frame;
  frame->SetExtent(record.extent[0], record.extent[1], record.extent[2], record.extent[3],
    record.extent[4], record.extent[5]);
  frame->SetOrigin(record.origin[0], record.origin[1], record.origin[2]);
  frame->SetSpacing(record.spacing[0], record.spacing[1], record.spacing[2]);
  double direction[9];
  std::copy(std::begin(record.direction), std::end(record.direction), direction);
  frame->SetDirectionMatrix(direction);
  try
  {
    return ImageGeometry(frame);
  }
  catch (const std::invalid_argument& error)
  {
    ThrowFileError(file, error.what());
  }
}

vtkSmartPointer<vtkImageData> Load(const std::filesystem::path& file, const GridGeometry& geometry,
  int vtkType, const VolumeReadSettings& settings, const ProgressFunction& progress)
{
  ReportProgress(progress, 0.0);
  const std::size_t bytes = geometry.Size() * vtkDataArray::GetDataTypeSize(vtkType);
  XMLProcess process(XMLProcess::Vtk, "image", file, LimitsOf(settings, bytes), progress);
  const auto record = process.Answer<XMLImageRecord>();
  CheckStatus(file, record.status);
  if (record.vtkType != vtkType || record.sampleBytes != bytes)
    ThrowFileError(file, "is another than when it was opened; open it again");
  const auto image = NewImage(geometry, vtkType);
  process.Read(image->GetScalarPointer(), bytes);
  process.Finish();
  return image;
}

} // namespace

OpenedVolume OpenXMLImage(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  XMLProcess process(XMLProcess::Vtk, "image-header", file, LimitsOf(settings, 0), {});
  const auto record = process.Answer<XMLImageRecord>();
  process.Finish();
  CheckStatus(file, record.status);
  if (record.components != 1 || SampleTypeName(record.vtkType).empty())
    ThrowFileError(
      file, "has scalars of " + std::to_string(record.components) + " components and type " +
              vtkImageScalarTypeNameMacro(record.vtkType) +
              "; one component of short, unsigned short, unsigned char or float is read");
  BytesOf(file, record, settings.memoryLimitBytes);
  OpenedVolume opened;
  opened.passport.format = "VTI";
  opened.passport.geometry = GeometryOf(file, record);
  opened.passport.sampleType = SampleTypeName(record.vtkType);
  opened.load = [file, geometry = opened.passport.geometry, type = record.vtkType, settings](
                  const ProgressFunction& progress, Passport&)
  { return Load(file, geometry, type, settings, progress); };
  return opened;
}

} // namespace hasp
