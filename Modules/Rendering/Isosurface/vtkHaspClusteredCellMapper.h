/**
 * @class   vtkHaspClusteredCellMapper
 * @brief   Draws the exact trilinear isosurface of a volume from its active cells, without a mesh.
 *
 * Give it a vtkImageData (short, unsigned short, unsigned char or float; any spacing and direction
 * matrix), an isovalue, and put it in a vtkActor:
 *
 *   vtkNew<vtkHaspClusteredCellMapper> mapper;
 *   mapper->SetInputConnection(reader->GetOutputPort());
 *   mapper->SetIsoValue(300.0);
 *   actor->SetMapper(mapper);
 *
 * Or give it a vtkHaspClusteredCells (from vtkHaspClusteredCellFilter or a .hcells file): it is
 * drawn as it is, its isovalue is its own, and IsoValue means nothing.
 *
 * The cells that the surface crosses are extracted once per volume and isovalue, with their corner
 * samples. Each is drawn as one point, or one screen rectangle where a point will not do, in whose
 * fragments the ray meets the trilinear polynomial (thesis 3.2.2, Paper VI; cell rasterisation
 * after Liu, Clapworthy, Dong 2009). Or rays are traced on the CPU: SetRenderer. Depth is that of
 * the hit and the normal is the analytic gradient, so the surface mixes with any other actor.
 *
 * Honoured: the actor's matrix, colour, ambient, diffuse, specular and opacity (VTK's
 * order-independent translucency and depth peeling); lights; clipping planes (not capped); hardware
 * selection (cell ids are active cells: GetCellIndex gives the voxel, PickCell the point;
 * vtkCellPicker needs a vtkHaspClusteredCellLocator); stereo
 * and off-axis cameras (the eye comes from the full matrix). Inside is sample >= isovalue. Cells
 * with a NaN or infinite corner are left out.
 *
 * Where VTK peels depths, each pixel shows every layer that the surface has there, sorted among
 * those of other actors: within 2 of 255 of what its ray meets, as long as MaximumNumberOfPeels is
 * half of the layers or more, OcclusionRatio is 0 and the peels have 16 bits a channel. The mapper
 * sees to that: VTK has 8, which alone are 3 of 255 off with eight layers.
 *
 * Scalar colours are vtkMapper's, off unless ScalarVisibility is on: lookup table, scalar range,
 * scalar mode, colour mode and InterpolateScalarsBeforeMapping mean what they mean there, for point
 * data. They are mapped at the stored corners, so a new lookup table extracts nothing. Where they
 * are the volume's own samples (scalar mode default, unless the image's active scalars are others)
 * the whole surface has the colour of the isovalue, for that is their value there. Cell and field
 * data are refused.
 *
 * Labels: name a point array of whole numbers and each cell takes the most frequent label of its
 * inside corners. A label can have a colour, a rigid pose and be hidden; all are drawn in one pass.
 *
 * Limit: texture, edges, representation and culling of faces are ignored. Render passes that change
 * an actor's shaders are asked, but there are only the //VTK::DepthPeeling lines for them to fill;
 * vtkSSAOPass and vtkValuePass need vtkPolyDataMapper.
 *
 * Abstract: New() gives the OpenGL implementation of Hasp::RenderingIsosurfaceOpenGL2. It needs
 * OpenGL 4.3; below, down to VTK's own 3.2, it traces rays and refuses what is always rasterised.
 * Threads: RENDER only; extraction uses all cores inside the call.
 * Errors: vtkErrorMacro, once until something changes, and nothing is drawn.
 */
#ifndef vtkHaspClusteredCellMapper_h
#define vtkHaspClusteredCellMapper_h

#include "Grid/ResourceUse.h"                 // for ResourceList
#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro
#include "vtkMapper.h"

#include <cstdint> // for uint32_t
#include <memory>  // for unique_ptr
#include <span>    // for span
#include <string>  // for string

