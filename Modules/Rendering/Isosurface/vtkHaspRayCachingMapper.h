/**
 * @class   vtkHaspRayCachingMapper
 * @brief   Draws an isosurface whose isovalue may change every frame, by rays that are spread over
 * frames and a cache of what they met.
 *
 * Give it a vtkImageData (short, unsigned short, unsigned char or float; any spacing and direction
 * matrix) and put it in a vtkActor:
 *
 *   vtkNew<vtkHaspRayCachingMapper> mapper;
 *   mapper->SetInputConnection(reader->GetOutputPort());
 *   mapper->SetIsoValue(300.0);
 *   actor->SetMapper(mapper);
 *
 * Mode says how. Cache is RayCaching (thesis 3.2.1, Paper V): each frame a few rays a tile of the
 * picture; where one meets the surface, the block of 8^3 cells around the hit goes into a circular
 * buffer of fixed size, which is drawn with the exact root in each cell. A picture is complete
 * after some frames: render until IsRefining() is false. One cache serves both eyes, all windows
 * and all actors. Raycast and RaycastSkipping are the direct ways it is measured against: complete
 * in each frame, opaque only, cell ids are the image's; the GPU holds the samples. Automatic takes
 * the cheaper one of Cache and all active cells, by measurement.
 *
 * Honoured: as vtkHaspClusteredCellMapper honours them, the actor's matrix and property, lights,
 * clipping planes, hardware selection (cell ids hold until the next frame; PickFirstCell gives
 * the point of a line), stereo and off-axis cameras. Scalar colours and labels: use
 * vtkHaspClusteredCellMapper.
 *
 * Abstract: New() gives the OpenGL implementation of Hasp::RenderingIsosurfaceOpenGL2. Raycast and
 * RaycastSkipping need OpenGL 4.3: in a window with less a warning says so once, and all active
 * cells are drawn instead, with light where it is asked for; cell ids are theirs. The other modes
 * draw what they always do, traced (vtkHaspClusteredCellMapper::Renderers), down to OpenGL 3.2.
 * Threads: RENDER only; rays use all cores inside the call.
 * Errors: vtkErrorMacro, and nothing is drawn.
 */
#ifndef vtkHaspRayCachingMapper_h
#define vtkHaspRayCachingMapper_h

#include "Grid/ResourceUse.h"                 // for ResourceList
#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro
#include "vtkMapper.h"

#include <memory> // for unique_ptr
#include <string> // for string

class FailedUpdate;
class MappedVolume;
class vtkHaspPickedCell;
class vtkImageData;

