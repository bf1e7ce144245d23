/**
 * @class   vtkHaspCoverage
 * @brief   How much of each voxel lies inside: of a grey volume, a fragment of it, or a mesh.
 *
 * Input 0: a vtkImageData with one component of short, unsigned short, unsigned char or float,
 * inside is sample >= IsoValue; or a vtkPolyData that is closed. Input 1, optional: a vtkImageData
 * whose grid the output takes, any extent, spacing and direction; its samples are not asked.
 * Without it the output has the grid of the volume; a mesh has none of its own, and needs it.
 * Output: a vtkImageData of float, "Coverage", in [0,1], for vtkHaspSignedDistance.
 *
 * Thesis 2.1.3, Fig. 2.4: grey values say where in a voxel the surface passes, labels whose it is:
 * a neighbouring fragment counts as outside, half way between the two. Method and limits:
 * Distance/Coverage.h, Distance/MeshCoverage.h.
 *
 * Errors (vtkErrorMacro, empty output): an input that hasp::ViewImage refuses, labels that are not
 * there, a mesh that is empty, not closed (says where) or comes without a grid, a number out of its
 * range. A mesh that reaches beyond the grid is cut off, with a warning (vtkWarningMacro).
 * AbortExecute gives an empty output without an error. Threads: as any VTK filter, one at a
 * time; uses all cores. Cost: O(voxels), and SamplesPerAxis^3 for a voxel on the surface.
 */
#ifndef vtkHaspCoverage_h
#define vtkHaspCoverage_h

#include "vtkHaspFiltersDistanceModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for names

class vtkAlgorithmOutput;
class vtkImageData;

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspCoverage : public vtkImageAlgorithm
{
public:
  static vtkHaspCoverage* New();
  vtkTypeMacro(vtkHaspCoverage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Input 1: the grid of the output; null for the volume's own.
  void SetGridConnection(vtkAlgorithmOutput* grid);
  void SetGridData(vtkImageData* grid);
  ///@}

  ///@{
  /// In the units of the scalars; default 226 (bone in CT, HU). Not for meshes.
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /// Sub-samples of a voxel along each axis, or lines through it for a mesh; 1 to 16, default 5.
  vtkSetMacro(SamplesPerAxis, int);
  vtkGetMacro(SamplesPerAxis, int);
  ///@}

  ///@{
  /// Name of the volume's point array that holds a label a sample (short, unsigned short, unsigned
  /// char or float), and the label of the fragment; default 1. Empty, the default: all of the
  /// volume.
  vtkSetStdStringFromCharMacro(LabelArrayName);
  vtkGetCharFromStdStringMacro(LabelArrayName);
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

protected:
  vtkHaspCoverage();
  ~vtkHaspCoverage() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspCoverage(const vtkHaspCoverage&) = delete;
  void operator=(const vtkHaspCoverage&) = delete;

  double IsoValue = 226.0;
  int SamplesPerAxis = 5;
  std::string LabelArrayName;
  int Label = 1;
};

#endif
