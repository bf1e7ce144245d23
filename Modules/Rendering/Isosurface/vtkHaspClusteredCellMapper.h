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
 * selection (cell ids are active cells: GetCellIndex gives the voxel); stereo and off-axis cameras
 * (the eye comes from the full matrix). Inside is sample >= isovalue. Cells with a NaN or
 * infinite corner are left out.
 *
 * Limit: texture, scalar colouring, edges and representation are ignored.
 *
 * Abstract: New() gives the OpenGL implementation of Hasp::RenderingIsosurfaceOpenGL2 (OpenGL 4.3).
 * Threads: RENDER only; extraction uses all cores inside the call.
 * Errors: vtkErrorMacro, and nothing is drawn.
 */
#ifndef vtkHaspClusteredCellMapper_h
#define vtkHaspClusteredCellMapper_h

#include "Grid/ResourceUse.h"                 // for ResourceList
#include "vtkHaspRenderingIsosurfaceModule.h" // for export macro
#include "vtkMapper.h"

#include <memory> // for unique_ptr
#include <string> // for GetRendererChoice

class vtkImageData;

namespace hasp
{
struct ClusteredCells;
}

class VTKHASPRENDERINGISOSURFACE_EXPORT vtkHaspClusteredCellMapper : public vtkMapper
{
public:
  static vtkHaspClusteredCellMapper* New();
  vtkTypeMacro(vtkHaspClusteredCellMapper, vtkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// In the units of the scalars; default 0. A value outside their range draws nothing and is no
  /// error.
  vtkSetMacro(IsoValue, double);
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

  /// What draws opaque surfaces. Both give the same surface, to 0.001 voxel, and shade it alike;
  /// what is translucent is always rasterised.
  enum Renderers
  {
    Automatic, ///< where OpenGL is software the faster one, by timing the first frames of both;
               ///< else the rasteriser
    Rasterize, ///< OpenGL
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
  /// min-max blocks of the volume are kept for the next isovalue. False, after vtkErrorMacro, if
  /// there is no input or it cannot be read. O(samples) for a new volume, O(active blocks) for a
  /// new isovalue.
  bool UpdateCells();

  /// Samples in this box of point indices (x0, x1, y0, y1, z0, z1; clamped to the image) have been
  /// changed in place, and no others since the last update: the next update reads only the blocks
  /// that touch it (sculpting). Call it after the change, and after Modified() of the image if that
  /// is called at all. Several boxes before an update become the box around them.
  void MarkModified(const int extent[6]);

  /// The active cells as of the last update; never null, perhaps empty.
  const hasp::ClusteredCells& GetCells() const;

  /// The voxel (point index i,j,k of the image's first corner sample) of a picked cell id.
  /// False, and ijk untouched, if there is no such active cell.
  bool GetCellIndex(vtkIdType cellId, int ijk[3]) const;

  /// Appends what this mapper holds and what it skipped, with bytes and milliseconds.
  virtual void ListResources(hasp::ResourceList& list) const;

  double* GetBounds() VTK_SIZEHINT(6) override;
  void GetBounds(double bounds[6]) override { this->Superclass::GetBounds(bounds); }
  bool HasOpaqueGeometry() override { return true; }
  bool HasTranslucentPolygonalGeometry() override { return false; }
  bool GetSupportsSelection() override { return true; }

protected:
  vtkHaspClusteredCellMapper();
  ~vtkHaspClusteredCellMapper() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// Counts updates of the cells: what is on the GPU is stale when this has moved.
  vtkMTimeType GetCellsTime() const;

  bool OcclusionCulling = true;
  int Renderer = Automatic;
  int Precision = Exact;

private:
  vtkHaspClusteredCellMapper(const vtkHaspClusteredCellMapper&) = delete;
  void operator=(const vtkHaspClusteredCellMapper&) = delete;

  double IsoValue = 0.0;
  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
