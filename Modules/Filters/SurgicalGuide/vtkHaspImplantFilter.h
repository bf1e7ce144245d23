/**
 * @class   vtkHaspImplantFilter
 * @brief   Makes an implant for a hole in the skull of a CT from its healthy side, mirrored
 *          (ImplantBuilder.h).
 *
 * Input: a vtkImageData with one component of short, unsigned short, unsigned char or float; any
 * spacing and direction. Output: one closed triangle mesh, world = patient LPS mm, double
 * precision, outward counter-clockwise, 2-manifold and free of self-intersections, also when
 * written as STL. Its field data has arrays of one tuple: "MirrorPlane", a point (3) and the normal
 * (3); "Axis" (3), against which the implant is put in; "Rim": by how much the mirrored side was
 * moved along the axis, mm, and tilted, degrees, to lie on the bone around the hole, and how far it
 * is off there, mm: root of the mean square, and what 95 % are within. "Holes" has a tuple (3) for
 * each hole. ImplantClaims.h makes of them what the file is held to.
 *
 * The outer face is the mirrored outer table, the inner one an offset of it; the edge is upright
 * along the axis, clearanceMm from bone as seen along it. No tongue is narrower than the implant is
 * thick; corners that stick out are round by half of that.
 *
 * Errors (vtkErrorMacro, empty output), with the place: a recipe out of range; an outline off the
 * bone, that meets itself, or is open over the hole; no hole in it, or two; an axis along the bone;
 * mirrored bone that is not there, has a hole itself or does not meet the bone around the outline;
 * bone unlike its mirror image where no plane is given; holes without room; an implant that falls
 * into pieces. AbortExecute (from a ProgressEvent) gives an empty output without an error. Threads:
 * RENDER or a WORKER that owns the pipeline. Uses all cores. Memory: about 30 bytes a point of the
 * grid around the outline, and one byte a sample of the input.
 */
#ifndef vtkHaspImplantFilter_h
#define vtkHaspImplantFilter_h

#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the recipe
#include <string> // for paths

namespace hasp
{
struct ImplantRecipe;
}

class VTKHASPFILTERSSURGICALGUIDE_EXPORT vtkHaspImplantFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspImplantFilter* New();
  vtkTypeMacro(vtkHaspImplantFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /// What to make (Planning/ImplantRecipe.h). Checked when the filter runs.
  void SetRecipe(const hasp::ImplantRecipe& recipe);
  const hasp::ImplantRecipe& GetRecipe() const
  {
    return *this->Recipe;
  }
#endif

  /// The recipe from a file (Planning/ImplantRecipeFile.h). On an error it is reported, the present
  /// recipe stays, and false is returned; always so in a build without HASP_ENABLE_JSON.
  bool ReadRecipe(const std::string& path);

protected:
  vtkHaspImplantFilter();
  ~vtkHaspImplantFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspImplantFilter(const vtkHaspImplantFilter&) = delete;
  void operator=(const vtkHaspImplantFilter&) = delete;

  std::unique_ptr<hasp::ImplantRecipe> Recipe;
};

#endif
