/**
 * @class   vtkHaspSurfaceReader
 * @brief   Reads a surface - .stl, .ply, .obj, .vtp - into triangles in patient LPS millimetres.
 *
 * The output holds points (float32 where that loses nothing, else float64) and triangles, nothing
 * else. What is refused and why, and what becomes of RAS: see hasp::LoadSurface. Show the warnings:
 * one says that LPS was taken because the file does not say what it is in.
 *
 * Threads: as any VTK filter, one at a time (RENDER or WORKER). Errors: vtkErrorMacro with the
 * file's label, what is wrong and what to do; the output is then empty and GetErrorCode is not 0.
 * AbortExecute cancels. Cost: one pass over the file.
 */
#ifndef vtkHaspSurfaceReader_h
#define vtkHaspSurfaceReader_h

#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for Internals
#include <string> // for warnings

// Of vtkHaspSurfaceFile.h, to be included by who uses them: the wrapper would parse GLM with it.
namespace hasp
{
struct SurfacePassport;
struct SurfaceReadSettings;
}

class VTKHASPIOMEDICAL_EXPORT vtkHaspSurfaceReader : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspSurfaceReader* New();
  vtkTypeMacro(vtkHaspSurfaceReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// UTF-8.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);

  /// Limits of memory and time.
  void SetSettings(const hasp::SurfaceReadSettings& settings);
  const hasp::SurfaceReadSettings& GetSettings() const;

  /// What is known of the surface, after Update.
  const hasp::SurfacePassport& GetPassport() const;

  /// The passport's warnings, from 0; empty beyond the last.
  int GetNumberOfWarnings() const;
  std::string GetWarning(int n) const;

protected:
  vtkHaspSurfaceReader();
  ~vtkHaspSurfaceReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override;

private:
  vtkHaspSurfaceReader(const vtkHaspSurfaceReader&) = delete;
  void operator=(const vtkHaspSurfaceReader&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Inside;
  char* FileName = nullptr;
};

#endif
