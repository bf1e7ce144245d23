/**
 * @class   vtkHaspSegmentationFilter
 * @brief   Makes labels of a scan: bone, and its fragments, as a recipe says.
 *
 * Input 0: a vtkImageData with one component of short, unsigned short, unsigned char or float; any
 * extent, spacing and direction. Input 1, may be left out: labels that the recipe's steps begin
 * with, unsigned char or unsigned short, on the grid of input 0. Output: "Labels", unsigned short,
 * on the same grid: 0 nothing, 1 bone that nobody has named, 2 and above a fragment each; with what
 * labels are called as field data (vtkHaspLabelTable.h), which vtkHaspSegmentationWriter writes: as
 * the recipe says, else as input 1 does.
 *
 * The recipe's steps (Planning/SegmentationRecipe.h) are done in order: filters of the samples, a
 * threshold, random walker splits by strokes (Grady 2006; BoneSplit; thesis 2.1.3), edits. The same
 * labels with any number of threads. For a user who adds a stroke at a time hasp::Segmenter is the
 * door: it goes on where the last stroke ended.
 *
 * Warnings (vtkWarningMacro): what SegmentationWarnings.h says of steps that changed nothing and
 * strokes that marked nothing, once a run. Errors (vtkErrorMacro, empty output): a recipe or an
 * input that is out of order, with the step and the key. AbortExecute gives an empty output without
 * an error. Threads: as any VTK filter, one at a time; uses all cores. Cost and memory:
 * hasp::Segmenter, RandomWalker.h.
 */
#ifndef vtkHaspSegmentationFilter_h
#define vtkHaspSegmentationFilter_h

#include "vtkHaspFiltersSegmentationModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the recipe
#include <string> // for paths

namespace hasp
{
struct SegmentationRecipe;
}

class VTKHASPFILTERSSEGMENTATION_EXPORT vtkHaspSegmentationFilter : public vtkImageAlgorithm
{
public:
  static vtkHaspSegmentationFilter* New();
  vtkTypeMacro(vtkHaspSegmentationFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /// What to do. Checked when the filter runs. As made it has no steps: all labels are 0, or those
  /// of input 1.
  void SetRecipe(const hasp::SegmentationRecipe& recipe);
  const hasp::SegmentationRecipe& GetRecipe() const
  {
    return *this->Recipe;
  }
#endif

  /// The recipe from a file (Planning/SegmentationRecipeFile.h). On an error it is reported, the
  /// present recipe stays, and false is returned; always so in a build without HASP_ENABLE_JSON.
  bool ReadRecipe(const std::string& path);

  ///@{
  /// How exactly splits are solved: the error of probabilities, (0, 0.1], checked when the filter
  /// runs, whatever the recipe. Default: RandomWalker.h.
  void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkHaspSegmentationFilter();
  ~vtkHaspSegmentationFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspSegmentationFilter(const vtkHaspSegmentationFilter&) = delete;
  void operator=(const vtkHaspSegmentationFilter&) = delete;

  std::unique_ptr<hasp::SegmentationRecipe> Recipe;
  double Tolerance;
};

#endif
