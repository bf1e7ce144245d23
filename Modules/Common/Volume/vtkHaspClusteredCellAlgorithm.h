/**
 * @class   vtkHaspClusteredCellAlgorithm
 * @brief   Base of filters and readers whose output is a vtkHaspClusteredCells.
 *
 * As vtkPolyDataAlgorithm for vtkPolyData: one input and one output unless a subclass says
 * otherwise; overwrite RequestData, and FillInputPortInformation where there is an input.
 */
#ifndef vtkHaspClusteredCellAlgorithm_h
#define vtkHaspClusteredCellAlgorithm_h

#include "vtkAlgorithm.h"
#include "vtkHaspCommonVolumeModule.h" // for export macro

class vtkDataObject;
class vtkHaspClusteredCells;

class VTKHASPCOMMONVOLUME_EXPORT vtkHaspClusteredCellAlgorithm : public vtkAlgorithm
{
public:
  vtkTypeMacro(vtkHaspClusteredCellAlgorithm, vtkAlgorithm);

  ///@{
  vtkHaspClusteredCells* GetOutput();
  vtkHaspClusteredCells* GetOutput(int port);
  ///@}

  /// When it comes from no pipeline; SetInputConnection otherwise.
  void SetInputData(vtkDataObject* input);

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkHaspClusteredCellAlgorithm();
  ~vtkHaspClusteredCellAlgorithm() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  virtual int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*);
  virtual int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) = 0;

private:
  vtkHaspClusteredCellAlgorithm(const vtkHaspClusteredCellAlgorithm&) = delete;
  void operator=(const vtkHaspClusteredCellAlgorithm&) = delete;
};

#endif
