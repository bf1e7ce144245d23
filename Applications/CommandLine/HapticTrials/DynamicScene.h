#pragma once
#include "Haptics/DynamicPointShell.h"
#include "TrialBody.h"

namespace hasp
{

struct ReportContext;

/// A body that touches one like itself, by a shell that follows contact; and a static shell so fine
/// that it counts as the truth.
struct DynamicScene
{
  TrialBody body{ 128, { 44.8, 2.56, 6.0 } };
  ShellVolume volume;
  std::shared_ptr<const PointShell> truth;

  explicit DynamicScene(int pointsOfTruth);
  Wrench Feel(const RigidPose& pose, const ContactPoints& points) const;
  Wrench Feel(const RigidPose& pose, const PointShell& shell) const;
  /// Along `way`, just touching, then pressed in by `deep`, mm.
  RigidPose Touching(
    const glm::dvec3& way, const glm::dquat& turn, const PointShell& shell, double deep) const;
};

/// haptics.dynamic.error: dynamic against static shells of as many points, over rough poses.
void AddDynamicErrors(ReportContext& context, const DynamicScene& scene);

} // namespace hasp
