/**
 * @class   vtkHaspOsteotomyFilter
 * @brief   Cuts the bone of a CT by finite blades into fragments (FragmentCutter.h).
 *
 * Input 0: a vtkImageData with one component of short, unsigned short, unsigned char or float; any
 * spacing and direction. Input 1, optional: labels of the same grid; bone is then what has the
 * value Label, too.
 *
 * Output 0: the meshes of all fragments, world = patient LPS mm, double precision, outward
 * counter-clockwise. Cell array "Fragment": its number, from 1, the largest first. Field data, one
 * tuple a fragment: "FragmentVolumeMm3", "FragmentCrumb", "FragmentResected" (0 or 1); one a cut:
 * "CutAreaMm2", "CutKerfMm3", "CutLeftMm2", "CutFrontMm3", "CutBackMm3", "CutParted" (0 or 1), as
 * CutMeasure says them.
 * Output 1: an image of unsigned short on the input's grid, the fragment's number in each voxel;
 * empty unless LabelImage is on.
 *
 * Errors (vtkErrorMacro, empty outputs): what CutFragments refuses. AbortExecute (from a
 * ProgressEvent) gives empty outputs without an error. Threads: RENDER or a WORKER that owns the
 * pipeline. Uses all cores.
 */
#ifndef vtkHaspOsteotomyFilter_h
#define vtkHaspOsteotomyFilter_h

#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the recipe
#include <string> // for paths

namespace hasp
{
struct CutBone;
struct CutRecipe;
}

class VTKHASPFILTERSSURGICALGUIDE_EXPORT vtkHaspOsteotomyFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkHaspOsteotomyFilter* New();
  vtkTypeMacro(vtkHaspOsteotomyFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

#ifndef __VTK_WRAP__
  /// Where to cut (Planning/CutRecipe.h). Checked when the filter runs.
  void SetRecipe(const hasp::CutRecipe& recipe);
  const hasp::CutRecipe& GetRecipe() const
  {
    return *this->Recipe;
  }
  /// What the last update made, without its meshes; no fragments before, and after an error.
  const hasp::CutBone& GetResult() const
  {
    return *this->Result;
  }
#endif

  /// The recipe from a file (Planning/CutRecipeFile.h). On an error it is reported, the present
  /// recipe stays, and false is returned; always so in a build without HASP_ENABLE_JSON.
  bool ReadRecipe(const std::string& path);

  ///@{
  /// The value of bone in the labels of input 1, if there are any.
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{
  /// Whether output 1 is made. Off.
  vtkSetMacro(LabelImage, bool);
  vtkGetMacro(LabelImage, bool);
  vtkBooleanMacro(LabelImage, bool);
  ///@}

protected:
  vtkHaspOsteotomyFilter();
  ~vtkHaspOsteotomyFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspOsteotomyFilter(const vtkHaspOsteotomyFilter&) = delete;
  void operator=(const vtkHaspOsteotomyFilter&) = delete;

  std::unique_ptr<hasp::CutRecipe> Recipe;
  std::unique_ptr<hasp::CutBone> Result;
  int Label = 1;
  bool LabelImage = false;
};

#endif
