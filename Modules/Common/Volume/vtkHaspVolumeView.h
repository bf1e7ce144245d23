#ifndef vtkHaspVolumeView_h
#define vtkHaspVolumeView_h

#include "Grid/GridView.h"             // for AnyGridView
#include "Grid/TriangleMesh.h"         // for TriangleMesh
#include "vtkHaspCommonVolumeModule.h" // for export macro
#include "vtkSmartPointer.h"           // for return values

#include <vector> // for samples

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

/// The one door between VTK data and kernels. Functions, not classes: nothing is kept.
/// Any thread, as long as no other thread changes the VTK object meanwhile.
namespace hasp
{

/// Geometry of an image: extent, origin, spacing and direction matrix. Sample (0,0,0) of the result
/// is the first sample of the image's extent. Throws std::invalid_argument like
/// GridGeometry::Validate.
VTKHASPCOMMONVOLUME_EXPORT GridGeometry ImageGeometry(vtkImageData* image);

/// The active scalars of an image, without a copy; the image must outlive the view.
/// Throws std::invalid_argument if there are none, if they have more than one component or are not
/// one for each point, or if their type is not short, unsigned short, unsigned char or float
/// (signed char counts as neither: convert it first).
VTKHASPCOMMONVOLUME_EXPORT AnyGridView ViewImage(vtkImageData* image);

/// The same of any array with one value for each point of the image.
VTKHASPCOMMONVOLUME_EXPORT AnyGridView ViewPointArray(vtkImageData* image, vtkDataArray* values);

/// Samples and geometry as a new image; the samples are copied once. T as in AnyGridView.
template <typename T>
vtkSmartPointer<vtkImageData> MakeImage(
  const GridGeometry& geometry, const std::vector<T>& samples);

/// Points become double precision, so that nothing is lost before a file is written.
VTKHASPCOMMONVOLUME_EXPORT vtkSmartPointer<vtkPolyData> MakePolyData(const TriangleMesh& mesh);

/// Triangles of a polydata. Throws std::invalid_argument on strips and on polygons with more than
/// three corners (run vtkTriangleFilter first), and above 2^32 - 1 points. Verts and lines are
/// ignored.
VTKHASPCOMMONVOLUME_EXPORT TriangleMesh MakeTriangleMesh(vtkPolyData* polyData);

/// Triangles of any polydata: strips and polygons of more than three corners are cut up as VTK's
/// cells do. Throws as MakeTriangleMesh, and for null.
VTKHASPCOMMONVOLUME_EXPORT TriangleMesh TrianglesOf(vtkPolyData* surface);

} // namespace hasp

#endif
