#ifndef vtkHaspDistanceColours_h
#define vtkHaspDistanceColours_h

#include "vtkHaspRenderingDistanceModule.h" // for export macro
#include "vtkSmartPointer.h"                // for return values

class vtkDiscretizableColorTransferFunction;
class vtkScalarBarActor;

/// The one way in which Hasp draws signed distances of surfaces: a diverging map, centred at 0,
/// over a fixed range in mm, whatever the data. Functions; nothing is kept. RENDER thread.
namespace hasp
{

struct DistanceColourSettings
{
  double rangeMm = 3.0; ///< colours run from -rangeMm to rangeMm, [0.01, 1000]; beyond they stay
  int steps = 0;        ///< 0: smooth; else so many colours of one width, odd, [3, 255]
};

/// Moreland's cool-warm map (Moreland 2009, "Diverging Color Maps for Scientific Visualization",
/// Eqs. 1 to 3: from (59, 76, 192) to (180, 4, 38) by way of a neutral grey, straight in Msh), as
/// VTK interpolates it: blue inside, red outside. Safe for red-green blindness: blue against red,
/// and its lightness falls to either side (TestDistanceColours holds L*). No distance (NaN) is
/// dark yellow. Throws std::invalid_argument on settings out of range.
VTKHASPRENDERINGDISTANCE_EXPORT vtkSmartPointer<vtkDiscretizableColorTransferFunction>
MakeDistanceColours(const DistanceColourSettings& settings = {});

/// The scale of these colours, upright at the right edge of a view, labelled in mm at both ends, at
/// 0 and between. Give it to a renderer (AddActor2D).
VTKHASPRENDERINGDISTANCE_EXPORT vtkSmartPointer<vtkScalarBarActor> MakeDistanceScale(
  vtkDiscretizableColorTransferFunction* colours);

} // namespace hasp

#endif
