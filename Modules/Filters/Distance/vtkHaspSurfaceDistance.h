/**
 * @class   vtkHaspSurfaceDistance
 * @brief   Signed distance of a surface's points to a reference, live while a pose changes.
 *
 * Inputs: 0, a vtkPolyData; 1, the reference: a closed vtkPolyData, or a vtkImageData of float
 * with one component, a signed distance in mm, NEGATIVE INSIDE (vtkHaspSignedDistance). Output: the
 * surface as it is, with "SignedDistance" as its active point scalars, float, mm, NEGATIVE INSIDE
 * the reference; NaN at points that are not finite. The surface is not moved: an actor does that,
 * with the same matrix.
 *
 * The reference is sampled once, and looked up trilinearly since (Distance/DistanceLookup.h): of a
 * new pose nothing else is made anew. Error of smooth surfaces: 0.05 of the spacing rms; within
 * three spacings of a sharp edge of the reference up to 1.5 (Distance/BodyDistance.h). Beyond Band
 * around the reference distances are too large, by twice the way beyond at most: such places are
 * off a colour scale anyway.
 *
 * SurfaceToReference is a turn and a shift, mm; null: none. Errors (vtkErrorMacro, empty output):
 * no input, a pose that is not rigid within 1e-5, a reference that is not closed, too large for its
 * Spacing (says which would do), or an image that is no distance's. Threads: as any VTK filter, one
 * at a time; all cores, the same bits on any number of them.
 * Cost: 0.4 us of CPU time a sample once, 4 bytes each kept; then 4 ms a pose for 200,000 points.
 */
#ifndef vtkHaspSurfaceDistance_h
#define vtkHaspSurfaceDistance_h

#include "vtkHaspFiltersDistanceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the pose

#include <memory> // for the samples

class vtkAlgorithmOutput;
class vtkDataObject;
class vtkMatrix4x4;

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspSurfaceDistance : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspSurfaceDistance* New();
  vtkTypeMacro(vtkHaspSurfaceDistance, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Input 1.
  void SetReferenceConnection(vtkAlgorithmOutput* reference);
  void SetReferenceData(vtkDataObject* reference);
  ///@}

  ///@{
  /// From the surface's points to the reference's world; kept, and looked at when it changes.
  void SetSurfaceToReference(vtkMatrix4x4* pose);
  vtkMatrix4x4* GetSurfaceToReference();
  ///@}

  ///@{
  /// Of the samples of a reference that is a surface, mm, [0, 20]; default 0: 160 lie
  /// along its longest side and Band around.
  vtkSetClampMacro(Spacing, double, 0.0, 20.0);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// How far around such a reference it is sampled, mm, (0, 500]; default 10.
  vtkSetClampMacro(Band, double, 0.1, 500.0);
  vtkGetMacro(Band, double);
  ///@}

  /// How often a reference was sampled: not for a new pose.
  vtkGetMacro(Samplings, int);

  vtkMTimeType GetMTime() override;

protected:
  vtkHaspSurfaceDistance();
  ~vtkHaspSurfaceDistance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspSurfaceDistance(const vtkHaspSurfaceDistance&) = delete;
  void operator=(const vtkHaspSurfaceDistance&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Inside;
  vtkSmartPointer<vtkMatrix4x4> SurfaceToReference;
  double Spacing = 0.0;
  double Band = 10.0;
  int Samplings = 0;
};

#endif
