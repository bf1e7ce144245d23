#include "SeedFiles.h"

#include "vtkHaspDicomOutput.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/oflog/oflog.h>

#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

void WriteAs(
  const std::filesystem::path& from, const std::filesystem::path& to, E_TransferSyntax syntax)
{
  DcmFileFormat file;
  if (file.loadFile(OFFilename(from.c_str())).bad() ||
      file.getDataset()->chooseRepresentation(syntax, nullptr).bad() ||
      file.saveFile(OFFilename(to.c_str()), syntax).bad())
    throw std::runtime_error("a DICOM seed cannot be written");
}

} // namespace

void MakeDicomSeeds(const std::filesystem::path& folder)
{
  GridGeometry grid;
  grid.dims = { 16, 12, 5 };
  grid.spacing = { 0.5, 0.75, 1.25 };
  std::vector<std::int16_t> samples(grid.Size());
  for (std::size_t n = 0; n < samples.size(); ++n)
    samples[n] = static_cast<std::int16_t>(n % 251);
  WriteDicomSeries(MakeImage(grid, samples), folder / "plain", { .modality = "CT" });
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  DcmRLEEncoderRegistration::registerCodecs();
  DJEncoderRegistration::registerCodecs();
  DJLSEncoderRegistration::registerCodecs();
  int count = 0;
  for (const E_TransferSyntax syntax :
    { EXS_LittleEndianExplicit, EXS_LittleEndianImplicit, EXS_BigEndianExplicit,
      EXS_DeflatedLittleEndianExplicit, EXS_RLELossless, EXS_JPEGProcess14SV1, EXS_JPEGLSLossless })
    WriteAs(folder / "plain" / "slice-00003.dcm",
      folder / ("packed" + std::to_string(++count) + ".dcm"), syntax);
}

} // namespace hasp
