#pragma once
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/vec3.hpp>

#include <map>

class vtkImageData;
class vtkImageResliceMapper;
class vtkImageSlice;
class vtkMatrix4x4;
class vtkPlane;

namespace hasp
{

/// A plane through an image as VTK draws it, however the image lies in the world: VTK 9.1's slice
/// mappers leave the direction matrix out, so the image goes to them without one, and its prop has
/// it. Samples are shared, not copied.
/// Threads: RENDER. Cost: nothing until it is drawn; then a value per pixel where the plane, the
/// camera or the image has changed.
class SliceImage
{
public:
  enum class Kind
  {
    Grey,  ///< between samples by trilinear interpolation; opaque
    Labels ///< the nearest; translucent, label 0 is not there
  };
  explicit SliceImage(Kind kind);
  ~SliceImage();

  void SetImage(vtkImageData* image); ///< nullptr: nothing
  vtkImageData* Image() const;
  /// Takes over what has changed in the image itself since. True: something has.
  bool Follow();
  /// Unit normal. What is in the plane is drawn `lift` mm above it: in front of what is below.
  void SetPlane(const glm::dvec3& point, const glm::dvec3& normal, double lift = 0.0);
  void SetWindowLevel(double window, double level);
  /// Components and opacity in [0, 1].
  void SetLabelColours(const std::map<int, glm::dvec3>& colours, double opacity);
  /// For pictures from any side: as many values as the image has, not as the screen has pixels.
  void DrawInSpace();

  vtkImageSlice* Prop() const { return this->Slice; }

private:
  void Place(const glm::dvec3& lift);

  vtkSmartPointer<vtkImageData> Source;
  vtkMTimeType Taken = 0;
  vtkNew<vtkImageResliceMapper> Mapper;
  vtkNew<vtkImageSlice> Slice;
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkMatrix4x4> DataToWorld;
};

/// The image without its direction matrix and origin, samples shared; and the matrix that brings it
/// back to where it was.
vtkSmartPointer<vtkImageData> StraightImage(vtkImageData* image);
void FillDataToWorld(vtkImageData* image, vtkMatrix4x4* matrix);

} // namespace hasp
