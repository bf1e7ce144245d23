/**
 * @class   vtkHaspPickedCell
 * @brief   What a pick of a mapper of isosurfaces gives: a point of the surface.
 *
 *   vtkNew<vtkHaspPickedCell> picked;
 *   if (mapper->PickFirstCell(from, to, picked))
 *     ... picked->GetPosition() ...
 *
 * Threads: that of the mapper it is given to.
 */
#ifndef vtkHaspPickedCell_h
#define vtkHaspPickedCell_h

#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro
#include "vtkObject.h"

class VTKHASPRENDERINGISOSURFACE_EXPORT vtkHaspPickedCell : public vtkObject
{
public:
  static vtkHaspPickedCell* New();
  vtkTypeMacro(vtkHaspPickedCell, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Number of the active cell, as hardware selection gives it; of vtkHaspRayCachingMapper that of
  /// the image's cell. -1 before the first pick.
  vtkGetMacro(CellId, vtkIdType);
  /// Voxel: the cell's first corner sample, counted from the image's first.
  vtkGetVector3Macro(IJK, int);
  /// Where in that cell, 0 to 1.
  vtkGetVector3Macro(PCoords, double);
  /// The point is from + T (to - from) of the line that was asked about.
  vtkGetMacro(T, double);
  /// Data coordinates, mm; on the surface within float's rounding.
  vtkGetVector3Macro(Position, double);
  /// Unit, away from the inside.
  vtkGetVector3Macro(Normal, double);
  /// Of the scalars that colour the surface there, interpolated; else the isovalue.
  vtkGetMacro(Value, double);
  /// Of the cell; 0 without labels.
  vtkGetMacro(Label, int);

protected:
  vtkHaspPickedCell();
  ~vtkHaspPickedCell() override;

private:
  vtkHaspPickedCell(const vtkHaspPickedCell&) = delete;
  void operator=(const vtkHaspPickedCell&) = delete;
  friend class vtkHaspClusteredCellMapper; // they fill it
  friend class vtkHaspRayCachingMapper;

  vtkIdType CellId = -1;
  int IJK[3] = { 0, 0, 0 };
  double PCoords[3] = { 0.0, 0.0, 0.0 };
  double T = 0.0;
  double Position[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 0.0 };
  double Value = 0.0;
  int Label = 0;
};

#endif
