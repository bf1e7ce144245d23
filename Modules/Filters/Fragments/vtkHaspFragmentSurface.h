/**
 * @class   vtkHaspFragmentSurface
 * @brief   The closed surface of a fragment of a scan, or of all of them.
 *
 * Input 0: a vtkImageData with one component of short, unsigned short, unsigned char or float,
 * bone is sample >= IsoValue. Input 1: a vtkImageData of unsigned short on the same grid, a label a
 * sample, 0 is nothing. Any extent, spacing and direction. Output: a vtkPolyData of triangles,
 * world mm, with the cell array "Label" (unsigned short); each label's part is a closed 2-manifold
 * that does not meet itself, also where fragments touch: grey values say where in a voxel the
 * surface passes, labels whose it is (thesis 2.1.3, Fig. 2.4), half way between two. Limit: at the
 * rim, where a cut meets the bone's own surface, up to 0.75 of the scan's spacing off.
 *
 * For what else a scene needs of fragments, when it needs it, see hasp::FragmentModels, whose
 * Surface this is. Edges are those of distances, not sharp (CoverageDistance.h, SharpContour.h).
 *
 * Errors (vtkErrorMacro, empty output): images that hasp::FragmentScanOf or hasp::FragmentModels
 * refuses, a label that is not there, has no bone, or is thinner than the spacing. AbortExecute
 * gives an empty output without an error. Threads: as any VTK filter, one at a time (RENDER or
 * WORKER); uses all cores. Cost: a pass over the labels, and about 2 us of CPU time a sample of
 * each fragment's box, with 5 spacings around.
 */
#ifndef vtkHaspFragmentSurface_h
#define vtkHaspFragmentSurface_h

#include "vtkHaspFiltersFragmentsModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkAlgorithmOutput;
class vtkImageData;

class VTKHASPFILTERSFRAGMENTS_EXPORT vtkHaspFragmentSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspFragmentSurface* New();
  vtkTypeMacro(vtkHaspFragmentSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Input 1.
  void SetLabelConnection(vtkAlgorithmOutput* labels);
  void SetLabelData(vtkImageData* labels);
  ///@}

  ///@{
  /// In the units of the scalars; default 226 (bone in CT, HU).
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /// The fragment; 0, the default: each label of the map, in a part of its own.
  vtkSetClampMacro(Label, int, 0, 65535);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /// Of the grid that the surface is made on, mm; 0, the default: the scan's smallest.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

protected:
  vtkHaspFragmentSurface();
  ~vtkHaspFragmentSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspFragmentSurface(const vtkHaspFragmentSurface&) = delete;
  void operator=(const vtkHaspFragmentSurface&) = delete;

  double IsoValue = 226.0;
  int Label = 0;
  double Spacing = 0.0;
};

#endif