class vtkAbstractArray;
class vtkDataArray;
class vtkHaspPickedCell;
class vtkImageData;
class vtkLinearTransform;
class vtkMatrix4x4;
class vtkPointData;
class vtkTable;

namespace hasp
{
struct CellColoring;
struct CellLabel;
struct CellLabels;
struct ClusteredCells;
struct LineHit;
}

class VTKHASPRENDERINGISOSURFACE_EXPORT vtkHaspClusteredCellMapper : public vtkMapper
{
public:
  static vtkHaspClusteredCellMapper* New();
  vtkTypeMacro(vtkHaspClusteredCellMapper, vtkMapper);
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
  vtkImageData* GetImage(); ///< null if the input is none, or cells
  ///@}

  ///@{
  /// Leave out the clusters that are hidden by what is in front of them? Never changes the picture.
  /// Where surfaces lie behind each other it saves most of a frame, where they do not it costs a
  /// little; 24 bytes a cluster of memory while it is on. Default on.
  vtkSetMacro(OcclusionCulling, bool);
  vtkGetMacro(OcclusionCulling, bool);
  vtkBooleanMacro(OcclusionCulling, bool);
  ///@}

  ///@{
  /// Blend normals and colours between neighbouring cells? The trilinear surface has facets where
  /// its gradient jumps from cell to cell, most where samples are noisy or have few grey levels;
  /// blended shading is smooth, and the depth stays exact. Opaque drawing alone; translucent
  /// surfaces are drawn as without. Every cell is drawn twice, once four times as large, and there
  /// are textures of 24 to 56 bytes a pixel; nothing while it is off. Default off.
  vtkSetMacro(BlendNormals, bool);
  vtkGetMacro(BlendNormals, bool);
  vtkBooleanMacro(BlendNormals, bool);
  ///@}

  /// What draws opaque surfaces. Both give the same surface, to 0.001 voxel, and shade it alike;
  /// what is translucent is always rasterised, and so are labels of which something is said,
  /// colours of another array and blended normals. In a window with an OpenGL below 4.3 nothing is:
  /// an error says once that these are not drawn, or no surface where Rasterize is asked for.
  enum Renderers
  {
    Automatic, ///< rays below OpenGL 4.3; where OpenGL is software the faster one, by timing the
               ///< first frames of both; else the rasteriser
    Rasterize, ///< OpenGL 4.3
    Trace      ///< rays on the CPU, by all cores; needs a build with Embree
  };
  ///@{
  /// Default Automatic. Trace, where it is not built in, is refused with an error.
  virtual void SetRenderer(int renderer);
  vtkGetMacro(Renderer, int);
  void SetRendererToAutomatic() { this->SetRenderer(Automatic); }
  void SetRendererToRasterize() { this->SetRenderer(Rasterize); }
  void SetRendererToTrace() { this->SetRenderer(Trace); }
  ///@}
  ///@{
  /// Darken what stands close to other parts of the surface? Ambient and diffuse colours are
  /// multiplied by the share of the hemisphere that is open within AmbientOcclusionDistance. It
  /// adds up over frames: the first picture is as good as 16 rays a pixel, one of a still camera
  /// becomes better, and is as dear as the first for about 150 frames. See hasp::LightCache; 34 MB,
  /// 28 bytes a pixel and 40 a surface pixel, nothing while it is off.
  /// Light takes traced rays: Automatic then traces, and what is rasterised all the same is drawn
  /// without, with an error that is said once. What clipping planes or other actors do is not seen.
  /// Default off.
  vtkSetMacro(AmbientOcclusion, bool);
  vtkGetMacro(AmbientOcclusion, bool);
  vtkBooleanMacro(AmbientOcclusion, bool);
  ///@}

  ///@{
  /// Millimetres of the volume beyond which nothing darkens; above 0, may be infinite. An error,
  /// and no change, for other values. Default 25.
  void SetAmbientOcclusionDistance(double mm);
  vtkGetMacro(AmbientOcclusionDistance, double);
  ///@}

