/**
 * @class   vtkHaspSolidSource
 * @brief   A shape as a solid: plane, slab, box, rounded box, cylinder, stadium, capsule, text.
 *
 * Output: a vtkHaspSolid, exact, for vtkHaspCsg and vtkHaspSharpContour. One shape at a time: each
 * SetTo... takes the place of the one before. World millimetres; directions need not be unit.
 *
 * Errors (vtkErrorMacro; the shape stays what it was, and false is returned): a number that is not
 * finite, a size not above 0, a direction of no length, a letter that there is not
 * (Distance/SolidShapes.h, SolidSweeps.h). A source without a shape is an error when it is updated.
 * Threads: as any VTK source. Cost: none to speak of.
 */
#ifndef vtkHaspSolidSource_h
#define vtkHaspSolidSource_h

#include "vtkHaspSolidAlgorithm.h"

#include <memory> // for shared_ptr
#include <string> // for text

namespace hasp
{
class ImplicitSolid;
}

class VTKHASPFILTERSDISTANCE_EXPORT vtkHaspSolidSource : public vtkHaspSolidAlgorithm
{
public:
  static vtkHaspSolidSource* New();
  vtkTypeMacro(vtkHaspSolidSource, vtkHaspSolidAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// All that is behind the plane; `normal` points out. Without an end: to cut others with.
  bool SetToPlane(const double point[3], const double normal[3]);
  /// All within width / 2 of a plane: the kerf of a saw.
  bool SetToSlab(const double point[3], const double normal[3], double width);
  /// `half`: half its sides.
  bool SetToBox(const double center[3], const double half[3]);
  /// Turned; `axes` as rows of a direction matrix (vtkImageData): its columns are the box's axes.
  bool SetToBox(const double center[3], const double half[3], const double axes[9]);
  /// The same outer measures, with edges of this radius, below the smallest of `half`.
  bool SetToRoundedBox(const double center[3], const double half[3], double radius);
  bool SetToRoundedBox(
    const double center[3], const double half[3], double radius, const double axes[9]);
  /// From the middle of one end to that of the other: a drill's hole.
  bool SetToCylinder(const double a[3], const double b[3], double radius);
  /// A plate with round ends: within radius of a to b as seen along `normal`, and of this height.
  bool SetToStadium(
    const double a[3], const double b[3], const double normal[3], double radius, double height);
  /// All within radius of a segment; a ball if both ends are the same.
  bool SetToCapsule(const double a[3], const double b[3], double radius);
  /// Letters A to Z, 0 to 9, space and . - / + : of round strokes, to engrave or to emboss;
  /// `origin` is the lower left corner of the first, `right` and `up` directions of writing, height
  /// that of a letter, stroke the diameter of a stroke, at most height / 6.
  /// The axes of the strokes lie in one plane.
  bool SetToText(const std::string& text, const double origin[3], const double right[3],
    const double up[3], double height, double stroke);

  /// From the first letter's axis to the last one's, mm: how wide a text will be, less a stroke.
  /// All have the same width: whether there are such letters is not asked.
  static double GetTextWidth(const std::string& text, double height);

protected:
  vtkHaspSolidSource();
  ~vtkHaspSolidSource() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHaspSolidSource(const vtkHaspSolidSource&) = delete;
  void operator=(const vtkHaspSolidSource&) = delete;

  /// What `make` gives, or an error.
  template <typename Make>
  bool Set(const Make& make);

  std::shared_ptr<const hasp::ImplicitSolid> Solid;
};

#endif
