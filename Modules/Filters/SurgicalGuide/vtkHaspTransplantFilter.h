/**
 * @class   vtkHaspTransplantFilter
 * @brief   Fills a defect of the jaw with segments of a donor bone (TransplantBuilder.h).
 *
 * Input 0: the recipient's CT, a vtkImageData with one component of short, unsigned short, unsigned
 * char or float; any spacing and direction. Input 1, optional: the donor's CT, likewise, in a world
 * of its own; without it input 0 holds both bones.
 *
 * All outputs are meshes or lines in double precision, mm, outward counter-clockwise.
 * Output 0: the segments in the defect. Cell array "Segment": its number, from 0. Field data, one
 * tuple a segment: "SegmentLengthMm", "SegmentShortestMm", "SegmentLongestMm", "SegmentWedgeDeg",
 * "SegmentVolumeMm3"; one a joint: "JointBendDeg", "JointWedgeDeg", "JointGapMm", "JointOverlapMm",
 * "JointContactMm2", "JointStepMm2", as MadeJoint says them.
 * Output 1: the same segments where they lie in the donor.
 * Output 2: the jaw after the resection, without what is resected and without crumbs. Cell array
 * "Fragment", as vtkHaspOsteotomyFilter's.
 * Output 3: lines in the defect: the vessel's parts, and the skin paddle's outline, closed. Cell
 * array "Paddle": 0 or 1.
 *
 * Warnings (vtkWarningMacro): MadeTransplant's. Errors (vtkErrorMacro, empty outputs): what
 * MakeTransplant refuses. AbortExecute (from a ProgressEvent) gives empty outputs without an error.
 * The mitre guide is a guide: give MakeMitreGuideRecipe's recipe to vtkHaspGuideFilter. Threads:
 * RENDER or a WORKER that owns the pipeline. Uses all cores.
 */
#ifndef vtkHaspTransplantFilter_h
#define vtkHaspTransplantFilter_h

#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the recipe
#include <string> // for paths

namespace hasp
{
struct MadeTransplant;
struct TransplantRecipe;
}

class VTKHASPFILTERSSURGICALGUIDE_EXPORT vtkHaspTransplantFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspTransplantFilter* New();
  vtkTypeMacro(vtkHaspTransplantFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /// What to make (Planning/TransplantRecipe.h). Checked when the filter runs.
  void SetRecipe(const hasp::TransplantRecipe& recipe);
  const hasp::TransplantRecipe& GetRecipe() const
  {
    return *this->Recipe;
  }
  /// What the last update made, without its meshes; no segments before, and after an error.
  const hasp::MadeTransplant& GetResult() const
  {
    return *this->Result;
  }
#endif

  /// The recipe from a file (Planning/TransplantRecipeFile.h). On an error it is reported, the
  /// present recipe stays, and false is returned; always so in a build without HASP_ENABLE_JSON.
  bool ReadRecipe(const std::string& path);

protected:
  vtkHaspTransplantFilter();
  ~vtkHaspTransplantFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspTransplantFilter(const vtkHaspTransplantFilter&) = delete;
  void operator=(const vtkHaspTransplantFilter&) = delete;

  std::unique_ptr<hasp::TransplantRecipe> Recipe;
  std::unique_ptr<hasp::MadeTransplant> Result;
};

#endif
