/**
 * @class   vtkHaspSharpContour
 * @brief   The surface of a solid as a closed mesh that keeps its edges and corners.
 *
 * Input: a vtkHaspSolid, or a vtkImageData of signed distances in mm, float, negative inside.
 * Output: a vtkPolyData, world millimetres, double precision that floats hold, outward
 * counter-clockwise, 2-manifold and free of self-intersections, also when written as STL
 * (Distance/SharpContour.h). Without normals: an edge has none.
 *
 * The grid is as fine as Spacing, along the world's axes, around the solid; what is thinner than a
 * cell may be missing. FlyingEdges is the plain choice, VTK's own contour of samples on the same
 * grid: edges are cut off, and nothing is promised.
 *
 * Errors (vtkErrorMacro, empty output): no solid; a spacing or tolerance out of its range; a solid
 * without an end where no Bounds are said; a grid that is too large (FlyingEdges: over 2e8 samples,
 * since it samples all), too many triangles. An empty solid gives an empty mesh and a warning
 * (vtkWarningMacro). AbortExecute gives an empty output without an error. Threads: as any VTK
 * filter, one at a time (RENDER or WORKER); uses all cores. Cost: about 1.5 us a triangle on one
 * core, and one byte for 512 samples of the grid; only blocks near the surface are looked at.
 */
#ifndef vtkHaspSharpContour_h
#define vtkHaspSharpContour_h

#include "vtkHaspFiltersDistanceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for Internals

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspSharpContour : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspSharpContour* New();
  vtkTypeMacro(vtkHaspSharpContour, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    SharpContour,
    FlyingEdges
  };

  ///@{
  /// Default SharpContour.
  vtkSetClampMacro(Method, int, SharpContour, FlyingEdges);
  vtkGetMacro(Method, int);
  void SetMethodToSharpContour() { this->SetMethod(SharpContour); }
  void SetMethodToFlyingEdges() { this->SetMethod(FlyingEdges); }
  ///@}

  ///@{
  /// Of the grid, mm; default 0.4.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// What is looked at: x0, x1, y0, y1, z0, z1, world mm. What goes on beyond is cut off there,
  /// flat and with sharp edges. Where low is above high along all axes,
  /// the default: all of the solid.
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /// How far a curved face may be from a triangle's side before that is broken in two, in spacings;
  /// 0.001 to 0.1, default 0.01. Not for FlyingEdges.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// What is more is an error, said before the work from an estimate, or while it grows; default
  /// 2e8, 5 GB. It keeps a mistyped Spacing from running without end. Not for FlyingEdges.
  vtkSetMacro(MaximumNumberOfTriangles, vtkIdType);
  vtkGetMacro(MaximumNumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// Blocks of 8^3 cells in the grid of the last update, and those of them that were looked at.
  vtkGetMacro(NumberOfBlocks, vtkIdType);
  vtkGetMacro(NumberOfBlocksHeld, vtkIdType);
  ///@}

protected:
  vtkHaspSharpContour();
  ~vtkHaspSharpContour() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspSharpContour(const vtkHaspSharpContour&) = delete;
  void operator=(const vtkHaspSharpContour&) = delete;

  int Method = SharpContour;
  double Spacing = 0.4;
  double Bounds[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  double Tolerance = 0.01;
  vtkIdType MaximumNumberOfTriangles = 200'000'000;
  vtkIdType NumberOfBlocks = 0;
  vtkIdType NumberOfBlocksHeld = 0;
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
