/**
 * @class   vtkHaspSolidSweep
 * @brief   A tube around lines, or a band along them on a surface, such as a plate on bone.
 *
 * Input 0: a vtkPolyData with lines, world millimetres; a line whose last point is its first is
 * closed. Input 1, optional: the surface, as a vtkHaspSolid or a vtkImageData of signed distances
 * (vtkHaspSignedDistance). Output: a vtkHaspSolid, the union of what each line gives.
 *
 * Without a surface: all within Radius of the lines. With one: what lies from Range[0] to Range[1]
 * mm off the surface (below it if negative) and within Width / 2 of a line, seen along the
 * surface's normal; its upper and lower sides are offsets of the surface itself
 * (Distance/SolidSweeps.h). Thin bone has a band on the line's side alone.
 *
 * Limits of a band: under it the surface must not bend away from its tangent by more than half the
 * width, nor, within a segment of the line, by more than the bone is thick (less 2 |Range[0]| where
 * that is negative). Another bone within Range[1] + 0.75 Width above the line gets a band, too.
 *
 * Errors (vtkErrorMacro, no solid): no line, a size out of its range, a line that leaves the
 * surface by more than a quarter of the width, bone too thin for the band (both say where, in mm).
 * Threads: as any VTK filter. Cost: O(points of lines); of an image 4 bytes a sample, kept as long
 * as the solid is.
 */
#ifndef vtkHaspSolidSweep_h
#define vtkHaspSolidSweep_h

#include "vtkHaspSolidAlgorithm.h"

#include <memory> // for Internals

class vtkAlgorithmOutput;
class vtkDataObject;

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspSolidSweep : public vtkHaspSolidAlgorithm
{
public:
  static vtkHaspSolidSweep* New();
  vtkTypeMacro(vtkHaspSolidSweep, vtkHaspSolidAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Input 1; null for none.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface);
  void SetSurfaceData(vtkDataObject* surface);
  ///@}

  ///@{
  /// Of a tube, mm; default 1.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Of a band, mm; default 6.
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /// Of a band, mm off the surface, from and to; default 0 to 1.
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

protected:
  vtkHaspSolidSweep();
  ~vtkHaspSolidSweep() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspSolidSweep(const vtkHaspSolidSweep&) = delete;
  void operator=(const vtkHaspSolidSweep&) = delete;

  double Radius = 1.0;
  double Width = 6.0;
  double Range[2] = { 0.0, 1.0 };
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
