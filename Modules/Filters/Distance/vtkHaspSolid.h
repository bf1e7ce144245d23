/**
 * @class   vtkHaspSolid
 * @brief   A solid as a function of the place, in a VTK pipeline: no samples, no mesh.
 *
 * Holds a hasp::ImplicitSolid (Distance/ImplicitSolid.h), which nobody changes once it is made:
 * copies share it and cost nothing, filters on other threads may hold on to it.
 * vtkHaspSolidSource and vtkHaspSolidSweep make shapes, vtkHaspCsg joins them and signed distances
 * of anatomy, vtkHaspSharpContour makes a mesh. World millimetres; negative inside.
 *
 * Threads: as any VTK data object, one at a time; the solid itself from any thread.
 */
#ifndef vtkHaspSolid_h
#define vtkHaspSolid_h

#include "vtkDataObject.h"
#include "vtkHaspFiltersDistanceModule.h" // for export macro

#include <memory> // for shared_ptr

class vtkInformation;
class vtkInformationVector;

// Of Distance/ImplicitSolid.h, to be included by who uses it: the wrapper would parse GLM.
namespace hasp
{
class ImplicitSolid;
}

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspSolid : public vtkDataObject
{
public:
  static vtkHaspSolid* New();
  vtkTypeMacro(vtkHaspSolid, vtkDataObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Null, the default: there is none.
  void SetSolid(std::shared_ptr<const hasp::ImplicitSolid> solid);
  std::shared_ptr<const hasp::ImplicitSolid> GetSolid() const;
  ///@}

  /// Signed distance or a bound of it, mm; +infinity where there is no solid.
  double EvaluateDistance(const double place[3]);
  /// The gradient of that, mm a mm, out of the solid; 0 where there is none.
  void EvaluateGradient(const double place[3], double gradient[3]);
  /// Smooth parts of the surface; 0 without a solid.
  vtkIdType GetNumberOfFaces();
  /// World millimetres; infinite along an axis without an end; uninitialised (VTK: 1, -1) if there
  /// is no solid, or nothing can be inside.
  void GetBounds(double bounds[6]);

  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  /// The same as ShallowCopy: what cannot change needs no copy.
  void DeepCopy(vtkDataObject* source) override;

  ///@{
  static vtkHaspSolid* GetData(vtkInformation* info);
  static vtkHaspSolid* GetData(vtkInformationVector* vector, int i = 0);
  ///@}

protected:
  vtkHaspSolid();
  ~vtkHaspSolid() override;

private:
  vtkHaspSolid(const vtkHaspSolid&) = delete;
  void operator=(const vtkHaspSolid&) = delete;

  std::shared_ptr<const hasp::ImplicitSolid> Solid;
};

#endif
