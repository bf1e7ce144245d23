#include "Studies/FractureCaseFile.h"

#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <set>
#include <stdexcept>

namespace hasp
{
namespace
{

void CheckCut(const FractureCaseCut& cut, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Closed("new_label", cut.newLabel, 1, MaxLabel);
  check.Closed("parent", cut.parent, 1, MaxLabel);
  for (std::size_t n = 0; n < cut.surfaces.size(); ++n)
  {
    const FractureCaseSurface& surface = cut.surfaces[n];
    check.Point(ListKey("surfaces", n, "point"), surface.point);
    check.Unit(ListKey("surfaces", n, "normal"), surface.normal);
    check.Closed(ListKey("surfaces", n, "rms_height_mm"), surface.rmsHeightMm, 0.0, 100.0);
    if (surface.sign != 1.0 && surface.sign != -1.0)
      check.Refuse(ListKey("surfaces", n, "sign"), surface.sign, "1 or -1");
    for (const glm::dvec2& band : surface.bandsMm)
    {
      check.AboveUpTo(ListKey("surfaces", n, "bands_mm"), band.x, 0.0, 1e4);
      check.Closed(ListKey("surfaces", n, "bands_mm"), band.y, 0.0, 1e4);
    }
  }
}

void CheckFragment(const FractureCaseFragment& fragment, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", fragment.name);
  const RigidPose& pose = fragment.anatomicalToFractured;
  for (int a = 0; a < 3; ++a) // may turn about a far point
    check.Closed("displacement_4x4", pose.position[a], -1e5, 1e5);
  if (const double length = glm::length(pose.orientation); !(std::abs(length - 1.0) <= 1e-9))
    check.Refuse("displacement's orientation's length", length, "1");
  check.Closed("volume_mm3", fragment.volumeMm3, 0.0, 1e9);
  check.Point("centroid_anatomical_mm", fragment.centroidAnatomicalMm);
  check.Closed("start_error_mm.mean", fragment.startMeanMm, 0.0, 1e5);
  check.Closed("start_error_mm.max", fragment.startMostMm, 0.0, 1e5);
}

} // namespace

RigidPose TrueReduction(const FractureCaseTruth& truth, Label label)
{
  for (const FractureCaseFragment& fragment : truth.fragments)
    if (fragment.label == label)
      return fragment.anatomicalToFractured.Inverse();
  for (const Label fixed : truth.fixed)
    if (fixed == label)
      return {};
  throw std::invalid_argument("fracture case: it has no label " + std::to_string(label));
}

void ValidateFractureCase(const FractureCaseTruth& truth)
{
  const ValueChecks check("fracture case");
  check.Text("case", truth.name);
  truth.geometry.Validate();
  std::set<Label> labels;
  const auto add = [&](Label label, const std::string& key)
  {
    check.Closed(key, label, 1, MaxLabel);
    if (!labels.insert(label).second)
      check.Refuse(key, label, "there once");
  };
  for (std::size_t n = 0; n < truth.fixed.size(); ++n)
    add(truth.fixed[n], ListKey("fixed_labels", n));
  for (std::size_t n = 0; n < truth.fragments.size(); ++n)
  {
    add(truth.fragments[n].label, ListKey("fragments", n, "label"));
    CheckFragment(truth.fragments[n], "fracture case: " + ListKey("fragments", n));
  }
  for (std::size_t n = 0; n < truth.cuts.size(); ++n)
    CheckCut(truth.cuts[n], "fracture case: " + ListKey("cuts", n));
  for (const FractureCaseLandmark& landmark : truth.landmarks)
  {
    check.Text("landmarks", landmark.name);
    check.Closed("landmarks.label", landmark.label, 1, MaxLabel);
    check.Point("landmarks.anatomical_mm", landmark.anatomicalMm);
    check.Point("landmarks.fractured_mm", landmark.fracturedMm);
  }
}

} // namespace hasp
