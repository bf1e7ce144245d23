/**
 * @class   vtkHaspClusteredCells
 * @brief   The active cells of an isosurface as a VTK data object: all that drawing the surface
 * takes.
 *
 * Holds hasp::ClusteredCells (Isosurface/ClusteredCells.h), which nobody changes once they are
 * made: copies share them and cost nothing, mappers and tracers on other threads may hold on to
 * them. vtkHaspClusteredCellFilter makes them of a vtkImageData, vtkHaspClusteredCellReader reads
 * them from a .hcells file, vtkHaspClusteredCellMapper draws them.
 *
 * Threads: as any VTK data object, one at a time; the cells themselves from any thread.
 */
#ifndef vtkHaspClusteredCells_h
#define vtkHaspClusteredCells_h

#include "vtkDataObject.h"
#include "vtkHaspCommonVolumeModule.h" // for export macro

#include <memory> // for shared_ptr

class vtkInformation;
class vtkInformationVector;

// Of Isosurface/ClusteredCells.h, to be included by who uses them: the wrapper would parse GLM.
namespace hasp
{
struct ClusteredCells;
}

class VTKHASPCOMMONVOLUME_EXPORT vtkHaspClusteredCells : public vtkDataObject
{
public:
  static vtkHaspClusteredCells* New();
  vtkTypeMacro(vtkHaspClusteredCells, vtkDataObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Never null: without cells, of an empty grid.
  void SetCells(std::shared_ptr<const hasp::ClusteredCells> cells);
  std::shared_ptr<const hasp::ClusteredCells> GetCells() const;
  ///@}

  vtkIdType GetNumberOfCells();
  vtkIdType GetNumberOfClusters();
  double GetIsoValue();
  /// Whether they hold 8 bits a corner in place of the volume's samples.
  bool GetCompact();
  /// Samples of the volume along each axis; 0 if there is none.
  void GetDimensions(int dimensions[3]);
  /// Of the whole volume, in world millimetres, as the image's: uninitialised if there is none.
  void GetBounds(double bounds[6]);

  /// KiB, attributes included.
  unsigned long GetActualMemorySize() override;
  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  void DeepCopy(vtkDataObject* source) override;

  ///@{
  static vtkHaspClusteredCells* GetData(vtkInformation* info);
  static vtkHaspClusteredCells* GetData(vtkInformationVector* vector, int i = 0);
  ///@}

protected:
  vtkHaspClusteredCells();
  ~vtkHaspClusteredCells() override;

private:
  vtkHaspClusteredCells(const vtkHaspClusteredCells&) = delete;
  void operator=(const vtkHaspClusteredCells&) = delete;

  std::shared_ptr<const hasp::ClusteredCells> Cells;
};

#endif
