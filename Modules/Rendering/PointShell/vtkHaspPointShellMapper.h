/**
 * @class   vtkHaspPointShellMapper
 * @brief   Draws a pointshell as a closed surface of discs, without a mesh.
 *
 * Give it one of three things and put it in a vtkActor; the input is drawn while there is neither
 * shell nor discs:
 *
 *   mapper->SetPointShell(shell);      // static: hasp::PointShell, its first SetLevels levels
 *   mapper->SetDiscs(discs);           // dynamic: what HAPTIC copied, a new pointer each frame
 *   mapper->SetInputConnection(port);  // vtkPolyData with point normals, for any VTK pipeline
 *
 * Each point is an oriented disc that covers its share of the surface and, by Overlap, some of its
 * neighbours'. Discs are elliptical-weighted-average splats (Zwicker et al. 2001; drawn as Botsch
 * et al. 2005; thesis 2.2.1, Papers I and II) in three passes: nearest depth; Gaussian-weighted
 * normals, depths and colours of all discs within one disc radius behind it; shading. In each
 * fragment the ray is intersected with the disc's plane; a disc smaller than about a pixel is
 * widened to one (low-pass filter). The blended depth is written, so the surface mixes with any
 * other actor. Radius: sqrt(area / pi) times Overlap; error falls as the area does.
 *
 * Coordinates: those of the discs (body axes of a shell), mm, placed by the actor's matrix, which
 * may rotate, move and scale, also unevenly.
 *
 * Honoured: the actor's matrix, colour, ambient, diffuse, specular, opacity, lights, culling of
 * faces (a disc faces where its normal points; without culling it is lit from both sides); clipping
 * planes (not capped); stereo and off-axis cameras (the eye comes from the full matrix); hardware
 * selection (cell ids are discs). A translucent shell shows its nearest layer alone, what is behind
 * it shines through; VTK's order-independent translucency and depth peeling see that one layer.
 *
 * A vtkPolyData needs finite points and point normals (any length but zero). Areas are the point
 * array AreaArrayName, mm^2; without it each point's area is that of the circle which holds its
 * eight nearest neighbours, over eight. Level is 0.
 *
 * Limits: scalars, texture, edges and representation are ignored; discs that reach behind the eye
 * are not drawn (so keep the near plane further away than a disc is wide); at most
 * GL_MAX_TEXTURE_BUFFER_SIZE / 2 discs (32768 in the worst driver that OpenGL 3.2 allows, 67
 * million on Mesa); render passes that change an actor's shaders find only the
 * //VTK::DepthPeeling lines.
 *
 * Nothing is made (no buffer, shader or texture) until there is a disc to draw; a new pointer with
 * discs that did not change uploads the changed ones alone. Needs OpenGL 3.2.
 * Threads: RENDER only. Errors: vtkErrorMacro, once until something changes, and nothing is drawn.
 */
#ifndef vtkHaspPointShellMapper_h
#define vtkHaspPointShellMapper_h

#include "Grid/ResourceUse.h"                 // for ResourceList
#include "vtkHaspRenderingPointShellModule.h" // for export macro
#include "vtkMapper.h"

#include <memory> // for shared_ptr
#include <string> // for string
#include <vector> // for vector

namespace hasp
{
class PointShell;
struct ShellDisc;
}

class VTKHASPRENDERINGPOINTSHELL_EXPORT vtkHaspPointShellMapper : public vtkMapper
{
public:
  static vtkHaspPointShellMapper* New();
  vtkTypeMacro(vtkHaspPointShellMapper, vtkMapper);

  /// Takes the place of discs. Null: nothing, or the input if there is one.
  void SetPointShell(std::shared_ptr<const hasp::PointShell> shell);
  /// Takes the place of a shell. Body axes, mm; normals unit within 1 %, areas >= 0. Whoever gives
  /// it leaves it as it is. Null: nothing, or the input if there is one.
  void SetDiscs(std::shared_ptr<const std::vector<hasp::ShellDisc>> discs);

  ///@{
  /// Of a shell: draw the first so many levels; 0, or more than there are: all. Default 0.
  vtkSetClampMacro(Levels, int, 0, VTK_INT_MAX);
  vtkGetMacro(Levels, int);
  ///@}

  ///@{
  /// Point array of a vtkPolyData that has the areas, mm^2. Default "Area".
  virtual void SetAreaArrayName(const std::string& name);
  vtkGetMacro(AreaArrayName, std::string);
  ///@}

  ///@{
  /// Radius of a disc over that of the circle with its area, [1, 8]. Below 1.5 there are holes
  /// where points are spread unevenly. Default 1.8.
  vtkSetClampMacro(Overlap, double, 1.0, 8.0);
  vtkGetMacro(Overlap, double);
  ///@}

  ///@{
  /// Each level in the colour of GetLevelColor instead of the property's. Default off.
  vtkSetMacro(ColorByLevel, bool);
  vtkGetMacro(ColorByLevel, bool);
  vtkBooleanMacro(ColorByLevel, bool);
  ///@}
  /// Eight colours, again from the first at level 8.
  static void GetLevelColor(int level, double rgb[3]) VTK_SIZEHINT(rgb, 3);

  /// Brings the discs up to date and counts them; 0 if what was given is refused.
  vtkIdType GetNumberOfDiscs();

  using Superclass::GetBounds;
  /// Of the discs, data coordinates; uninitialised bounds without discs.
  double* GetBounds() VTK_SIZEHINT(6) override;
  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// What it holds on the GPU and what it skipped, for --explain.
  virtual void ListResources(hasp::ResourceList& list) const;

protected:
  vtkHaspPointShellMapper();
  ~vtkHaspPointShellMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  int Levels = 0;
  std::string AreaArrayName = "Area";
  double Overlap = 1.8;
  bool ColorByLevel = false;

private:
  vtkHaspPointShellMapper(const vtkHaspPointShellMapper&) = delete;
  void operator=(const vtkHaspPointShellMapper&) = delete;

  void UpdateDiscs();

  struct Internals;
  std::unique_ptr<Internals> Inside;
};

#endif
