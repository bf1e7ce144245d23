#include "Dicom/ContentUid.h"
#include "Dicom/StoredValues.h"
#include "Files/FileError.h"
#include "Files/TemporaryFolder.h"
#include "vtkHaspDicomOutput.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDICOMCompiler.h"
#include "vtkDICOMMetaData.h"
#include "vtkDICOMVR.h"
#include "vtkDICOMValue.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace hasp
{
namespace
{

constexpr int MostSlices = 99999;
constexpr const char* ComputedTomography = "1.2.840.10008.5.1.4.1.1.2";
constexpr const char* MagneticResonance = "1.2.840.10008.5.1.4.1.1.4";
constexpr const char* SecondaryCapture = "1.2.840.10008.5.1.4.1.1.7";

void Check(const GridGeometry& g, const DicomOutputSettings& s)
{
  if (s.hounsfield && s.modality != "CT")
    throw std::invalid_argument("DICOM settings: only values of a CT are HU");
  if (!(s.sliceThicknessMm >= 0.0 && std::isfinite(s.sliceThicknessMm)) ||
      !(s.kVp >= 0.0 && std::isfinite(s.kVp)))
    throw std::invalid_argument("DICOM settings: sliceThicknessMm is " + Text(s.sliceThicknessMm) +
                                ", kVp is " + Text(s.kVp) + ", both must be finite and >= 0");
  if (g.dims.z < 2 || g.dims.z > MostSlices)
    throw std::invalid_argument("volume: has " + std::to_string(g.dims.z) +
                                " slices, a DICOM series has 2 to " + std::to_string(MostSlices));
  if (g.dims.x > 65535 || g.dims.y > 65535)
    throw std::invalid_argument("volume: has slices of " + std::to_string(g.dims.x) + " x " +
                                std::to_string(g.dims.y) + " samples, DICOM holds 65535 x 65535");
}

/// One series: what its slices share, and each slice's own attributes.
class Series
{
public:
  Series(AnyGridView grid, const DicomOutputSettings& settings)
    : Grid(std::move(grid)),
      Geometry(GeometryOf(this->Grid)),
      Settings(settings),
      Stored(ChooseStoredValues(this->Grid)),
      Pixels(std::size_t(this->Geometry.dims.x) * this->Geometry.dims.y)
  {
    // Slices go along row x column. Where the third axis runs the other way, the last comes first.
    this->Backward = glm::determinant(this->Geometry.direction) < 0.0;
  }

  const StoredValues& Storage() const { return this->Stored; }
  const char* Class() const
  {
    return this->Settings.modality == "CT"   ? ComputedTomography
           : this->Settings.modality == "MR" ? MagneticResonance
                                             : SecondaryCapture;
  }
  const std::vector<std::uint16_t>& PixelsOf(int slice)
  {
    StoreSlice(this->Grid, this->Stored, this->IndexOf(slice), this->Pixels);
    return this->Pixels;
  }
  /// Everything that will be written goes into the UIDs.
  void MakeUids(const ProgressFunction& progress)
  {
    vtkNew<vtkDICOMMetaData> shared;
    for (int n = 0; n < this->Geometry.dims.z; ++n)
    {
      const auto& pixels = this->PixelsOf(n);
      this->Uids.Add(pixels.data(), pixels.size() * sizeof(pixels[0]));
      this->Uids.Add(this->PositionOf(n));
      ReportProgress(progress, 0.4 * (n + 1) / this->Geometry.dims.z);
    }
    this->Describe(shared);
    for (auto at = shared->Begin(); at != shared->End(); ++at)
      this->Uids.Add(at->GetValue().AsString());
    this->Uids.Finish();
  }
  void Identify(vtkDICOMMetaData* data, int slice) const
  {
    data->Set(DC::SOPInstanceUID, this->Uids.Uid("slice " + std::to_string(slice)));
    data->Set(DC::StudyInstanceUID, this->Uids.Uid("study"));
    data->Set(DC::SeriesInstanceUID, this->Uids.Uid("series"));
    data->Set(DC::FrameOfReferenceUID, this->Uids.Uid("frame"));
    data->Set(DC::PatientID, "HASP-" + this->Uids.Short());
    data->Set(DC::InstanceNumber, std::to_string(slice + 1));
    data->Set(DC::ImagePositionPatient, this->PositionOf(slice));
  }
  /// The attributes that all slices share. Utilities/Docs/Privacy.md lists all of them.
  void Describe(vtkDICOMMetaData* data) const
  {
    const GridGeometry& g = this->Geometry;
    const glm::dvec3 &x = g.direction[0], &y = g.direction[1];
    for (const auto tag : { DC::PatientName, DC::PatientBirthDate, DC::PatientSex, DC::StudyDate,
           DC::StudyTime, DC::StudyID, DC::AccessionNumber, DC::Laterality, DC::PatientOrientation,
           DC::ReferringPhysicianName, DC::PositionReferenceIndicator })
      data->Set(tag, "");
    data->Set(DC::SOPClassUID, this->Class());
    data->Set(DC::PatientIdentityRemoved, "YES");
    data->Set(DC::DeidentificationMethod, "Hasp: written anew from samples and geometry");
    data->Set(DC::Manufacturer, "Hasp");
    data->Set(DC::SoftwareVersions, HASP_VERSION);
    data->Set(DC::SeriesNumber, "1");
    data->Set(DC::ImageOrientationPatient, Decimals({ x.x, x.y, x.z, y.x, y.y, y.z }));
    data->Set(DC::PixelSpacing, Decimals({ g.spacing.y, g.spacing.x }));
    // Empty is allowed, but vtkDICOMImageReader of VTK 9.1 ends the process on it.
    data->Set(DC::SliceThickness,
      Decimals(
        { this->Settings.sliceThicknessMm > 0.0 ? this->Settings.sliceThicknessMm : g.spacing.z }));
    data->Set(DC::SpacingBetweenSlices, Decimals({ g.spacing.z }));
    data->Set(DC::SamplesPerPixel, 1.0);
    data->Set(DC::PhotometricInterpretation, "MONOCHROME2");
    data->Set(DC::Rows, double(g.dims.y));
    data->Set(DC::Columns, double(g.dims.x));
    data->Set(DC::BitsAllocated, 16.0);
    data->Set(DC::BitsStored, 16.0);
    data->Set(DC::HighBit, 15.0);
    data->Set(DC::PixelRepresentation, this->Stored.isSigned ? 1.0 : 0.0);
    data->Set(DC::PixelData, vtkDICOMValue(vtkDICOMVR::OW)); // its place; the values follow
    // The standard asks a CT for it; other images need it only where it changes something.
    if (this->Settings.modality == "CT" || this->Stored.slope != 1.0 ||
        this->Stored.intercept != 0.0)
    {
      data->Set(DC::RescaleIntercept, Decimals({ this->Stored.intercept }));
      data->Set(DC::RescaleSlope, Decimals({ this->Stored.slope }));
      data->Set(DC::RescaleType, this->Settings.hounsfield ? "HU" : "US"); // US: unspecified
    }
    if (this->Settings.slicesMade > 0)
      data->Set(DC::DerivationDescription,
        "Resampled: " + std::to_string(this->Settings.slicesMade) + " of " +
          std::to_string(g.dims.z) + " slices made from their neighbours; " +
          (this->Settings.madeErrorMm > 0.0
              ? "95 % of surfaces within " + Text(this->Settings.madeErrorMm) + " mm"
              : "error not known"));
    if (this->Settings.knownNotBurnedIn)
      data->Set(DC::BurnedInAnnotation, "NO");
    this->DescribeModality(data);
  }

private:
  static std::string Decimals(std::initializer_list<double> numbers)
  {
    std::string text;
    for (const double number : numbers)
    {
      if (!text.empty())
        text += '\\';
      text += DecimalString(number == 0.0 ? 0.0 : number); // no -0
    }
    return text;
  }
  static std::string Known(double value) { return value > 0.0 ? Decimals({ value }) : ""; }
  int IndexOf(int slice) const
  {
    return this->Backward ? this->Geometry.dims.z - 1 - slice : slice;
  }
  std::string PositionOf(int slice) const
  {
    const glm::dvec3 p = this->Geometry.IndexToWorld({ 0.0, 0.0, double(this->IndexOf(slice)) });
    return Decimals({ p.x, p.y, p.z });
  }
  /// What the standard asks of each kind of image, empty where it may be.
  void DescribeModality(vtkDICOMMetaData* data) const
  {
    const std::string& modality = this->Settings.modality;
    const bool known = modality == "CT" || modality == "MR";
    data->Set(DC::Modality, known ? modality : "OT");
    if (!known)
    {
      data->Set(DC::ConversionType, "WSD"); // made on a workstation
      return;
    }
    data->Set(
      DC::ImageType, modality == "CT" ? "DERIVED\\SECONDARY\\AXIAL" : "DERIVED\\SECONDARY\\OTHER");
    data->Set(DC::PatientPosition, "");
    data->Set(DC::AcquisitionNumber, "");
    if (modality == "CT")
      data->Set(DC::KVP, Known(this->Settings.kVp));
    else
    {
      data->Set(DC::ScanningSequence, "RM"); // research mode: how it was scanned is not known
      data->Set(DC::SequenceVariant, "NONE");
      for (const auto tag : { DC::ScanOptions, DC::MRAcquisitionType, DC::RepetitionTime,
             DC::EchoTime, DC::EchoTrainLength })
        data->Set(tag, "");
    }
  }

  const AnyGridView Grid;
  const GridGeometry Geometry;
  const DicomOutputSettings Settings;
  const StoredValues Stored;
  bool Backward = false;
  std::vector<std::uint16_t> Pixels;
  ContentUid Uids;
};

std::string Label(const std::filesystem::path& folder)
{
  return FileNamesShown() ? FileLabel(folder) : "the folder of slices";
}

void WriteSlice(Series& series, int slice, const std::filesystem::path& file, bool& failed)
{
  vtkNew<vtkDICOMMetaData> data;
  series.Describe(data);
  series.Identify(data, slice);
  const auto& pixels = series.PixelsOf(slice);
  vtkNew<vtkCallbackCommand> note; // catches VTK's error, which names the file
  note->SetClientData(&failed);
  note->SetCallback(
    [](vtkObject*, unsigned long, void* flag, void*) { *static_cast<bool*>(flag) = true; });
  vtkNew<vtkDICOMCompiler> compiler;
  compiler->AddObserver(vtkCommand::ErrorEvent, note);
  compiler->SetFileName(file.c_str());
  compiler->SetMetaData(data);
  compiler->SetSOPInstanceUID(data->Get(DC::SOPInstanceUID).GetCharData());
  compiler->SetSeriesInstanceUID(data->Get(DC::SeriesInstanceUID).GetCharData());
  compiler->SetStudyInstanceUID(data->Get(DC::StudyInstanceUID).GetCharData());
  compiler->SetSourceApplicationEntityTitle("HASP");
  compiler->WriteHeader();
  compiler->WritePixelData(reinterpret_cast<const unsigned char*>(pixels.data()),
    static_cast<vtkIdType>(pixels.size() * sizeof(pixels[0])));
  compiler->Close();
  failed = failed || compiler->GetErrorCode() != 0;
}

} // namespace

DicomOutput WriteDicomSeries(vtkImageData* image, const std::string& folder,
  const DicomOutputSettings& settings, const ProgressFunction& progress)
{
  const AnyGridView grid = ViewImage(image);
  Check(GeometryOf(grid), settings);
  const auto target = std::filesystem::u8path(folder);
  std::error_code error;
  if (std::filesystem::exists(target, error) &&
      !(std::filesystem::is_directory(target, error) && std::filesystem::is_empty(target, error)))
    throw std::runtime_error(Label(target) +
                             ": cannot be written: there is a file of this name, or "
                             "a folder that is not empty; name another");
  Series series(grid, settings);
  const StoredValues& stored = series.Storage();
  if (stored.error > 0.0 && !settings.allowQuantisation)
    throw std::invalid_argument(
      "volume: DICOM stores 65536 levels; these samples would be changed by up to " +
      Text(stored.error) +
      " grey values. Allow that (--quantise, or allowQuantisation), or choose a format that "
      "keeps float");
  series.MakeUids(progress);
  const TemporaryFolder stage(target);
  const auto slices = stage.Name() / "slices";
  if (!std::filesystem::create_directory(slices, error))
    throw std::runtime_error(Label(target) + ": cannot be written: " + error.message());
  DicomOutput written{ GeometryOf(grid).dims.z, 0, stored.slope, stored.intercept, stored.error };
  for (int n = 0; n < written.slices; ++n)
  {
    char name[24];
    std::snprintf(name, sizeof name, "slice-%05d.dcm", n + 1);
    const auto file = slices / name;
    bool failed = false;
    WriteSlice(series, n, file, failed);
    written.bytes += std::filesystem::file_size(file, error);
    if (failed || error || !SyncToDisk(file))
      throw std::runtime_error(
        Label(target) + ": cannot be written (is the disk full?); nothing was kept");
    ReportProgress(progress, 0.4 + 0.6 * (n + 1) / written.slices);
  }
  if (!SyncToDisk(slices))
    throw std::runtime_error(Label(target) + ": cannot be brought to the disk; nothing was kept");
  PutInPlace(slices, target);
  return written;
}

} // namespace hasp
