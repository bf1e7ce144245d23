/**
 * @class   vtkHaspClusteredCellReader
 * @brief   Reads the active cells of an isosurface from a .hcells file.
 *
 * What is refused and why: see hasp::LoadCells. What comes out is sound: it may be drawn and traced
 * whoever wrote the file.
 *
 * Threads: as any VTK filter, one at a time (RENDER or WORKER). Errors: vtkErrorMacro with the
 * file's label, what is wrong and what to do; the output is then empty and GetErrorCode is not 0.
 * AbortExecute cancels. Cost: one pass over the file and one over the cells.
 */
#ifndef vtkHaspClusteredCellReader_h
#define vtkHaspClusteredCellReader_h

#include "vtkHaspClusteredCellAlgorithm.h"
#include "vtkHaspIOMedicalModule.h" // for export macro

class VTKHASPIOMEDICAL_EXPORT vtkHaspClusteredCellReader : public vtkHaspClusteredCellAlgorithm
{
public:
  static vtkHaspClusteredCellReader* New();
  vtkTypeMacro(vtkHaspClusteredCellReader, vtkHaspClusteredCellAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  ///@{
  /// Most bytes that the cells may take; default 4 GiB. Checked before it is taken.
  vtkSetMacro(MemoryLimit, vtkTypeUInt64);
  vtkGetMacro(MemoryLimit, vtkTypeUInt64);
  ///@}

protected:
  vtkHaspClusteredCellReader();
  ~vtkHaspClusteredCellReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkHaspClusteredCellReader(const vtkHaspClusteredCellReader&) = delete;
  void operator=(const vtkHaspClusteredCellReader&) = delete;

  char* FileName = nullptr;
  vtkTypeUInt64 MemoryLimit;
};

#endif
