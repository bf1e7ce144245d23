#include "vtkHaspSignedDistance.h"

#include "Distance/ChamferDistance.h"
#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Distance/ScanMargin.h"
#include "Distance/SurfaceElements.h"
#include "ImageOutput.h"
#include "vtkHaspFilterRun.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkHaspSignedDistance);

namespace
{

using Self = vtkHaspSignedDistance;
using Samples = hasp::GridView<const float>;

constexpr double BandVoxels = 4.0; // of CoverageDistanceBand

/// What the samples are, now that it has been measured where that was asked for.
struct Input
{
  const hasp::AnyGridView& grid;
  const hasp::GridGeometry& geometry;
  int kind;
  double isovalue;
  int label;

  /// One byte a sample: is it inside? Not of coverage.
  std::vector<std::uint8_t> Mask() const
  {
    if (this->kind == Self::Labels)
      return hasp::KeepLabel(this->grid, this->label);
    std::vector<std::uint8_t> mask(this->geometry.Size());
    std::visit(
      [&](const auto& view)
      {
        std::transform(view.data, view.data + mask.size(), mask.begin(),
          [this](auto sample) { return double(sample) >= this->isovalue ? 1 : 0; });
      },
      this->grid);
    return mask;
  }
  std::span<const float> Shares() const
  {
    const auto* shares = std::get_if<Samples>(&this->grid);
    const std::size_t voxels = this->geometry.Size();
    const auto isShare = [](float v) { return v >= 0.0F && v <= 1.0F; };
    if (!shares || !std::all_of(shares->data, shares->data + voxels, isShare))
      throw std::invalid_argument(
        std::string("samples are not ") + (shares ? "in [0, 1]" : "of type float") +
        ", so they are no coverage: SetInputKindToGrey and SetIsoValue, or SetInputKindToLabels");
    return { shares->data, voxels };
  }
};

/// The same with a margin: what has labels is coverage then.
struct Enlarged
{
  Enlarged(const Input& input, double mm) : Geometry(hasp::GeometryWithMargin(input.geometry, mm))
  {
    if (input.kind == Self::Grey)
      this->Values = hasp::GreyWithMargin(input.grid, input.isovalue, mm);
    else if (input.kind == Self::Coverage)
      this->Values = hasp::CoverageWithMargin(input.geometry, input.Shares(), mm);
    else
    {
      const std::vector<std::uint8_t> mask = input.Mask();
      this->Values =
        hasp::CoverageWithMargin(input.geometry, std::vector<float>(mask.begin(), mask.end()), mm);
    }
    this->Kind = input.kind == Self::Grey ? Self::Grey : Self::Coverage;
    this->Grid = Samples{ this->Values.data(), this->Geometry };
  }
  Input Get() const { return { this->Grid, this->Geometry, this->Kind, 0.0, 1 }; }

private:
  hasp::GridGeometry Geometry;
  std::vector<float> Values;
  hasp::AnyGridView Grid;
  int Kind;
};

Input Resolve(Input input)
{
  if (input.kind != Self::Automatic)
    return input;
  input.isovalue = 0.5;
  input.kind =
    hasp::MeasureEdges(input.geometry, input.Shares()).Coverage() ? Self::Coverage : Self::Grey;
  return input;
}

std::vector<float> AntiAliasedDistance(
  const Input& input, bool band, const hasp::ProgressFunction& progress)
{
  if (input.kind == Self::Grey)
    return hasp::GreyDistance(input.grid, input.isovalue, progress);
  const auto transform = band ? hasp::CoverageDistanceBand : hasp::CoverageDistance;
  if (input.kind == Self::Coverage)
    return transform(input.geometry, input.Shares(), progress);
  const std::vector<std::uint8_t> mask = input.Mask();
  return transform(input.geometry, std::vector<float>(mask.begin(), mask.end()), progress);
}

std::vector<float> OtherDistance(
  const Input& input, int transform, const hasp::ProgressFunction& progress)
{
  std::vector<float> shares;
  if (input.kind == Self::Coverage)
    shares.assign(input.Shares().begin(), input.Shares().end());
  else
  {
    const std::vector<std::uint8_t> mask = input.Mask();
    if (transform == Self::Euclidean)
      return hasp::SignedEuclideanDistance(input.geometry, mask, progress);
    shares.assign(mask.begin(), mask.end());
  }
  if (transform == Self::Chamfer)
    return hasp::ChamferDistance(input.geometry, shares, progress);
  std::vector<std::uint8_t> mask(shares.size());
  std::transform(
    shares.begin(), shares.end(), mask.begin(), [](float share) { return share >= 0.5F; });
  return hasp::SignedEuclideanDistance(input.geometry, mask, progress);
}

struct Settings
{
  int transform;
  bool band;
};

void Transform(const Input& input, const Settings& settings, vtkImageData* output,
  const hasp::ProgressFunction& progress)
{
  std::vector<float> distance = settings.transform == Self::AntiAliased
                                  ? AntiAliasedDistance(input, settings.band, progress)
                                  : OtherDistance(input, settings.transform, progress);
  if (settings.band)
  {
    const glm::dvec3& spacing = input.geometry.spacing;
    const auto most = float(BandVoxels * std::min({ spacing.x, spacing.y, spacing.z }));
    for (float& value : distance)
      value = std::clamp(value, -most, most);
  }
  hasp::GiveImage(output, input.geometry, distance, "SignedDistance");
}

} // namespace

int vtkHaspSignedDistance::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction&)
    {
      hasp::SayImage(outputs->GetInformationObject(0),
        hasp::GeometryWithMargin(
          hasp::PipelineGeometry(inputs[0]->GetInformationObject(0)), this->Margin));
    });
}

int vtkHaspSignedDistance::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  hasp::AskForAll(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkHaspSignedDistance::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  return hasp::RunFilter(this, this->ErrorCode,
    [&](const hasp::ProgressFunction& progress)
    {
      const hasp::AnyGridView grid = hasp::ViewImage(vtkImageData::GetData(inputs[0]));
      const Input input =
        Resolve({ grid, hasp::GeometryOf(grid), this->InputKind, this->IsoValue, this->Label });
      const Settings settings{ this->Transform, this->NarrowBand };
      if (this->Margin == 0.0)
        ::Transform(input, settings, output, progress);
      else
        ::Transform(Enlarged(input, this->Margin).Get(), settings, output, progress);
    });
}

void vtkHaspSignedDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  static constexpr const char* Kinds[] = { "automatic", "coverage", "grey", "labels" };
  static constexpr const char* Names[] = { "anti-aliased", "Euclidean", "chamfer" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InputKind: " << Kinds[this->InputKind] << "\n"
     << indent << "IsoValue: " << this->IsoValue << "\n"
     << indent << "Label: " << this->Label << "\n"
     << indent << "Transform: " << Names[this->Transform] << "\n"
     << indent << "NarrowBand: " << (this->NarrowBand ? "on" : "off") << "\n"
     << indent << "Margin: " << this->Margin << "\n";
}
