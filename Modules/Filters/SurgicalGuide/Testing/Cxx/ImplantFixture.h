#pragma once
#include "Evaluation/MeshCheck.h"
#include "Evaluation/SurfaceDistance.h"
#include "Grid/Phantom.h"
#include "ImplantBuilder.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

/// The phantom's vault with its hole, and recipes for it.
namespace implanttest
{

/// Bone is one value, and its isosurface half way to it: so it is where the closed form has it.
constexpr double HalfWayHU = 520.0;

struct Scan
{
  hasp::PhantomSettings settings;
  hasp::GridGeometry grid;
  std::vector<std::int16_t> samples;

  /// All above `bottomMm`, sampled as if the head were turned.
  explicit Scan(double spacingMm, double bottomMm = -10.0, double noiseHU = 0.0)
  {
    this->settings.diploeHU = this->settings.boneHU;
    this->settings.noiseHU = noiseHU;
    this->settings.blurMm = glm::dvec3(0.4); // so that voxels see where in them a surface lies
    this->grid = hasp::PhantomGrid(glm::dvec3(spacingMm), this->settings);
    const int below = std::max(int((bottomMm - this->grid.origin.z) / spacingMm), 0);
    this->grid.origin.z += below * spacingMm;
    this->grid.dims.z -= below;
    this->samples = hasp::SamplePhantom(this->grid, this->settings);
  }
  hasp::AnyGridView View() const
  {
    return hasp::GridView<const std::int16_t>{ this->samples.data(), this->grid };
  }
  hasp::PhantomDefect Hole() const { return hasp::DefectOf(this->settings); }
  /// The vault's outer table without the hole, as a solid that is filled below it.
  hasp::AnalyticSolid Outer() const
  {
    return hasp::EllipsoidShape{ this->settings.center,
      this->settings.skinRadii - this->settings.scalpMm };
  }
};

/// On the outer table: some of the hole's half length and half width from its middle.
inline glm::dvec3 OnTable(const Scan& scan, double along, double across)
{
  const hasp::PhantomDefect hole = scan.Hole();
  const glm::dvec3 p = hole.center + along * hole.along + across * hole.across;
  return hasp::PhantomOuterTable(scan.settings, p - scan.settings.center);
}

/// Twelve places on the outer table around the hole, 6 mm and more outside it.
inline hasp::ImplantRecipe AroundTheHole(const Scan& scan)
{
  const hasp::PhantomDefect hole = scan.Hole();
  hasp::ImplantRecipe r;
  r.isovalue = HalfWayHU;
  for (int n = 0; n < 12; ++n)
  {
    const double angle = n * 6.283185307179586 / 12;
    r.outline.push_back(OnTable(scan, (0.5 * hole.lengthMm + 6.0) * 1.2 * std::cos(angle),
      (0.5 * hole.widthMm + 6.0) * 1.2 * std::sin(angle)));
  }
  r.axis = hole.outward;
  r.thicknessMm = 5.0;
  r.spacingMm = 0.6;
  r.mirror = hasp::MirrorPlane{};
  return r;
}

/// What BuildImplant says, or "".
inline std::string FaultOf(const Scan& scan, const hasp::ImplantRecipe& recipe)
{
  try
  {
    hasp::BuildImplant(scan.View(), recipe);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

} // namespace implanttest
