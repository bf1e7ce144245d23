/**
 * @class   vtkHaspClusteredCellFilter
 * @brief   Makes the active cells of an isosurface, all that drawing it takes, of a volume.
 *
 * Input: a vtkImageData with one component of short, unsigned short, unsigned char or float; any
 * extent, spacing and direction. Output: a vtkHaspClusteredCells, for vtkHaspClusteredCellMapper
 * and vtkHaspClusteredCellWriter; it does not need the volume any more. Inside is sample >=
 * IsoValue; an isovalue outside the samples' range gives no cells and is no error.
 *
 * The min-max blocks of the volume are kept: the next isovalue reads only blocks with surface. Who
 * changes samples in a box says so with MarkModified: then only blocks that touch it are read, and
 * the result is the same, byte for byte.
 *
 * Threads: as any VTK filter, one at a time (RENDER or WORKER); uses all cores. Errors
 * (vtkErrorMacro, empty output): an input that hasp::ViewImage or hasp::ExtractActiveCells refuses.
 * AbortExecute gives an empty output without an error. Cost: O(samples) for a new volume, O(samples
 * of blocks with surface) for a new isovalue. Memory: 8 bytes for 512 samples, and the cells.
 */
#ifndef vtkHaspClusteredCellFilter_h
#define vtkHaspClusteredCellFilter_h

#include "vtkHaspClusteredCellAlgorithm.h"
#include "vtkHaspFiltersIsosurfaceModule.h" // for export macro

#include <memory> // for Internals

class VTKHASPFILTERSISOSURFACE_EXPORT vtkHaspClusteredCellFilter :
  public vtkHaspClusteredCellAlgorithm
{
public:
  static vtkHaspClusteredCellFilter* New();
  vtkTypeMacro(vtkHaspClusteredCellFilter, vtkHaspClusteredCellAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// In the units of the scalars; default 0.
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /// Off (default): corners are the volume's samples, bit for bit. On: 8 bits a corner, the sign of
  /// sample - isovalue exact; see hasp::CompactLevels for the bound.
  vtkSetMacro(Compact, bool);
  vtkGetMacro(Compact, bool);
  vtkBooleanMacro(Compact, bool);
  ///@}

  /// Since the last update samples have changed in this extent of the input (inclusive, as
  /// vtkImageData's), and nowhere else. Several calls add up to the box around them. For the next
  /// update only; call the input's Modified, too, as after any change.
  void MarkModified(const int extent[6]);

protected:
  vtkHaspClusteredCellFilter();
  ~vtkHaspClusteredCellFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspClusteredCellFilter(const vtkHaspClusteredCellFilter&) = delete;
  void operator=(const vtkHaspClusteredCellFilter&) = delete;

  double IsoValue = 0.0;
  bool Compact = false;
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
