/**
 * @class   vtkHaspSegmentationWriter
 * @brief   Writes a label map as .seg.nrrd, with names and colours, or as .nrrd, .mha, .nii,
 * .nii.gz or .vti, atomically.
 *
 * Input: a vtkImageData of unsigned char or unsigned short. What its labels are called is taken of
 * its field data (vtkHaspLabelTable.h), as vtkHaspSegmentationReader leaves it there; labels
 * without a name are called "Bone" (1) and "Fragment N". 3D Slicer opens the .seg.nrrd as a
 * segmentation; the other formats hold the samples alone.
 *
 * The file appears whole or not at all; on failure the earlier file is as it was. See
 * hasp::WriteLabels for what is written and what is refused.
 *
 * Threads: as any VTK writer, one at a time (RENDER or WORKER). Errors: vtkErrorMacro, Write
 * returns 0 and GetErrorCode is not 0. AbortExecute cancels.
 */
#ifndef vtkHaspSegmentationWriter_h
#define vtkHaspSegmentationWriter_h

#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkWriter.h"

class VTKHASPIOMEDICAL_EXPORT vtkHaspSegmentationWriter : public vtkWriter
{
public:
  static vtkHaspSegmentationWriter* New();
  vtkTypeMacro(vtkHaspSegmentationWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Ends in .seg.nrrd, .nrrd, .mha, .nii, .nii.gz or .vti. UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /// Gzip in .seg.nrrd and .nrrd; on by default.
  vtkSetMacro(Compress, bool);
  vtkGetMacro(Compress, bool);
  vtkBooleanMacro(Compress, bool);

  /// 1 if the file has been written; 0 also where the input failed.
  int Write() override;

protected:
  vtkHaspSegmentationWriter() = default;
  ~vtkHaspSegmentationWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkHaspSegmentationWriter(const vtkHaspSegmentationWriter&) = delete;
  void operator=(const vtkHaspSegmentationWriter&) = delete;

  char* FileName = nullptr;
  bool Compress = true;
};

#endif
