#include "Haptics/PointProxy.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

void Require(bool good, const char* name, double value)
{
  if (!good || !std::isfinite(value))
    throw std::invalid_argument(
      std::string(name) + " of a point proxy is " + std::to_string(value) + ", which cannot be");
}

bool IsFinite(const glm::dvec3& v) noexcept
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

PointProxy::PointProxy(const PointProxySettings& settings) : Settings(settings)
{
  Require(settings.stiffness > 0.0, "The stiffness", settings.stiffness);
  Require(settings.forceLimit > 0.0, "The force limit", settings.forceLimit);
  Require(settings.radiusMm >= 0.0, "The radius", settings.radiusMm);
  Require(settings.friction >= 0.0, "The friction", settings.friction);
  Require(settings.stepMm > 0.0, "The step", settings.stepMm);
  Require(settings.steps > 0, "The number of steps", settings.steps);
}

/// One tick's steps.
class PointProxy::Walk
{
public:
  Walk(const PointProxySettings& settings, const glm::dvec3& device, const ImplicitField& field,
    glm::dvec3& at)
    : Settings(settings),
      Device(device),
      Field(field),
      At(at),
      ToleranceMm(1e-4 * settings.stepMm)
  {
  }

  ProxyTick Run() noexcept
  {
    ProxyTick tick;
    Near here = this->Look(this->At);
    for (int step = 0; step < this->Settings.steps && !tick.settled; ++step)
    {
      if (std::isnan(here.distance))
        break;
      if (here.distance < -this->ToleranceMm)
        here = this->Out(here);
      else
      {
        this->Forget();
        if (here.distance <= this->ToleranceMm)
          this->Touch(this->At, here.normal);
        tick.settled = !this->Step(here);
      }
    }
    tick.proxy = this->At;
    tick.touches = this->Count > 0;
    tick.normal = this->Count > 0 ? this->Normals[this->Count - 1] : glm::dvec3(0.0);
    tick.samples = this->Samples;
    return tick;
  }

private:
  Near Look(const glm::dvec3& at) noexcept
  {
    ++this->Samples;
    const ImplicitField::Sample sample = this->Field.At(at);
    const double slope = glm::length(sample.gradient);
    // Without a slope nobody knows how far it is: outside a step at a time, inside not at all.
    if (slope == 0.0)
      return { sample.value > 0.0 ? 2.0 * this->ToleranceMm : Unknown, glm::dvec3(0.0) };
    return { sample.value / slope - this->Settings.radiusMm, sample.gradient / slope };
  }

  /// Inside, where the surface has moved: towards it, by the shortest way.
  Near Out(const Near& here) noexcept
  {
    this->At += std::min(-here.distance, this->Settings.stepMm * 4.0) * here.normal;
    return this->Look(this->At);
  }

  /// Planes that the proxy has left, as one leaves a ball's tangent planes, hold no more.
  void Forget() noexcept
  {
    int kept = 0;
    for (int i = 0; i < this->Count; ++i)
      if (glm::length(this->At - this->Ats[i]) <= this->Settings.stepMm)
      {
        this->Ats[kept] = this->Ats[i];
        this->Normals[kept++] = this->Normals[i];
      }
    this->Count = kept;
  }

  /// One more plane; in place of one that says the same.
  void Touch(const glm::dvec3& at, const glm::dvec3& normal) noexcept
  {
    int place = this->Count;
    for (int i = 0; i < this->Count; ++i)
      if (glm::dot(this->Normals[i], normal) > 0.99)
        place = i;
    if (place == 3)
      place = 0; // the oldest
    this->Ats[place] = at;
    this->Normals[place] = normal;
    this->Count = std::max(this->Count, place + 1);
  }

  /// Towards where the device drags it. False if it rests there.
  bool Step(Near& here) noexcept
  {
    glm::dvec3 way =
      NearestAbove(this->Device, this->Ats.data(), this->Normals.data(), this->Count) - this->At;
    const double whole = glm::length(way);
    if (this->Count > 0)
      way *= this->Slips(way, whole);
    const double length = glm::length(way);
    if (!(length > this->ToleranceMm))
      return false;
    const double longest = this->Settings.stepMm + std::max(0.0, here.distance);
    const glm::dvec3 step = way * std::min(1.0, longest / length);
    const Near there = this->Look(this->At + step);
    if (!(there.distance < -this->ToleranceMm))
    {
      this->At += step;
      here = there;
      return true;
    }
    // On a surface that bends up a step ends a little inside, and is brought back; before another
    // face it stops, and from now on that one is a plane as well.
    if (here.distance <= this->ToleranceMm && glm::dot(here.normal, there.normal) > 0.9)
    {
      const glm::dvec3 back = this->At + step - there.distance * there.normal;
      if (glm::length(back - this->At) > 0.1 * glm::length(step))
      {
        this->At = back;
        here = this->Look(back);
        return true;
      }
      return false;
    }
    here = this->StopBefore(step);
    this->Touch(this->At, here.normal);
    return true;
  }

  /// The share of a way along planes that dry friction leaves.
  double Slips(const glm::dvec3& way, double length) const noexcept
  {
    const double pressed = glm::length(this->At + way - this->Device);
    const double free = length - this->Settings.friction * pressed;
    return length > 0.0 ? std::clamp(free / length, 0.0, 1.0) : 0.0;
  }

  /// As far along `step` as is free, by bisection; there the field tells the face that was met.
  Near StopBefore(const glm::dvec3& step) noexcept
  {
    double low = 0.0, high = 1.0;
    Near met = this->Look(this->At + step);
    for (int i = 0; i < 20; ++i)
    {
      const double middle = 0.5 * (low + high);
      const Near there = this->Look(this->At + middle * step);
      if (there.distance < -0.5 * this->ToleranceMm)
      {
        high = middle;
        met = there;
      }
      else
        low = middle;
    }
    this->At += low * step;
    return { 0.0, met.normal };
  }

  const PointProxySettings& Settings;
  const glm::dvec3& Device;
  const ImplicitField& Field;
  glm::dvec3& At;
  const double ToleranceMm;
  std::array<glm::dvec3, 3> Ats{}, Normals{};
  int Count = 0, Samples = 0;
};

ProxyTick PointProxy::Tick(const glm::dvec3& device, const ImplicitField& field) noexcept
{
  if (!IsFinite(device))
    return { glm::dvec3(0.0), this->At, glm::dvec3(0.0), false, false, 0 };
  const glm::dvec3 before = this->At;
  ProxyTick tick = Walk(this->Settings, device, field, this->At).Run();
  if (!IsFinite(this->At)) // a field that is not
  {
    this->At = before;
    return { glm::dvec3(0.0), before, glm::dvec3(0.0), false, false, tick.samples };
  }
  const glm::dvec3 drawn = this->At - device;
  const double length = glm::length(drawn);
  if (length > 0.0)
    tick.onDevice =
      drawn * (this->Settings.forceLimit / length *
                std::tanh(this->Settings.stiffness * length / this->Settings.forceLimit));
  return tick;
}

} // namespace hasp
