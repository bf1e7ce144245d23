/**
 * @class   vtkHaspLightPass
 * @brief   One light for all actors of a renderer: bone and parts shade each other.
 *
 *   vtkNew<vtkHaspLightPass> light;
 *   light->SetModeToTraced();
 *   renderer->SetPass(light);
 *
 * Opaque actors are drawn as ever, by whatever mapper they have; then rays find in the tracer what
 * was drawn, and its light takes the place of what the mappers shaded. Actors of
 * vtkHaspClusteredCellMapper take part as active cells, those of a vtkPolyDataMapper as triangles,
 * each with its matrix and property, in one scene with one environment: both shade and light each
 * other. What is translucent is drawn over it: by depth peeling if the renderer uses it, else by
 * VTK's order-independent translucency. Translucent actors cast no shadow and are lit as ever.
 * Volumes and overlays follow, as without this pass.
 *
 * Modes
 *   Lamps             the renderer's lights, with shadows if Shadows is on. One ray a pixel and
 * light AmbientOcclusion  the same, times the openness of the surroundings within
 *                     AmbientOcclusionDistance; kept while the view moves (hasp::SceneLightCache)
 *   Traced            the hybrid: light of the environment by paths of Bounces surfaces, kept while
 *                     the view moves
 *   PathTraced        paths of each pixel from scratch, with smooth edges, on a thread of their own
 *                     until there are SamplesPerPixel; given up at once when the view moves
 *
 * Environment of the last two: the Radiance file of EnvironmentFileName (.hdr, in latitude and
 * longitude; damage is found, which vtkHDRReader passes on as whatever memory holds); else the
 * renderer's EnvironmentTexture (8 bits are taken as sRGB); else daylight (hasp::SkyModel). All
 * with the renderer's EnvironmentUp and EnvironmentRight as VTK's image based lighting has them:
 * the middle of a map lies towards Right, three quarters of its width towards Right x Up. The
 * renderer's lights join it if LampsInPaths is on.
 *
 * Materials: vtkProperty's colour, and with physically based interpolation its metallic, roughness
 * and index of refraction; else a coat as bright and smooth as Specular and SpecularPower say. In
 * the last two modes colours are taken as sRGB and the picture is encoded so, as VTK's physically
 * based shading does; in the others neither, as its Phong shading. Colours of scalars: those of
 * polydata's points and cells; not textures. The ambient colour is added as it is, as a mark that
 * lights nothing.
 *
 * Left as drawn, and casting no shadow: wireframes, points and lines, what is unlit, mappers of
 * other kinds, and cells with labels of which something is said. ListResources counts them. Limits:
 * clipping planes cut what is seen, not what casts shadow; PathTraced does not see them at all, and
 * behind its smooth edges lies the background, not a vtkSkybox; with the window's multisamples
 * some pixels there keep a sample of what was drawn. What mirrors throw of a sun onto others is
 * found by few paths: white dots until there are thousands. Scalar colours of cells, edges and the
 * renderer's FXAA and SSAO are not seen; volumes are drawn after all surfaces.
 *
 * One pass is for one renderer: in another, while the first has it still, it is an error and
 * draws no light. With two eyes in turn each begins anew what adds up, though kept light serves
 * both.
 *
 * Threads: RENDER; rays use all cores inside the call. PathTraced has a WORKER while it works.
 * Needs Embree (HASP_ENABLE_EMBREE), else there is no such class. OpenGL 3.2.
 * Errors: vtkErrorMacro, once until something changes, and the picture as drawn.
 */
#ifndef vtkHaspLightPass_h
#define vtkHaspLightPass_h

#include "Grid/ResourceUse.h"            // for ResourceList
#include "vtkHaspRenderingLightModule.h" // for export macro
#include "vtkRenderPass.h"

#include <memory> // for unique_ptr
#include <string> // for the file's name

class vtkRenderWindow;
class vtkRenderer;

namespace hasp
{
struct SceneLightRequest;
}

