#include "VolumeLook.h"

#include "vtkHaspVolumeFile.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace hasp
{
namespace
{

constexpr std::array<double, 2> BoneWindow{ 0.0, 2000.0 }; // HU: water, cortical bone
constexpr double SkinHU = -300.0, BoneRampHU = 100.0;
constexpr double SkinReach = 300.0; // HU, to both sides: its voxels are partly air
constexpr std::array<double, 3> SkinColor{ 0.90, 0.62, 0.50 };
constexpr double SkinOpacity = 0.20, BoneOpacity = 0.6;       // along the length of a voxel
constexpr double BrightestStep = 0.25, TranslucentStep = 0.5; // of the smallest spacing

double LeastSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return *std::min_element(spacing, spacing + 3);
}

/// A single sample along an axis becomes two, half its spacing to both sides: VTK's mapper draws
/// what lies between samples, and nothing lies between one.
vtkSmartPointer<vtkImageData> WithThickness(vtkImageData* image)
{
  int size[3], thick[3];
  image->GetDimensions(size);
  double first[3] = { 0, 0, 0 };
  for (int a = 0; a < 3; ++a)
  {
    thick[a] = std::max(size[a], 2);
    first[a] = size[a] == 1 ? -0.5 : 0.0;
  }
  if (std::equal(size, size + 3, thick))
    return image;
  auto result = vtkSmartPointer<vtkImageData>::New();
  double origin[3];
  image->TransformContinuousIndexToPhysicalPoint(first, origin);
  result->SetDimensions(thick);
  result->SetOrigin(origin);
  result->SetSpacing(image->GetSpacing());
  result->SetDirectionMatrix(image->GetDirectionMatrix());
  vtkDataArray* from = image->GetPointData()->GetScalars();
  result->AllocateScalars(from->GetDataType(), 1);
  vtkDataArray* to = result->GetPointData()->GetScalars();
  vtkIdType n = 0;
  for (vtkIdType k = 0; k < thick[2]; ++k)
    for (vtkIdType j = 0; j < thick[1]; ++j)
      for (vtkIdType i = 0; i < thick[0]; ++i, ++n)
        to->SetTuple(n,
          std::min<vtkIdType>(i, size[0] - 1) +
            size[0] *
              (std::min<vtkIdType>(j, size[1] - 1) + size[1] * std::min<vtkIdType>(k, size[2] - 1)),
          from);
  return result;
}

/// VTK's GPU mapper also where OpenGL is software. Its fixed-point mapper takes two thirds of the
/// time there for the brightest values, a sixth for compositing, and loses what rays meet that run
/// nearly along an axis of the voxels: in a skull from the front, a black line between the eyes.
/// vtkSmartVolumeMapper chooses that one where it takes the memory to be short, without a word.
vtkSmartPointer<vtkVolume> MakeVolume(vtkImageData* image, double step)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(WithThickness(image));
  mapper->SetAutoAdjustSampleDistances(false);
  mapper->SetUseJittering(false);
  mapper->SetSampleDistance(static_cast<float>(step * LeastSpacing(image)));
  vtkNew<vtkVolumeProperty> property;
  property->SetInterpolationTypeToLinear();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  return volume.Get();
}

double RampUp(double value, double from, double to)
{
  return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

/// The more opaque of skin and bone; where their ramps cross it is off by less than the skin's.
vtkSmartPointer<vtkPiecewiseFunction> Opacity(double bone, const VolumeLook& look)
{
  const double ramp = look.boneRamp;
  std::vector<double> values{ bone - ramp, bone, bone + ramp };
  if (look.skin)
    values.insert(values.end(), { *look.skin - SkinReach, *look.skin, *look.skin + SkinReach });
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const double value : values)
  {
    const double ofBone = BoneOpacity * RampUp(value, bone - ramp, bone + ramp);
    const double ofSkin =
      look.skin ? SkinOpacity * std::max(0.0, 1.0 - std::abs(value - *look.skin) / SkinReach) : 0.0;
    opacity->AddPoint(value, std::max(ofBone, ofSkin));
  }
  return opacity.Get();
}

vtkSmartPointer<vtkColorTransferFunction> Colors(
  double bone, const VolumeLook& look, const std::array<double, 3>& color)
{
  vtkNew<vtkColorTransferFunction> colors;
  const double clear = bone - look.boneRamp;
  colors->AddRGBPoint(clear, color[0], color[1], color[2]);
  if (look.skin)
    colors->AddRGBPoint(std::min(*look.skin + SkinReach, clear - look.boneRamp), SkinColor[0],
      SkinColor[1], SkinColor[2]);
  return colors.Get();
}

} // namespace

VolumeLook UsualLook(const Passport& passport)
{
  VolumeLook look;
  look.window = { passport.minimum, passport.maximum };
  look.boneRamp = std::max((passport.maximum - passport.minimum) / 40.0, 1e-30);
  if (!passport.hounsfield)
    return look;
  look.skin = SkinHU;
  look.boneRamp = BoneRampHU;
  if (passport.maximum > BoneWindow[0] && passport.minimum < BoneWindow[1])
    look.window = { std::max(BoneWindow[0], passport.minimum),
      std::min(BoneWindow[1], passport.maximum) };
  return look;
}

std::string WindowText(const VolumeLook& look)
{
  char text[80];
  std::snprintf(text, sizeof text, "window %.6g to %.6g", look.window[0], look.window[1]);
  return text;
}

std::size_t VolumeBytes(vtkVolume* volume)
{
  vtkDataSet* image = volume->GetMapper()->GetDataSetInput();
  const vtkDataArray* samples = image->GetPointData()->GetScalars();
  return static_cast<std::size_t>(samples->GetNumberOfValues()) *
         static_cast<std::size_t>(samples->GetDataTypeSize());
}

std::string WhyTooLarge(vtkImageData* image, vtkRenderer* renderer)
{
  const int* size = image->GetDimensions();
  const int longest = *std::max_element(size, size + 3);
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
  if (limit <= 0 || longest <= limit)
    return {};
  return "the volume has " + std::to_string(longest) +
         " samples along one axis, and this OpenGL takes " + std::to_string(limit);
}

vtkSmartPointer<vtkVolume> MakeBrightest(vtkImageData* image, const std::array<double, 2>& window)
{
  const vtkSmartPointer<vtkVolume> volume = MakeVolume(image, BrightestStep);
  vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper())->SetBlendModeToMaximumIntensity();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(window[0], 0.0);
  opacity->AddPoint(window[1], 1.0);
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(white);
  volume->GetProperty()->ShadeOff();
  return volume;
}

vtkSmartPointer<vtkVolume> MakeTranslucent(
  vtkImageData* image, double bone, const VolumeLook& look, const std::array<double, 3>& color)
{
  const vtkSmartPointer<vtkVolume> volume = MakeVolume(image, TranslucentStep);
  const double* spacing = image->GetSpacing();
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetScalarOpacityUnitDistance(std::cbrt(spacing[0] * spacing[1] * spacing[2]));
  property->ShadeOn();
  property->SetAmbient(0.1);
  property->SetDiffuse(0.9);
  property->SetSpecular(0.2);
  property->SetSpecularPower(20.0);
  SetTranslucentBone(volume, bone, look, color);
  return volume;
}

void SetTranslucentBone(
  vtkVolume* volume, double bone, const VolumeLook& look, const std::array<double, 3>& color)
{
  volume->GetProperty()->SetScalarOpacity(Opacity(bone, look));
  volume->GetProperty()->SetColor(Colors(bone, look, color));
}

} // namespace hasp
