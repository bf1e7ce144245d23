/**
 * @class   vtkHaspSurfaceWriter
 * @brief   Writes a triangle surface as .stl, .ply or .obj, atomically, marked LPS and mm.
 *
 * The file appears whole or not at all; on failure the earlier file is as it was. See
 * hasp::WriteSurface for what is written and what is refused.
 *
 * Threads: as any VTK writer, one at a time (RENDER or WORKER). Errors: vtkErrorMacro, Write
 * returns 0 and GetErrorCode is not 0.
 */
#ifndef vtkHaspSurfaceWriter_h
#define vtkHaspSurfaceWriter_h

#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkWriter.h"

class VTKHASPIOMEDICAL_EXPORT vtkHaspSurfaceWriter : public vtkWriter
{
public:
  static vtkHaspSurfaceWriter* New();
  vtkTypeMacro(vtkHaspSurfaceWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Ends in .stl, .ply or .obj. UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /// 1 if the file has been written; 0 also where the input failed.
  int Write() override;

protected:
  vtkHaspSurfaceWriter() = default;
  ~vtkHaspSurfaceWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkHaspSurfaceWriter(const vtkHaspSurfaceWriter&) = delete;
  void operator=(const vtkHaspSurfaceWriter&) = delete;

  char* FileName = nullptr;
};

#endif
