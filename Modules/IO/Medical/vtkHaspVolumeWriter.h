/**
 * @class   vtkHaspVolumeWriter
 * @brief   Writes a volume as .vti, .mha, .nrrd, .nii or .nii.gz, atomically, with its direction.
 *
 * The file appears whole or not at all; on failure the earlier file is as it was. See
 * hasp::WriteVolume for what is written and what is refused.
 *
 * Threads: as any VTK writer, one at a time (RENDER or WORKER). Errors: vtkErrorMacro, Write
 * returns 0 and GetErrorCode is not 0.
 */
#ifndef vtkHaspVolumeWriter_h
#define vtkHaspVolumeWriter_h

#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkWriter.h"

class VTKHASPIOMEDICAL_EXPORT vtkHaspVolumeWriter : public vtkWriter
{
public:
  static vtkHaspVolumeWriter* New();
  vtkTypeMacro(vtkHaspVolumeWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Ends in .vti, .mha, .nrrd, .nii or .nii.gz. UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /// 1 if the file has been written; 0 also where the input failed.
  int Write() override;

protected:
  vtkHaspVolumeWriter() = default;
  ~vtkHaspVolumeWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkHaspVolumeWriter(const vtkHaspVolumeWriter&) = delete;
  void operator=(const vtkHaspVolumeWriter&) = delete;

  char* FileName = nullptr;
};

#endif
