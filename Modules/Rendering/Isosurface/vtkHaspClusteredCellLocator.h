/**
 * @class   vtkHaspClusteredCellLocator
 * @brief   Makes vtkCellPicker meet the surface that a vtkHaspClusteredCellMapper draws.
 *
 * vtkCellPicker asks a mapper for its input, here a volume, and takes the first voxel of it that
 * the line passes: a point on the volume's box. vtkMapper::GetInput cannot be overridden, so a
 * picker needs to be told once:
 *
 *   locator->SetMapper(mapper);
 *   picker->AddLocator(locator);
 *
 * From then on picks are exact: the root in the first active cell, labels with poses where they
 * are, hidden ones not at all. vtkCellPicker's cell id, CellIJK and PCoords are those of the
 * image's voxel; its normal is the view direction, for voxels have none: PickFirstCell of the
 * mapper gives the surface's. vtkHardwareSelector, vtkPropPicker and vtkWorldPointPicker need no
 * locator.
 *
 * Threads: RENDER. Nothing is built or kept; a line costs O(clusters).
 * Limit: lines only; closest points and cells in a box are not answered. The mapper's input must be
 * a volume: vtkCellPicker asks no locator where it is vtkHaspClusteredCells, for those are no
 * vtkDataSet. PickFirstCell answers then, too.
 */
#ifndef vtkHaspClusteredCellLocator_h
#define vtkHaspClusteredCellLocator_h

#include "vtkAbstractCellLocator.h"
#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro
#include "vtkSmartPointer.h"                  // for the mapper

class vtkHaspClusteredCellMapper;

class VTKHASPRENDERINGISOSURFACE_EXPORT vtkHaspClusteredCellLocator : public vtkAbstractCellLocator
{
public:
  static vtkHaspClusteredCellLocator* New();
  vtkTypeMacro(vtkHaspClusteredCellLocator, vtkAbstractCellLocator);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whose cells are met; it is held.
  void SetMapper(vtkHaspClusteredCellMapper* mapper);
  vtkHaspClusteredCellMapper* GetMapper();
  ///@}

  /// The mapper's input, by which a picker tells locators apart.
  vtkDataSet* GetDataSet() override;

  /// In the image's coordinates. 0 if nothing is met. tol is not used: the surface is exact.
  using Superclass::IntersectWithLine;
  int IntersectWithLine(const double p1[3], const double p2[3], double tol, double& t, double x[3],
    double pcoords[3], int& subId, vtkIdType& cellId, vtkGenericCell* cell) override;

  void BuildLocator() override {}
  void FreeSearchStructure() override {}
  void GenerateRepresentation(int, vtkPolyData*) override {}

protected:
  vtkHaspClusteredCellLocator();
  ~vtkHaspClusteredCellLocator() override;

private:
  vtkHaspClusteredCellLocator(const vtkHaspClusteredCellLocator&) = delete;
  void operator=(const vtkHaspClusteredCellLocator&) = delete;

  vtkSmartPointer<vtkHaspClusteredCellMapper> Mapper;
};

#endif
