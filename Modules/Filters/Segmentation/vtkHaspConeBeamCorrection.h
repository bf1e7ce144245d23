/**
 * @class   vtkHaspConeBeamCorrection
 * @brief   Takes cupping and other shading out of a cone-beam image, and can even bone's contrast.
 *
 * Input: a vtkImageData with one component of short, unsigned short, unsigned char or float, grey
 * values that need not be HU. Output: float, "Corrected", on the same grid (extent and direction
 * too). The patient is grey value > InsideAbove; what is not stays as it is. Method, what is
 * estimated and limits: Segmentation/ConeBeam.h. Thesis 4.2.
 *
 * Errors (vtkErrorMacro, empty output): an input that hasp::ViewImage refuses, a number out of its
 * range, no sample > InsideAbove. AbortExecute gives an empty output without an error. Threads: as
 * any VTK filter, one at a time; uses all cores. Cost: O(voxels).
 */
#ifndef vtkHaspConeBeamCorrection_h
#define vtkHaspConeBeamCorrection_h

#include "vtkHaspFiltersSegmentationModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class VTKHASPFILTERSSEGMENTATION_EXPORT vtkHaspConeBeamCorrection : public vtkImageAlgorithm
{
public:
  static vtkHaspConeBeamCorrection* New();
  vtkTypeMacro(vtkHaspConeBeamCorrection, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Shading is smooth over this length, mm; 10 to 500, default 60.
  vtkSetMacro(FieldMm, double);
  vtkGetMacro(FieldMm, double);
  ///@}

  ///@{
  /// Bone's contrast is normalised over this length, mm; 5 to 100, default 0: not at all.
  vtkSetMacro(ContrastMm, double);
  vtkGetMacro(ContrastMm, double);
  ///@}

  ///@{
  /// The patient is grey value > this; default 0.
  vtkSetMacro(InsideAbove, double);
  vtkGetMacro(InsideAbove, double);
  ///@}

  ///@{
  /// What the last run found, grey values: the level of air, if there was any, and of soft tissue
  /// after correction; and shading in soft tissue, lowest and highest: a gain relative to its mean,
  /// or what was added where there was no air.
  vtkGetMacro(HasAir, bool);
  vtkGetMacro(AirLevel, double);
  vtkGetMacro(SoftTissueLevel, double);
  vtkGetMacro(LowestShading, double);
  vtkGetMacro(HighestShading, double);
  ///@}

protected:
  vtkHaspConeBeamCorrection() = default;
  ~vtkHaspConeBeamCorrection() override = default;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspConeBeamCorrection(const vtkHaspConeBeamCorrection&) = delete;
  void operator=(const vtkHaspConeBeamCorrection&) = delete;

  double FieldMm = 60.0;
  double ContrastMm = 0.0;
  double InsideAbove = 0.0;

  bool HasAir = false;
  double AirLevel = 0.0;
  double SoftTissueLevel = 0.0;
  double LowestShading = 0.0;
  double HighestShading = 0.0;
};

#endif
