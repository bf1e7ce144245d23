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
 * landmarks or where strokes painted it, as seen along the withdrawal direction, its outer rim
 * rounded. Boxes of slots, flanges, sleeves and letters stand on it. Nothing of all that is under
 * bone as seen along the withdrawal direction, nearer to bone than the gap, or in pores and clefts
 * of the bone that a ball of 1.2 mm does not enter (2.5 spacingMm if that is more), so that it
 * lifts off and has no fins. Where bone is undercut or the region ends the shell ends before it is
 * thinner than that. Slots, holes and engraved
 * letters are cut last, sharp and as wide as the recipe says: the guide is a tree of solids
 * (Distance/Csg.h), and its surface is the sharp contour of that (Distance/SharpContour.h). Thesis
 * 2.1.4 and 3.1.2 (Paper III), with a Euclidean transform instead of the weighted one; see
 * Distance/CoverageDistance.h. Where the recipe asks for a search, the withdrawal direction is that
 * of least undercut near the one given; see GetInsertionAxis.
 *
 * Errors (vtkErrorMacro, empty output): a recipe out of range; a landmark or stroke outside the
 * volume or more than 3 mm from bone; a slot, flange or hole that does not meet the shell, a box or
 * sleeve that does not stand on it, a label that is not on it; no direction to lift off along; a
 * guide that is empty, falls into pieces or encloses a hollow; a working grid of over 2e8 voxels,
 * or finer than 32-bit floats a thousandth of it apart. Crumbs below a hundredth of the guide's
 * volume that a slot leaves are removed. AbortExecute (from a ProgressEvent) gives an empty output
 * without an error. Limits: what is thinner than spacingMm may be missing; of shells thinner than
 * 4.5 spacingMm wedges run out to nothing where bone is undercut. Threads: RENDER or a WORKER that
 * owns the pipeline. Uses all cores. Memory: about 29 bytes a voxel of the working grid, one byte a
 * sample of the input, and the mesh's. Time on the real CT of the demo, two cores: about 1.5 s.
 */
#ifndef vtkHaspGuideFilter_h
#define vtkHaspGuideFilter_h

#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the preview

#include <memory> // for the recipe
#include <string> // for paths
#include <vector> // for blades

class vtkImageData;

namespace hasp
{
struct GuideRecipe;
struct Osteotomy;
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

  /// Blades of planned cuts (Planning/Plan.h, BladesOf), which the guide leads: a slot each behind
  /// those of the recipe, with its point where the blade enters bone. None unless set.
  void SetBlades(const std::vector<hasp::Osteotomy>& blades);
  /// Of the guide made last: the recipe with its blades' slots and the insertion axis found, which
  /// no search is left for. It makes the same guide without blades, and is what ClaimsOf asks for.
  const hasp::GuideRecipe& GetMadeRecipe() const
  {
    return *this->MadeRecipe;
  }
#endif

  /// The recipe from a file (Planning/GuideRecipeFile.h). On an error it is reported, the present
  /// recipe stays, and false is returned; always so in a build without HASP_ENABLE_JSON.
  bool ReadRecipe(const std::string& path);

  /// A quick look at the guide of the present input, recipe and blades, without a mesh: an image in
  /// the world's place, float, mm to the guide's surface, inside >= 0. Its isosurface at 0 is the
  /// guide, to be drawn as clustered cells (vtkHaspClusteredCellFilter); edges are blunt by less
  /// than a voxel. spacingMm: at least the recipe's; the working grid is as coarse as that where
  /// the recipe allows it, which a guide that is barely possible may pass here and not as a mesh,
  /// or look otherwise in pores of the bone. Errors as above, and null. The mesh is not made, and
  /// what Update made stays.
  vtkSmartPointer<vtkImageData> MakePreview(double spacingMm = 0.8);

  /// Of the guide made last: the unit direction it lifts off along, and the share of the bone's
  /// area around the landmarks that it does not reach, -1 if no search was asked for
  /// (axisSearchDeg).
  void GetInsertionAxis(double direction[3]) const;
  double GetUndercutShare() const;

protected:
  vtkHaspGuideFilter();
  ~vtkHaspGuideFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspGuideFilter(const vtkHaspGuideFilter&) = delete;
  void operator=(const vtkHaspGuideFilter&) = delete;

  std::unique_ptr<hasp::GuideRecipe> Recipe, MadeRecipe;
  std::vector<hasp::Osteotomy> Blades;
  double UndercutShare = -1.0;
};

#endif
