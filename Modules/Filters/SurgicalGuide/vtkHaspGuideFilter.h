/**
 * @class   vtkHaspGuideFilter
 * @brief   Makes a surgical guide that fits the bone of a CT: a shell with saw slots and holes.
 *
 * Input: a vtkImageData with one component of short, unsigned short, unsigned char or float; any
 * spacing and direction. Output: one closed triangle mesh, world = patient LPS mm, double
 * precision, outward counter-clockwise, 2-manifold and free of self-intersections, also when
 * written as STL.
 *
 * The shell lies from gapMm to gapMm + thicknessMm off the isosurface, widthMm around the
 * landmarks, and nowhere under bone as seen along the withdrawal direction, so that it lifts off.
 * Slots and holes go right through it. Thesis 2.1.4 and 3.1.2 (Paper III), with a Euclidean
 * transform instead of the weighted one; see Distance/CoverageDistance.h.
 *
 * Errors (vtkErrorMacro, empty output): a recipe out of range; a landmark outside the volume or
 * more than 3 mm from bone; a slot or hole that does not meet the guide; a guide that is empty,
 * falls into pieces or encloses a hollow; a working grid of over 2e8 voxels. Crumbs below a
 * hundredth of the guide's volume that a slot leaves are removed. AbortExecute (from a
 * ProgressEvent) gives an empty output without an error. Threads: RENDER or a WORKER that owns the
 * pipeline. Uses all cores. Memory: about 21 bytes a voxel of the working grid, and one byte a
 * sample of the input.
 */
#ifndef vtkHaspGuideFilter_h
#define vtkHaspGuideFilter_h

#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the recipe
#include <string> // for paths

namespace hasp
{
struct GuideRecipe;
}

class VTKHASPFILTERSSURGICALGUIDE_EXPORT vtkHaspGuideFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspGuideFilter* New();
  vtkTypeMacro(vtkHaspGuideFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /// What to make (Planning/GuideRecipe.h). Checked when the filter runs.
  void SetRecipe(const hasp::GuideRecipe& recipe);
  const hasp::GuideRecipe& GetRecipe() const
  {
    return *this->Recipe;
  }
#endif

  /// The recipe from a file (Planning/GuideRecipeFile.h). On an error it is reported, the present
  /// recipe stays, and false is returned; always so in a build without HASP_ENABLE_JSON.
  bool ReadRecipe(const std::string& path);

protected:
  vtkHaspGuideFilter();
  ~vtkHaspGuideFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspGuideFilter(const vtkHaspGuideFilter&) = delete;
  void operator=(const vtkHaspGuideFilter&) = delete;

  std::unique_ptr<hasp::GuideRecipe> Recipe;
};

#endif
