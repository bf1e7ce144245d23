/**
 * @class   vtkHaspCsg
 * @brief   Joins solids: union, intersection, difference, smooth union, offset, shell.
 *
 * Input 0, any number of connections (AddInputConnection): vtkHaspSolid, exact shapes or other
 * trees, and vtkImageData of signed distances in mm, float, negative inside (anatomy;
 * vtkHaspSignedDistance). Output: a vtkHaspSolid. Nothing is sampled: surfaces stay as exact as
 * those of the parts, and vtkHaspSharpContour asks only near them (Distance/Csg.h).
 *
 * An image knows nothing beyond its border: for an offset or a shell it must reach further than
 * that (vtkHaspSignedDistance::SetMargin). Where it does not there is a warning (vtkWarningMacro),
 * and the surface beyond the border is too far out (Distance/GridSolid.h); images that come through
 * another vtkHaspCsg are not looked at.
 *
 * Errors (vtkErrorMacro, no solid): an input without a solid, an image of another type or with
 * values that are no distances, a number that is not finite or out of its range, an offset or shell
 * that goes as far as no sample of an image does, such as beyond a narrow band. Threads: as any VTK
 * filter, one at a time. Cost: O(inputs); of an image 4 bytes a sample, read once and kept
 * until it changes.
 */
#ifndef vtkHaspCsg_h
#define vtkHaspCsg_h

#include "vtkHaspSolidAlgorithm.h"

#include <memory> // for Internals

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspCsg : public vtkHaspSolidAlgorithm
{
public:
  static vtkHaspCsg* New();
  vtkTypeMacro(vtkHaspCsg, vtkHaspSolidAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Operations
  {
    Union,
    Intersection,
    Difference,  ///< the first input less all others
    SmoothUnion, ///< a union whose creases are filled by a fillet, within Radius
    Offset,      ///< the union, larger by Distance, or smaller where that is negative
    Shell        ///< the wall between two offsets of the union, from Range[0] to Range[1]
  };

  ///@{
  vtkSetClampMacro(Operation, int, Union, Shell);
  vtkGetMacro(Operation, int);
  void SetOperationToUnion() { this->SetOperation(Union); }
  void SetOperationToIntersection() { this->SetOperation(Intersection); }
  void SetOperationToDifference() { this->SetOperation(Difference); }
  void SetOperationToSmoothUnion() { this->SetOperation(SmoothUnion); }
  void SetOperationToOffset() { this->SetOperation(Offset); }
  void SetOperationToShell() { this->SetOperation(Shell); }
  ///@}

  ///@{
  /// Of a smooth union, mm, above 0; default 1.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Of an offset, mm; default 0.
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  ///@{
  /// Of a shell, mm off the surface, from and to; default 0 to 1.
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

protected:
  vtkHaspCsg();
  ~vtkHaspCsg() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspCsg(const vtkHaspCsg&) = delete;
  void operator=(const vtkHaspCsg&) = delete;

  int Operation = Union;
  double Radius = 1.0;
  double Distance = 0.0;
  double Range[2] = { 0.0, 1.0 };
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
