#include "ImportMethods.h"

#include "vtkHaspDicomOutput.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeFile.h"

#include "vtkAlgorithm.h"
#include "vtkDICOMImageReader.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkVersionMacros.h"
#include "vtkXMLImageDataReader.h"
#if HASP_WITH_SLICES
#include "vtkDICOMDirectory.h"
#include "vtkDICOMReader.h"
#include "vtkStringArray.h"
#endif

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace hasp
{
namespace
{

/// The reader's output. Its error becomes an exception.
vtkSmartPointer<vtkImageData> OutputOf(vtkAlgorithm* reader)
{
  reader->Update();
  if (reader->GetErrorCode() != vtkErrorCode::NoError)
    throw std::runtime_error("the reader reports an error");
  return vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
}

/// The image where the reader's matrix puts it: what who knows the reader does with its output.
vtkSmartPointer<vtkImageData> Placed(vtkImageData* image, vtkMatrix4x4* toPatient, bool ras)
{
  auto placed = vtkSmartPointer<vtkImageData>::New();
  placed->ShallowCopy(image);
  double at[4] = { 0.0, 0.0, 0.0, 1.0 };
  image->GetOrigin(at);
  if (toPatient)
    toPatient->MultiplyPoint(at, at);
  double direction[9];
  for (int row = 0; row < 3; ++row)
  {
    const double sign = ras && row < 2 ? -1.0 : 1.0;
    at[row] *= sign;
    for (int column = 0; column < 3; ++column)
      direction[3 * row + column] =
        sign * (toPatient ? toPatient->GetElement(row, column) : double(row == column));
  }
  placed->SetOrigin(at);
  placed->SetDirectionMatrix(direction);
  return placed;
}

ImportRival VtkNiftiReader()
{
  return { "vtkNIFTIImageReader of VTK " VTK_VERSION, [](const std::string& path)
    {
      vtkNew<vtkNIFTIImageReader> reader;
      reader->SetFileName(path.c_str());
      const auto image = OutputOf(reader); // which makes the matrix, too
      return Placed(image, reader->GetQFormMatrix(), true);
    } };
}

template <typename Reader>
ImportRival VtkReader(const std::string& name)
{
  return { name + " of VTK " VTK_VERSION, [](const std::string& path)
    {
      vtkNew<Reader> reader;
      reader->SetFileName(path.c_str());
      return OutputOf(reader);
    } };
}

#if HASP_WITH_SLICES
ImportRival VtkDicomImageReader()
{
  return { "vtkDICOMImageReader of VTK " VTK_VERSION, [](const std::string& folder)
    {
      vtkNew<vtkDICOMImageReader> reader;
      reader->SetDirectoryName(folder.c_str());
      return OutputOf(reader);
    } };
}

/// As its own programs use it: the folder sorted into series, the first of them read.
ImportRival VtkDicomReader()
{
  return { "vtkDICOMReader of vtk-dicom", [](const std::string& folder)
    {
      vtkNew<vtkDICOMDirectory> directory;
      directory->SetDirectoryName(folder.c_str());
      directory->Update();
      if (directory->GetErrorCode() != vtkErrorCode::NoError || directory->GetNumberOfSeries() < 1)
        throw std::runtime_error("the reader finds no series");
      vtkNew<vtkDICOMReader> reader;
      reader->SetFileNames(directory->GetFileNamesForSeries(0));
      const auto image = OutputOf(reader);
      return Placed(image, reader->GetPatientMatrix(), false);
    } };
}
#endif

} // namespace

std::vector<ImportFormat> ImportFormats()
{
  std::vector<ImportFormat> formats{
    { "mha", ".mha", { VtkReader<vtkMetaImageReader>("vtkMetaImageReader") } },
    { "nrrd", ".nrrd", { VtkReader<vtkNrrdReader>("vtkNrrdReader") } },
    { "nii", ".nii", { VtkNiftiReader() } },
    { "nii.gz", ".nii.gz", { VtkNiftiReader() } },
    { "vti", ".vti", { VtkReader<vtkXMLImageDataReader>("vtkXMLImageDataReader") } },
  };
#if HASP_WITH_SLICES
  formats.push_back({ "dicom", "", { VtkDicomImageReader(), VtkDicomReader() } });
#endif
  return formats;
}

vtkSmartPointer<vtkImageData> ReadOurs(const std::string& path)
{
  return LoadVolume(OpenVolume(path)).image;
}

std::string WriteImport(vtkImageData* image, const ImportFormat& format, const std::string& name)
{
  const std::string path = name + format.ending;
  if (format.ending.empty())
    WriteDicomSeries(image, path, { .modality = "CT", .hounsfield = true });
  else
    WriteVolume(image, path);
  return path;
}

bool Notices(const ImportRival& reader, const std::string& folder)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const int nowhere = open("/dev/null", O_WRONLY); // last words of who crashes
    dup2(nowhere, STDERR_FILENO);
    try
    {
      reader.read(folder);
    }
    catch (const std::exception&)
    {
      _exit(1);
    }
    _exit(0); // no exit handlers: they are the parent's
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child)
    throw std::runtime_error("a reader cannot be given a process of its own");
  return status != 0;
}

} // namespace hasp
