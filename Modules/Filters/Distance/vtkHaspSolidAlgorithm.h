/**
 * @class   vtkHaspSolidAlgorithm
 * @brief   Base of sources and filters whose output is a vtkHaspSolid.
 *
 * As vtkPolyDataAlgorithm for vtkPolyData: one input and one output unless a subclass says
 * otherwise; overwrite RequestData, and FillInputPortInformation where there is an input.
 */
#ifndef vtkHaspSolidAlgorithm_h
#define vtkHaspSolidAlgorithm_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkHaspFiltersDistanceModule.h" // for export macro

class vtkHaspSolid;

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspSolidAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkHaspSolidAlgorithm, vtkDataObjectAlgorithm);

  vtkHaspSolid* GetOutput();

protected:
  vtkHaspSolidAlgorithm() = default;
  ~vtkHaspSolidAlgorithm() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspSolidAlgorithm(const vtkHaspSolidAlgorithm&) = delete;
  void operator=(const vtkHaspSolidAlgorithm&) = delete;
};

#endif
