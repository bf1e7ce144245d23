#include "LitSurroundings.h"

#include "Grid/Stopwatch.h"
#include "Light/RadianceFile.h"
#include "Light/SkyModel.h"
#include "LitMeshes.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace
{

/// VTK's rows go from the bottom up, those of a map from the top down.
hasp::EnvironmentMap MapOf(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  int size[3];
  image->GetDimensions(size);
  if (!values || size[2] != 1 || values->GetNumberOfComponents() < 3 || size[0] > 16384 ||
      size[1] > 8192)
    throw std::invalid_argument(
      "the environment texture is no picture with red, green and blue of at most 16384 x 8192 "
      "pixels; give it one of latitude and longitude, from vtkHDRReader say");
  hasp::EnvironmentMap map;
  map.size = { size[0], size[1] };
  map.pixels.resize(static_cast<std::size_t>(values->GetNumberOfTuples()));
  const bool bytes = values->GetDataType() == VTK_UNSIGNED_CHAR;
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x)
      for (int c = 0; c < 3; ++c)
      {
        const double v =
          values->GetComponent(static_cast<vtkIdType>(size[1] - 1 - y) * size[0] + x, c);
        map.pixels[static_cast<std::size_t>(y) * size[0] + x][c] =
          bytes ? LinearOf(v / 255.0) : static_cast<float>(v);
      }
  return map;
}

/// By how much a map whose centre looks along `right` (VTK) is turned from one of ours, whose
/// centre looks along forward as Environment says.
double TurnOf(const glm::dvec3& up, const glm::dvec3& right)
{
  const glm::dvec3 z = glm::normalize(up);
  const glm::dvec3 near = std::abs(z.x) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 x = glm::normalize(near - z * glm::dot(near, z)), forward = glm::cross(z, x);
  return std::atan2(glm::dot(glm::cross(forward, right), z), glm::dot(forward, right));
}

std::shared_ptr<const hasp::Environment> MadeOf(
  vtkImageData* image, const std::string& fileName, const double* up, const double* right)
{
  const glm::dvec3 upwards = glm::make_vec3(up);
  const double turn = TurnOf(upwards, glm::make_vec3(right));
  return std::make_shared<const hasp::Environment>(!fileName.empty()
                                                     ? hasp::ReadRadianceFile(fileName)
                                                   : image ? MapOf(image)
                                                           : hasp::MakeSky({}),
    upwards, turn);
}

} // namespace

const std::shared_ptr<const hasp::Environment>& LitSurroundings::Of(
  vtkRenderer* renderer, const std::string& fileName)
{
  vtkTexture* texture = fileName.empty() ? renderer->GetEnvironmentTexture() : nullptr;
  if (texture)
    texture->Update();
  vtkImageData* image = texture ? texture->GetInput() : nullptr;
  Key key;
  key.fileName = fileName;
  key.image = image;
  key.time = image ? image->GetMTime() : 0;
  const double *up = renderer->GetEnvironmentUp(), *right = renderer->GetEnvironmentRight();
  key.axes = { up[0], up[1], up[2], right[0], right[1], right[2] };
  if (key == this->Last && this->Made)
    return this->Made;
  if (key == this->Last && !this->Fault.empty())
    throw std::runtime_error(this->Fault);
  const hasp::Stopwatch watch;
  this->Made = nullptr;
  this->Last = key;
  this->Fault.clear();
  try
  {
    this->Made = MadeOf(image, fileName, up, right);
  }
  catch (const std::exception& e)
  {
    this->Fault = e.what();
    throw;
  }
  this->Spent = watch.Milliseconds();
  return this->Made;
}

std::shared_ptr<const hasp::Environment> LitSurroundings::None()
{
  static const auto black =
    std::make_shared<const hasp::Environment>(hasp::Environment::Uniform(glm::vec3(0.0F)));
  return black;
}

std::vector<hasp::LitLamp> LampsOf(vtkRenderer* renderer, bool linear)
{
  std::vector<hasp::LitLamp> lamps;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator next;
  lights->InitTraversal(next);
  while (vtkLight* light = lights->GetNextLight(next))
  {
    double from[3], to[3];
    light->GetTransformedPosition(from);
    light->GetTransformedFocalPoint(to);
    const glm::dvec3 way = glm::make_vec3(from) - glm::make_vec3(to);
    const double length = glm::length(way);
    if (!light->GetSwitch() || (!light->GetPositional() && !(length > 0.0)))
      continue; // off, or it stands where it looks at, and lights nothing
    hasp::LitLamp lamp;
    const double* color = light->GetDiffuseColor();
    for (int c = 0; c < 3; ++c)
      lamp.color[c] = static_cast<float>(
        std::max(0.0, light->GetIntensity()) *
        (linear ? double(LinearOf(std::clamp(color[c], 0.0, 1.0))) : std::max(0.0, color[c])));
    lamp.shadow = std::clamp(light->GetShadowAttenuation(), 0.0F, 1.0F);
    if (light->GetPositional())
    {
      lamp.place = glm::dvec4(glm::make_vec3(from), 1.0);
      double factors[3];
      light->GetAttenuationValues(factors);
      lamp.attenuation = glm::vec3(factors[0], factors[1], factors[2]);
      if (light->GetConeAngle() < 90.0 && length > 0.0)
      {
        lamp.axis = -way / length;
        lamp.leastCosine = std::cos(glm::radians(light->GetConeAngle()));
        lamp.exponent = light->GetExponent();
      }
    }
    else
      lamp.place = glm::dvec4(way / length, 0.0);
    lamps.push_back(lamp);
  }
  return lamps;
}

float ExposureFor(const hasp::Environment& far, const std::vector<hasp::LitLamp>& lamps)
{
  constexpr double White = 0.55;
  double light = far.Total() / (4.0 * std::numbers::pi);
  for (const hasp::LitLamp& lamp : lamps)
    light += (lamp.color.r + lamp.color.g + lamp.color.b) / 3.0;
  return light > 0.0 ? static_cast<float>(White / light) : 1.0F;
}