  ///@{
  /// Does the surface cast a hard shadow on itself, of the renderer's first light that is switched
  /// on? One ray a pixel; as above otherwise. Default off.
  vtkSetMacro(Shadows, bool);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  /// Which renderer drew last, and why: "traced: traced in 31.0 ms, rasterised in 412.5 ms".
  virtual std::string GetRendererChoice() const;

  /// How the corners of cells that are extracted from a volume are kept.
  enum Precisions
  {
    Exact,  ///< the samples, bit for bit
    Compact ///< 8 bits each: less memory, and the surface moves by hundredths of a voxel
            ///< (CompactLevels)
  };
  ///@{
  /// Default Exact. Cells that are the input stay as they are.
  vtkSetClampMacro(Precision, int, Exact, Compact);
  vtkGetMacro(Precision, int);
  void SetPrecisionToExact() { this->SetPrecision(Exact); }
  void SetPrecisionToCompact() { this->SetPrecision(Compact); }
  ///@}

  /// Brings the active cells up to date with input and isovalue; Render does it by itself. The
  /// min-max blocks of the volume are kept for the next isovalue. False if there is no input or it
  /// cannot be read; vtkErrorMacro says so once, and nothing is tried again, until mapper or input
  /// change. O(samples) for a new volume, O(active blocks) for a new isovalue.
  bool UpdateCells();

  /// Samples in this box of point indices (x0, x1, y0, y1, z0, z1; clamped to the image) have been
  /// changed in place, and no others since the last update: the next update reads only the blocks
  /// that touch it (sculpting). Call it after the change, and after Modified() of the image if that
  /// is called at all. Several boxes before an update become the box around them.
  void MarkModified(const int extent[6]);

  /// The same of labels: values of the label array have been changed in place in this box, and no
  /// samples. Only the clusters that touch it get their labels anew, and only what differs goes to
  /// the GPU. Call it after Modified() of the array if that is called at all.
  void MarkLabelsModified(const int extent[6]);

  /// The active cells as of the last update; never null, perhaps empty.
  const hasp::ClusteredCells& GetCells() const;
#ifndef __VTK_WRAP__
  /// The same for who keeps them, on other threads too: surface and place stay as they are now,
  /// whatever this mapper does next. An edit in place then copies them once.
  std::shared_ptr<const hasp::ClusteredCells> ShareCells() const;
#endif

  /// The voxel (point index i,j,k of the image's first corner sample) of a picked cell id.
  /// False, and ijk untouched, if there is no such active cell.
  bool GetCellIndex(vtkIdType cellId, int ijk[3]) const;

  ///@{
  /// Name of the point array that holds a label a sample: short, unsigned short or unsigned char, 0
  /// to 65535, 0 for none. Empty, the default: no labels, and nothing of what follows costs
  /// anything.
  vtkSetStdStringFromCharMacro(LabelArrayName);
  vtkGetCharFromStdStringMacro(LabelArrayName);
  ///@}

  ///@{
  /// How label n is drawn. Components in [0, 1]; alpha multiplies the actor's opacity. A pose moves
  /// the label's cells, rigidly, in the actor's data coordinates (labelToWorld where the actor has
  /// no matrix of its own); it is copied, so set it again after a change; null takes it away.
  /// Errors: vtkErrorMacro, and nothing changes, if n is not in [0, 65535], a component is out of
  /// range or the pose is not rigid.
  void SetLabelColor(int n, double r, double g, double b, double a = 1.0);
  void SetLabelPose(int n, vtkMatrix4x4* pose);
  void SetLabelPose(int n, vtkLinearTransform* pose);
  void SetLabelVisibility(int n, bool visible);
  /// Forgets colours, poses and visibilities of all labels.
  void ClearLabels();
  const hasp::CellLabels& GetLabels() const;
  ///@}

