/**
 * @class   vtkHaspForceArrows
 * @brief   An actor that shows forces as arrows.
 *
 * Each arrow begins where its force acts and is MmPerNewton times the force long, MaximumMm at most
 * (0: as long as it is). Thickness goes with length: a shaft of 0.06 lengths across, a head a
 * quarter long and 0.2 across. A force of 0 has no arrow. Colour and light are the actor's
 * property.
 *
 * Nothing is made (no mapper, no mesh, no buffer) while no arrow is to be seen; SetArrows of none
 * gives everything back at the next frame of each window.
 *
 * Threads: RENDER only. Errors: a point or force that is not finite is said by vtkErrorMacro with
 * its number, and no arrow is drawn.
 */
#ifndef vtkHaspForceArrows_h
#define vtkHaspForceArrows_h

#include "vtkHaspRenderingPointShellModule.h" // for export macro
#include "vtkOpenGLActor.h"

#ifndef __VTK_WRAP__
#include "ForceArrow.h" // the wrapper would parse GLM, for minutes
#endif

#include <vector> // for vector

class vtkDataArray;
class vtkPoints;

class VTKHASPRENDERINGPOINTSHELL_EXPORT vtkHaspForceArrows : public vtkOpenGLActor
{
public:
  static vtkHaspForceArrows* New();
  vtkTypeMacro(vtkHaspForceArrows, vtkOpenGLActor);

#ifndef __VTK_WRAP__
  /// Takes the place of all arrows; none: an empty vector.
  void SetArrows(std::vector<hasp::ForceArrow> arrows);
#endif
  /// The same for Python: forces has 3 components, N, and one tuple a point.
  void SetArrows(vtkPoints* at, vtkDataArray* forces);
  /// That are drawn.
  int GetNumberOfArrows() const
  {
    return this->Drawn;
  }

  ///@{
  /// Length of an arrow, > 0 and finite. Default 10.
  void SetMmPerNewton(double length);
  vtkGetMacro(MmPerNewton, double);
  ///@}

  ///@{
  /// Longest arrow, mm; 0: as long as they are. Default 0.
  void SetMaximumMm(double length);
  vtkGetMacro(MaximumMm, double);
  ///@}

protected:
  vtkHaspForceArrows();
  ~vtkHaspForceArrows() override;

  double MmPerNewton = 10.0;
  double MaximumMm = 0.0;

private:
  vtkHaspForceArrows(const vtkHaspForceArrows&) = delete;
  void operator=(const vtkHaspForceArrows&) = delete;

  void UpdateMesh();

  std::vector<hasp::ForceArrow> Arrows;
  int Drawn = 0;
};

#endif
