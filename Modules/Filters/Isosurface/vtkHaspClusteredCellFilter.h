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
 * the result is the same, byte for byte; labels, if any, are made anew.
 *
 * Threads: as any VTK filter, one at a time (RENDER or WORKER); uses all cores. Errors
 * (vtkErrorMacro, empty output): an input that hasp::ViewImage or hasp::ExtractActiveCells refuses,
 * labels that are not there or that hasp::AddLabels refuses. AbortExecute gives an empty output
 * without an error. Cost: O(samples) for a new volume, O(samples of blocks with surface) for a new
 * isovalue. Memory: 8 bytes for 512 samples, and the cells.
 */
#ifndef vtkHaspClusteredCellFilter_h
#define vtkHaspClusteredCellFilter_h

#include "vtkHaspClusteredCellAlgorithm.h"
#include "vtkHaspFiltersIsosurfaceModule.h" // for export macro

#include <memory> // for Internals
#include <string> // for names

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

  ///@{
  /// Name of the point array that holds a label a sample: short, unsigned short or unsigned char, 0
  /// to 65535, 0 for none. Each cell takes the most frequent label of its inside corners
  /// (hasp::AddLabels); 2 bytes a cell. Empty, the default: no labels.
  vtkSetStdStringFromCharMacro(LabelArrayName);
  vtkGetCharFromStdStringMacro(LabelArrayName);
  ///@}

  /// Samples in this box of point indices (x0, x1, y0, y1, z0, z1; clamped to the image) have been
  /// changed in place, and no others since the last update: the next update reads only the blocks
  /// that touch it (sculpting). Call it after the change, and after Modified() of the image if that
  /// is called at all. Several boxes before an update become the box around them.
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
  std::string LabelArrayName;
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