class VTKHASPRENDERINGLIGHT_EXPORT vtkHaspLightPass : public vtkRenderPass
{
public:
  static vtkHaspLightPass* New();
  vtkTypeMacro(vtkHaspLightPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Modes
  {
    Lamps,
    AmbientOcclusion,
    Traced,
    PathTraced
  };
  ///@{
  /// Default Traced.
  vtkSetClampMacro(Mode, int, Lamps, PathTraced);
  vtkGetMacro(Mode, int);
  void SetModeToLamps() { this->SetMode(Lamps); }
  void SetModeToAmbientOcclusion() { this->SetMode(AmbientOcclusion); }
  void SetModeToTraced() { this->SetMode(Traced); }
  void SetModeToPathTraced() { this->SetMode(PathTraced); }
  ///@}

  ///@{
  /// Of lamps, in all modes but PathTraced, where they always cast one. A vtkLight's
  /// ShadowAttenuation is the share that is lost in it. Default on.
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /// Millimetres beyond which nothing darkens; above 0, may be infinite. An error, and no change,
  /// for other values. Default 25.
  void SetAmbientOcclusionDistance(double mm);
  vtkGetMacro(AmbientOcclusionDistance, double);
  ///@}

  ///@{
  /// Surfaces that light may have met on its way to the eye; 1: direct light alone. Default 3.
  vtkSetClampMacro(Bounces, int, 1, 64);
  vtkGetMacro(Bounces, int);
  ///@}

  ///@{
  /// Path of a .hdr file; empty, the default: see above. It is read by the next frame that needs
  /// it.
  vtkSetStdStringFromCharMacro(EnvironmentFileName);
  vtkGetCharFromStdStringMacro(EnvironmentFileName);
  ///@}

  ///@{
  /// Do the renderer's lights light Traced and PathTraced pictures, too? Default off: the
  /// environment alone.
  vtkSetMacro(LampsInPaths, bool);
  vtkGetMacro(LampsInPaths, bool);
  vtkBooleanMacro(LampsInPaths, bool);
  ///@}

  ///@{
  /// What radiance is multiplied by in Traced and PathTraced. 0, the default: so that the mean
  /// light of the environment (and lamps) makes a white surface 0.55.
  vtkSetClampMacro(Exposure, double, 0.0, 1e30);
  vtkGetMacro(Exposure, double);
  ///@}

  ///@{
  /// After which PathTraced is done. Default 256.
  vtkSetClampMacro(SamplesPerPixel, int, 1, 1 << 20);
  vtkGetMacro(SamplesPerPixel, int);
  ///@}
  ///@{
  /// Does Render return only when PathTraced has all samples? For pictures in files. Meanwhile
  /// ProgressEvent tells the share of samples, and the window's AbortRender (its AbortCheckEvent is
  /// where to ask for it) gives up: the picture then has the samples there are. Default off.
  vtkSetMacro(WaitForSamples, bool);
  vtkGetMacro(WaitForSamples, bool);
  vtkBooleanMacro(WaitForSamples, bool);
  ///@}
  ///@{
  /// PathTraced begins with what Traced knows, which counts as 16 samples, and shows that while the
  /// view moves. Off: from black, by its own samples alone. Default on.
  vtkSetMacro(TemporalAccumulation, bool);
  vtkGetMacro(TemporalAccumulation, bool);
  vtkBooleanMacro(TemporalAccumulation, bool);
  ///@}

  /// Will another frame of the same view be better? Until 64 frames are drawn of it, or in
  /// PathTraced until there are SamplesPerPixel.
  bool IsRefining() const;
  int GetSamples() const; ///< that the last PathTraced picture shows

  /// Appends what this pass holds and what it left out, with bytes and milliseconds.
  void ListResources(hasp::ResourceList& list) const;

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkHaspLightPass();
  ~vtkHaspLightPass() override;

private:
  vtkHaspLightPass(const vtkHaspLightPass&) = delete;
  void operator=(const vtkHaspLightPass&) = delete;

  class Opaque; // the opaque step of VTK's steps
  class Selection;
  struct Internals;
  vtkRenderPass* Translucency(const vtkRenderState* state);
  bool IsMine(vtkRenderer* renderer);
  bool Try(void (vtkHaspLightPass::*step)(const vtkRenderState*), const vtkRenderState* state);
  void KeepBehind(const vtkRenderState* state);
  void Compose(const vtkRenderState* state);
  void TracePaths(vtkRenderWindow* window, bool same);
  void MixPaths();
  hasp::SceneLightRequest Request() const;

  int Mode = Traced;
  bool Shadows = true, LampsInPaths = false, WaitForSamples = false, TemporalAccumulation = true;
  double AmbientOcclusionDistance = 25.0, Exposure = 0.0;
  int Bounces = 3, SamplesPerPixel = 256;
  std::string EnvironmentFileName;
  std::unique_ptr<Internals> Internal;
};

#endif