class VTKHASPRENDERINGISOSURFACE_EXPORT vtkHaspRayCachingMapper : public vtkMapper
{
public:
  static vtkHaspRayCachingMapper* New();
  vtkTypeMacro(vtkHaspRayCachingMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// In the units of the scalars. A value outside their range draws nothing and is no error. Until
  /// it is set it is the middle of the scalars' range, found anew for each new image (0 before the
  /// first update).
  virtual void SetIsoValue(double value);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /// The volume, when it comes from no pipeline; SetInputConnection otherwise.
  void SetInputData(vtkImageData* image);
  vtkImageData* GetImage(); ///< null if there is no input
  ///@}

  enum Modes
  {
    Automatic,      ///< the cheaper one of Cache and of drawing all active cells, measured; these
                    ///< where the surface is translucent, for rays find no more than its front
    Cache,          ///< RayCaching; a translucent surface lacks what lies behind its front, and a
                    ///< warning says so once
    Raycast,        ///< a ray a pixel on the GPU, at a fixed step from end to end; OpenGL 4.3
    RaycastSkipping ///< the same, but blocks of 8^3 cells without surface are passed in one step
  };
  ///@{
  /// Default Automatic.
  vtkSetClampMacro(Mode, int, Automatic, RaycastSkipping);
  vtkGetMacro(Mode, int);
  void SetModeToAutomatic() { this->SetMode(Automatic); }
  void SetModeToCache() { this->SetMode(Cache); }
  void SetModeToRaycast() { this->SetMode(Raycast); }
  void SetModeToRaycastSkipping() { this->SetMode(RaycastSkipping); }
  ///@}
  ///@{
  /// What draws the cells, those of the cache and all active ones: one of
  /// vtkHaspClusteredCellMapper::Renderers. Where rays are traced they meet what the cache holds,
  /// and nothing else. Default Automatic; Trace, where it is not built in, is refused with an
  /// error.
  virtual void SetRenderer(int renderer);
  vtkGetMacro(Renderer, int);
  ///@}
  /// What drew last, and why: "cache: 62.1 ms, all active cells 74.0 ms".
  virtual std::string GetModeChoice() const { return "nothing drawn"; }

  ///@{
  /// Of Raycast and RaycastSkipping: voxels between two samples of a ray, 0.05 to 4, default 1.
  /// Where two lie on either side of the isovalue, the exact root between them is drawn; what a ray
  /// enters and leaves between two is missed.
  vtkSetClampMacro(StepSize, double, 0.05, 4.0);
  vtkGetMacro(StepSize, double);
  ///@}

  ///@{
  /// As vtkHaspClusteredCellMapper has them. Automatic then draws all active cells; the other modes
  /// know no light and draw without, with an error that is said once.
  vtkSetMacro(AmbientOcclusion, bool);
  vtkGetMacro(AmbientOcclusion, bool);
  vtkBooleanMacro(AmbientOcclusion, bool);
  void SetAmbientOcclusionDistance(double mm);
  vtkGetMacro(AmbientOcclusionDistance, double);
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /// Rays in a tile of 16x16 pixels, a frame and an eye: more make a picture complete in fewer
  /// frames. 1 to 256, default 8. 256 are one through each pixel's middle, for a still picture: it
  /// is complete in two or three frames. Not used where a frame budget is set.
  vtkSetClampMacro(RaysPerTile, int, 1, 256);
  vtkGetMacro(RaysPerTile, int);
  ///@}

  ///@{
  /// Milliseconds that a frame of an eye may take; the mapper then chooses the rays a tile by
  /// itself, between 1 and 256, from what its last frame took. 0, the default: RaysPerTile. What
  /// the cache holds is drawn all the same.
  vtkSetClampMacro(FrameBudget, double, 0.0, 1e6);
  vtkGetMacro(FrameBudget, double);
  ///@}

  ///@{
  /// Cast some rays from where the camera will be if it moves on as it did? Default on; costs a
  /// quarter more rays while the camera moves.
  vtkSetMacro(Prediction, bool);
  vtkGetMacro(Prediction, bool);
  vtkBooleanMacro(Prediction, bool);
  ///@}

  /// Did the last four frames of an eye, drawn from the cache alone, find something that it had
  /// not (the last one, if it had a ray a pixel)? Then render again. Eyes that are no longer drawn
  /// do not count.
  virtual bool IsRefining() const { return false; }

  /// Samples in this box of point indices (x0, x1, y0, y1, z0, z1; clamped to the image) have been
  /// changed in place, and no others since the last update: the next update reads only the blocks
  /// that touch it (sculpting). Call it after the change, and after Modified() of the image if that
  /// is called at all. Several boxes before an update become the box around them.
  void MarkModified(const int extent[6]);

  /// Where the line from `from` to `to` first meets the surface, in any mode, drawn or not: the
  /// exact root. In the actor's data coordinates, like the result: where the actor has a matrix,
  /// take both points through its inverse first. False, and the result untouched, if the line
  /// misses it. Clipping planes are not asked. A ray: about a microsecond.
  bool PickFirstCell(const double from[3], const double to[3], vtkHaspPickedCell* result);

  /// Appends what this mapper holds and what it skipped, with bytes and milliseconds.
  virtual void ListResources(hasp::ResourceList& list) const;

  /// Of the volume. Brings the pipeline up to date.
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  bool GetSupportsSelection() override { return true; }

protected:
  vtkHaspRayCachingMapper();
  ~vtkHaspRayCachingMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// Brings the pipeline and the min-max blocks up to date; changed samples are still to be read.
  /// False, after vtkErrorMacro, if there is no input or it cannot be drawn.
  bool UpdateVolume();
  MappedVolume& GetVolume() { return *this->Volume; }
  /// Counts images: what was made of the last one is stale when this has moved.
  vtkMTimeType GetVolumeTime() const { return this->VolumeTime; }

  int Mode = Automatic;
  int Renderer;
  double StepSize = 1.0;
  int RaysPerTile = 8;
  double FrameBudget = 0.0;
  bool Prediction = true;
  bool AmbientOcclusion = false;
  double AmbientOcclusionDistance = 25.0;
  bool Shadows = false;

private:
  vtkHaspRayCachingMapper(const vtkHaspRayCachingMapper&) = delete;
  void operator=(const vtkHaspRayCachingMapper&) = delete;

  double IsoValue = 0.0;
  bool IsoValueIsSet = false;
  vtkMTimeType VolumeTime = 0;
  std::unique_ptr<MappedVolume> Volume;
  std::unique_ptr<FailedUpdate> Failed;
};

#endif
