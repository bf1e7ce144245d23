/**
 * @class   vtkHaspSignedDistance
 * @brief   Signed distance of every voxel to a surface, negative inside, true below a voxel.
 *
 * Input: a vtkImageData with one component of short, unsigned short, unsigned char or float; any
 * extent, spacing and direction. Output: a vtkImageData of float on the same grid, larger by
 * Margin, "SignedDistance", mm, for vtkHaspCsg, vtkHaspSharpContour, or any VTK filter; those that
 * contour take high values as inside, so that what vtkFlyingEdges3D makes of it is inside out:
 * vtkReverseSense. Where nothing is inside all of it is +infinity, where all is, -infinity;
 * vtkHaspCsg and vtkHaspSharpContour refuse such an image. A mesh: vtkHaspCoverage first.
 *
 * InputKind says what the samples are. Coverage is exact below a voxel; a scan taken for coverage,
 * or coverage taken for a scan, is wrong by up to a voxel: Automatic measures which of both an
 * image in [0,1] is by the width of its edges, and coverage that is none is refused.
 *
 * Transforms: AntiAliased, the one that guides use (Distance/CoverageDistance.h: 0.002 voxel rms on
 * smooth surfaces of coverage), Euclidean (exact to a mask's voxels, so half a voxel off the
 * surface), and Chamfer, the weighted <3,4,5> transform of the papers (thesis 2.1.4, Eq. 2.2; up to
 * 10.5 % off), to be compared with.
 *
 * Errors (vtkErrorMacro, empty output): an input that hasp::ViewImage or the transform refuses, a
 * margin that is negative or gives 2^31 voxels and more.
 * AbortExecute gives an empty output without an error. Threads: as any VTK filter, one at a time;
 * uses all cores, the same result with any number of them. Cost: O(voxels), 12 to 28 bytes each at
 * the peak; a narrow band of coverage costs what its surface costs.
 */
#ifndef vtkHaspSignedDistance_h
#define vtkHaspSignedDistance_h

#include "vtkHaspFiltersDistanceModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspSignedDistance : public vtkImageAlgorithm
{
public:
  static vtkHaspSignedDistance* New();
  vtkTypeMacro(vtkHaspSignedDistance, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InputKinds
  {
    Automatic, ///< float in [0,1]: coverage, or grey at 0.5, as is measured; else an error
    Coverage,  ///< float in [0,1]: share of a voxel that is inside, as vtkHaspCoverage gives
    Grey,      ///< inside is sample >= IsoValue
    Labels     ///< inside is sample == Label
  };
  enum Transforms
  {
    AntiAliased,
    Euclidean,
    Chamfer
  };

  ///@{
  /// Default Automatic.
  vtkSetClampMacro(InputKind, int, Automatic, Labels);
  vtkGetMacro(InputKind, int);
  void SetInputKindToAutomatic() { this->SetInputKind(Automatic); }
  void SetInputKindToCoverage() { this->SetInputKind(Coverage); }
  void SetInputKindToGrey() { this->SetInputKind(Grey); }
  void SetInputKindToLabels() { this->SetInputKind(Labels); }
  ///@}

  ///@{
  /// Of Grey; default 226 (bone in CT, HU).
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /// Of Labels; default 1.
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /// Default AntiAliased.
  vtkSetClampMacro(Transform, int, AntiAliased, Chamfer);
  vtkGetMacro(Transform, int);
  void SetTransformToAntiAliased() { this->SetTransform(AntiAliased); }
  void SetTransformToEuclidean() { this->SetTransform(Euclidean); }
  void SetTransformToChamfer() { this->SetTransform(Chamfer); }
  ///@}

  ///@{
  /// Only within four voxels (the smallest spacing) of the surface; farther out the value is +-4
  /// voxels. Default off. AntiAliased of coverage or labels is faster so; the others are cut off.
  vtkSetMacro(NarrowBand, bool);
  vtkGetMacro(NarrowBand, bool);
  vtkBooleanMacro(NarrowBand, bool);
  ///@}

  ///@{
  /// How far the output reaches beyond the input, mm, on all sides; default 0. As large as the
  /// greatest offset of what is inside: it has no room otherwise (Distance/GridSolid.h). What is
  /// beyond the input counts as outside: bone that goes on there is closed, flat, half a voxel
  /// beyond the last samples. Distances in the input change near there, and nowhere else.
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

protected:
  vtkHaspSignedDistance() = default;
  ~vtkHaspSignedDistance() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspSignedDistance(const vtkHaspSignedDistance&) = delete;
  void operator=(const vtkHaspSignedDistance&) = delete;

  int InputKind = Automatic;
  double IsoValue = 226.0;
  int Label = 1;
  int Transform = AntiAliased;
  bool NarrowBand = false;
  double Margin = 0.0;
};

#endif
