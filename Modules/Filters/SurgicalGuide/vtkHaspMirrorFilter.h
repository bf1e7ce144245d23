/**
 * @class   vtkHaspMirrorFilter
 * @brief   Bone mirrored at its plane of symmetry: a ghost to reduce the other side by.
 *
 * Input 0: a vtkImageData with one component of short, unsigned short, unsigned char or float, bone
 * is sample >= IsoValue. Input 1, optional: a vtkImageData of unsigned short or unsigned char on
 * the same grid; bone counts where it is Label. Output: a vtkPolyData, closed, world mm, with the
 * point scalars "SignedDistance" (float): mm to the real bone's surface, NEGATIVE INSIDE bone, the
 * residual symmetry map. What is done, errors and cost: hasp::MakeMirrorGhost (MirrorGhost.h).
 *
 * A surface is no input: the plane is found by where bone is and is not, and distances are of
 * samples; an open surface says neither. Of a closed one vtkPolyDataToImageStencil and
 * vtkImageStencil make such an image, as exact as its voxels.
 *
 * Errors (vtkErrorMacro, empty output): inputs that hasp::ViewImage refuses, labels of another
 * grid, settings out of range, no bone, bone that is not like its mirror image. AbortExecute gives
 * an empty output without an error. Threads: as any VTK filter, one at a time (RENDER or WORKER);
 * uses all cores.
 */
#ifndef vtkHaspMirrorFilter_h
#define vtkHaspMirrorFilter_h

#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class vtkAlgorithmOutput;
class vtkImageData;

class VTKHASPFILTERSSURGICALGUIDE_EXPORT vtkHaspMirrorFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspMirrorFilter* New();
  vtkTypeMacro(vtkHaspMirrorFilter, vtkPolyDataAlgorithm);
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
  /// Of input 1; default 1.
  vtkSetClampMacro(Label, int, 1, 65535);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /// Pieces of less are left out without input 1, mm3; default 1000.
  vtkSetMacro(IgnoreBelow, double);
  vtkGetMacro(IgnoreBelow, double);
  ///@}

  ///@{
  /// Of the grid that bone is measured on, mm, 0.3 to 3; default 1.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Search the plane of best symmetry; default on. Off: PlanePoint and PlaneNormal are it.
  vtkSetMacro(FindPlane, bool);
  vtkGetMacro(FindPlane, bool);
  vtkBooleanMacro(FindPlane, bool);
  ///@}

  ///@{
  /// World mm; a unit vector.
  vtkSetVector3Macro(PlanePoint, double);
  vtkGetVector3Macro(PlanePoint, double);
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /// What the last run mirrored at, and found: median and 95th percentile of the distances' sizes,
  /// mm; the share of the ghost's area that is within 2 mm of bone. 0 before a run and after a
  /// failed one.
  vtkGetVector3Macro(UsedPoint, double);
  vtkGetVector3Macro(UsedNormal, double);
  vtkGetMacro(MedianDistance, double);
  vtkGetMacro(DistanceOf95, double);
  vtkGetMacro(MatchedShare, double);
  ///@}

protected:
  vtkHaspMirrorFilter();
  ~vtkHaspMirrorFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspMirrorFilter(const vtkHaspMirrorFilter&) = delete;
  void operator=(const vtkHaspMirrorFilter&) = delete;
  void Forget();

  double IsoValue = 226.0, IgnoreBelow = 1000.0, Spacing = 1.0;
  int Label = 1;
  bool FindPlane = true;
  double PlanePoint[3] = { 0.0, 0.0, 0.0 }, PlaneNormal[3] = { 1.0, 0.0, 0.0 };
  double UsedPoint[3] = { 0.0, 0.0, 0.0 }, UsedNormal[3] = { 0.0, 0.0, 0.0 };
  double MedianDistance = 0.0, DistanceOf95 = 0.0, MatchedShare = 0.0;
};

#endif
