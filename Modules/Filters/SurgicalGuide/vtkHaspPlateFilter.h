/**
 * @class   vtkHaspPlateFilter
 * @brief   Makes an osteosynthesis plate on the bone of a CT: a ribbon of one section along
 *          landmarks, bevelled, with countersunk screw holes (PlateBuilder.h).
 *
 * Input 0: a vtkImageData with one component of short, unsigned short, unsigned char or float; any
 * spacing and direction. Input 1, optional: labels of the same grid, for recipes that move
 * fragments. Output: one closed triangle mesh, world = patient LPS mm, double precision, outward
 * counter-clockwise, 2-manifold and free of self-intersections, also when written as STL. Its field
 * data has an array "ScrewAxes", one tuple a screw: the place where its axis comes through the
 * outer face (3), and its direction out of the bone (3).
 *
 * Thesis 3.1.2 (Paper III): the plate follows landmarks that are laid on the bone. Its faces are
 * offsets of the bone's surface, its sides upright on it.
 *
 * Errors (vtkErrorMacro, empty output): a recipe out of range; a landmark or screw over 3 mm from
 * bone; a curve that leaves bone; bone that slopes away under the plate (PlateBed.h); a screw that
 * is too near to the plate's edge, does not sit in it, clashes with another or meets no bone;
 * fragments without labels; a plate that falls into pieces. AbortExecute (from a ProgressEvent)
 * gives an empty output without an error. Threads: RENDER or a WORKER that owns the pipeline. Uses
 * all cores. Memory: about 21 bytes a point of the grid around the landmarks, and one byte a sample
 * of the input.
 */
#ifndef vtkHaspPlateFilter_h
#define vtkHaspPlateFilter_h

#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the recipe
#include <string> // for paths

namespace hasp
{
struct PlateRecipe;
}

class VTKHASPFILTERSSURGICALGUIDE_EXPORT vtkHaspPlateFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspPlateFilter* New();
  vtkTypeMacro(vtkHaspPlateFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /// What to make (Planning/PlateRecipe.h). Checked when the filter runs.
  void SetRecipe(const hasp::PlateRecipe& recipe);
  const hasp::PlateRecipe& GetRecipe() const
  {
    return *this->Recipe;
  }
#endif

  /// The recipe from a file (Planning/PlateRecipeFile.h). On an error it is reported, the present
  /// recipe stays, and false is returned; always so in a build without HASP_ENABLE_JSON.
  bool ReadRecipe(const std::string& path);

protected:
  vtkHaspPlateFilter();
  ~vtkHaspPlateFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspPlateFilter(const vtkHaspPlateFilter&) = delete;
  void operator=(const vtkHaspPlateFilter&) = delete;

  std::unique_ptr<hasp::PlateRecipe> Recipe;
};

#endif
