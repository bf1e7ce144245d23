#pragma once
#include "Planning/PlanEdits.h"
#include "RandomSegmentation.h"

#include <random>

/// Edits of all kinds that apply to a plan, the same for the same seed. Values are anywhere in
/// their ranges, texts from all of Unicode.
class RandomEdits
{
public:
  explicit RandomEdits(unsigned seed) : Random(seed) {}

  /// `newId` for an object that is added: at least the plan's nextId.
  hasp::PlanEdit Next(const hasp::Plan& plan, hasp::PlanId newId);
  /// What `edits` edits in a row make.
  hasp::Plan MakePlan(int edits);
  double Number(double low, double high);
  int Below(std::size_t count); ///< in [0, count)
  std::string Hash();

private:
  std::string Text();
  glm::dvec3 Point();
  glm::dvec3 Direction();
  hasp::PlanPose Pose();
  template <typename T>
  hasp::PlanId AnyOf(const std::vector<T>& objects);
  template <typename T>
  std::vector<hasp::PlanId> SomeOf(const std::vector<T>& objects);

  hasp::PlanVolume MakeVolume();
  hasp::PlanSegmentation MakeSegmentation(const hasp::Plan& plan);
  hasp::PlanEdit OfSegmentation(const hasp::PlanSegmentation& segmentation);
  hasp::FragmentSource ScanSource(const hasp::Plan& plan, hasp::PlanId id);
  hasp::PlanMirror MakeMirror(const hasp::Plan& plan);
  hasp::PlanFragment MakeFragment(const hasp::Plan& plan, hasp::PlanId id);
  hasp::PlanCut MakeCut(const hasp::Plan& plan);
  hasp::PlanGuide MakeGuide(const hasp::Plan& plan);
  hasp::PlanPlate MakePlate(const hasp::Plan& plan);
  hasp::PlanImplant MakeImplant(const hasp::Plan& plan);
  hasp::PlanTransplant MakeTransplant(const hasp::Plan& plan);
  hasp::PlanMitreGuide MakeMitreGuide(const hasp::Plan& plan);
  hasp::PlanMeasure MakeMeasure(const hasp::Plan& plan);
  template <typename T, typename Make>
  hasp::PlanEdit AddOrChange(const std::vector<T>& objects, hasp::PlanId newId, Make make);
  hasp::PlanEdit OfFragments(const hasp::Plan& plan);

  std::mt19937 Random;
};
