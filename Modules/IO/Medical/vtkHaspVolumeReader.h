/**
 * @class   vtkHaspVolumeReader
 * @brief   Reads a volume - DICOM folder, .inv3, MetaImage, NRRD, NIfTI, .vti - into patient LPS
 * millimetres.
 *
 * UpdateInformation reads and checks headers and fills the passport; Update decodes the samples and
 * completes it. The output's extent starts at 0, its scalars are short, unsigned short, unsigned
 * char or float, and its direction matrix says how index axes lie in the patient. What is refused
 * and why: see hasp::OpenVolume.
 *
 * Threads: as any VTK filter, one at a time (RENDER or WORKER). Errors: vtkErrorMacro with the
 * file's label, what is wrong and what to do; the output is then empty and GetErrorCode is not
 * 0. AbortExecute cancels; progress runs from 0 to 1 twice, over headers and over samples. Cost:
 * about one pass over the file; DICOM headers are parsed twice (once to check, once to decode).
 */
#ifndef vtkHaspVolumeReader_h
#define vtkHaspVolumeReader_h

#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for Internals

// Of vtkHaspVolumeFile.h, to be included by who uses them: the wrapper would parse GLM with it.
namespace hasp
{
struct Passport;
struct VolumeReadSettings;
}

class VTKHASPIOMEDICAL_EXPORT vtkHaspVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkHaspVolumeReader* New();
  vtkTypeMacro(vtkHaspVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// A file or a folder, UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /// Which DICOM series of the folder, counted from 1; 0 (default) = there must be one only. The
  /// error of a folder with several lists them.
  void SetSeries(int series);
  int GetSeries() const;

  /// Off (default): a stack of slices that is tilted, lacks slices or is uneven is an error. On: it
  /// is made a regular volume, and the passport says by how many millimetres surfaces may be off.
  void SetResample(bool resample);
  bool GetResample() const;
  vtkBooleanMacro(Resample, bool);

  /// Limits of memory and time, whether the passport's hash is asked for, the series, and whether
  /// to resample.
  void SetSettings(const hasp::VolumeReadSettings& settings);
  const hasp::VolumeReadSettings& GetSettings() const;

  /// What is known of the volume: after UpdateInformation all but what samples tell; after an error
  /// what was known, with the faults.
  const hasp::Passport& GetPassport() const;

protected:
  vtkHaspVolumeReader();
  ~vtkHaspVolumeReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkHaspVolumeReader(const vtkHaspVolumeReader&) = delete;
  void operator=(const vtkHaspVolumeReader&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Inside;
  char* FileName = nullptr;
};

#endif
