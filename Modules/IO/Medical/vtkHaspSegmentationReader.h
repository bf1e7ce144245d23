/**
 * @class   vtkHaspSegmentationReader
 * @brief   Reads a label map - .seg.nrrd of 3D Slicer, NRRD, MetaImage, NIfTI, .vti - and what its
 * labels are called.
 *
 * Output: a vtkImageData of unsigned short, one label a sample, 0 for nothing, in patient LPS
 * millimetres, extent from 0. What the file says of its labels is field data of the output, the
 * arrays LabelValues, LabelNames, LabelColors and LabelsOfBone (vtkHaspLabelTable.h).
 *
 * Input 0, optional: the scan that the labels are of. They are then put on its grid, also where the
 * file holds a part of it only, as 3D Slicer saves segmentations, and are refused where they are of
 * another grid: nothing is resampled. Only its place is looked at.
 *
 * What is refused besides: hasp::LoadLabels. Threads: as any VTK filter, one at a time (RENDER or
 * WORKER). Errors: vtkErrorMacro with the file's label, what is wrong and what to do; the output is
 * then empty and GetErrorCode is not 0. AbortExecute cancels. Cost: one pass over the file; two
 * bytes a sample of each grid.
 */
#ifndef vtkHaspSegmentationReader_h
#define vtkHaspSegmentationReader_h

#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for Internals

// Of vtkHaspVolumeFile.h, to be included by who uses it: the wrapper would parse GLM with it.
namespace hasp
{
struct Passport;
}

class VTKHASPIOMEDICAL_EXPORT vtkHaspSegmentationReader : public vtkImageAlgorithm
{
public:
  static vtkHaspSegmentationReader* New();
  vtkTypeMacro(vtkHaspSegmentationReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// A file, UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /// Which label map of a .seg.nrrd with several, counted from 1, where segments overlap; 0
  /// (default) = all, which must not overlap and are merged.
  vtkSetMacro(Layer, int);
  vtkGetMacro(Layer, int);

  /// What is known of the file; its geometry is the file's grid. After an error what was known.
  const hasp::Passport& GetPassport() const;

protected:
  vtkHaspSegmentationReader();
  ~vtkHaspSegmentationReader() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkHaspSegmentationReader(const vtkHaspSegmentationReader&) = delete;
  void operator=(const vtkHaspSegmentationReader&) = delete;

  int Fail(const char* text);

  struct Internals;
  std::unique_ptr<Internals> Inside;
  char* FileName = nullptr;
  int Layer = 0;
};

#endif
