/**
 * @class   vtkHaspClusteredCellWriter
 * @brief   Writes the active cells of an isosurface as .hcells, atomically.
 *
 * The file appears whole or not at all; on failure the earlier file is as it was. The same cells
 * give the same bytes. See hasp::WriteCells.
 *
 * Threads: as any VTK writer, one at a time (RENDER or WORKER). Errors: vtkErrorMacro, Write
 * returns 0 and GetErrorCode is not 0. AbortExecute cancels.
 */
#ifndef vtkHaspClusteredCellWriter_h
#define vtkHaspClusteredCellWriter_h

#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkWriter.h"

class VTKHASPIOMEDICAL_EXPORT vtkHaspClusteredCellWriter : public vtkWriter
{
public:
  static vtkHaspClusteredCellWriter* New();
  vtkTypeMacro(vtkHaspClusteredCellWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Ends in .hcells. UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /// 1 if the file has been written; 0 also where the input failed.
  int Write() override;

protected:
  vtkHaspClusteredCellWriter() = default;
  ~vtkHaspClusteredCellWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkHaspClusteredCellWriter(const vtkHaspClusteredCellWriter&) = delete;
  void operator=(const vtkHaspClusteredCellWriter&) = delete;

  char* FileName = nullptr;
};

#endif