  /// Where the line from `from` to `to` first meets the surface in the active cell `cellId`, as
  /// hardware selection gives it. In the actor's data coordinates, like the result: where the actor
  /// has a matrix, take both points through its inverse first. False, and the result untouched, if
  /// there is no such cell or the line misses the surface in it. Clipping planes are not asked. No
  /// result need be given.
  bool PickCell(
    vtkIdType cellId, const double from[3], const double to[3], vtkHaspPickedCell* result) const;
  /// The same for the first of all cells along the line that are not hidden. O(clusters).
  bool PickFirstCell(const double from[3], const double to[3], vtkHaspPickedCell* result) const;

  ///@{
  /// Appends what this mapper holds and what it skipped, with bytes and milliseconds; or fills a
  /// table with it, columns "resource", "bytes", "milliseconds" and "reason".
  virtual void ListResources(hasp::ResourceList& list) const;
  void ListResources(vtkTable* table) const;
  ///@}

  /// Of the volume, and of the volume in each pose of a label. Brings the pipeline up to date, no
  /// cells.
  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override
  {
    this->Superclass::GetBounds(bounds);
  }
  vtkMTimeType GetMTime() override;
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  bool GetSupportsSelection() override
  {
    return true;
  }

protected:
  vtkHaspClusteredCellMapper();
  ~vtkHaspClusteredCellMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// Counts updates of the cells: what is on the GPU is stale when this has moved.
  vtkMTimeType GetCellsTime() const;
  /// The samples, first and last index along each axis, that the last update read because they had
  /// been marked, and GetCellsTime() of before; 0 if it read all.
  vtkMTimeType GetLastEdit(int low[3], int high[3]) const;
  /// The same of the cells' labels and colours.
  vtkMTimeType GetAttributesTime() const;
  /// Whether all that has changed of the cells since `since`, what was then the later of both
  /// times, are the labels of cells [first, end).
  bool GetLastLabelEdit(vtkMTimeType since, std::size_t& first, std::size_t& end) const;
  /// Counts changes of what is said of labels.
  vtkMTimeType GetLabelsTime() const;
  /// How they are coloured by scalars, as of the last update.
  const hasp::CellColoring& GetColoring() const;

  bool OcclusionCulling = true;
  bool BlendNormals = false;
  bool AmbientOcclusion = false;
  double AmbientOcclusionDistance = 25.0;
  bool Shadows = false;
  int Renderer = Automatic;
  int Precision = Exact;

private:
  vtkHaspClusteredCellMapper(const vtkHaspClusteredCellMapper&) = delete;
  void operator=(const vtkHaspClusteredCellMapper&) = delete;

  vtkDataArray* LabelArrayOf(vtkImageData* image) const;
  void UpdateLabels(hasp::ClusteredCells& cells, vtkImageData* image);
  void UpdateColors(hasp::ClusteredCells& cells, vtkImageData* image);
  void UseColorsOf(const hasp::ClusteredCells& finished);
  vtkAbstractArray* FindColorArray(vtkImageData* image);
  void ColorByDensity(vtkPointData* data, float isovalue);
  void ColorByArray(hasp::ClusteredCells& cells, vtkPointData* data, vtkAbstractArray* array);
  void MapColors(vtkPointData* data, vtkAbstractArray* array, vtkDataArray* values,
    std::span<std::uint32_t> colors);
  hasp::CellLabel* LabelOf(int n);
  const hasp::CellLabel* LabelOfCell(std::size_t cell) const;
  void Tell(const hasp::LineHit& hit, vtkHaspPickedCell* result) const;

  double IsoValue = 0.0;
  bool IsoValueIsSet = false;
  std::string LabelArrayName;
  struct Internals;
  std::unique_ptr<Internals> Internal;
  struct Attributes;
  std::unique_ptr<Attributes> Attribute;
};

#endif
