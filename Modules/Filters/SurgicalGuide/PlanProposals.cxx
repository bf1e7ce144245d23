#include "PlanProposals.h"

#include "DonorAxis.h"
#include "FragmentPieces.h"
#include "PlanBones.h"

#include "Grid/ProgressPart.h"
#include "Planning/PlanLists.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
constexpr double IgnoreBelowMm3 = 100.0; ///< CutRecipe's default

std::string BeforeFault(PlanId fragment)
{
  return "fragment " + std::to_string(fragment) + ": ";
}

const PlanFragment& Asked(const Plan& plan, PlanId fragment)
{
  const PlanFragment* found = FindPlanObject<PlanFragment>(plan, fragment);
  if (!found || !IsOfScan(plan, fragment))
    throw std::invalid_argument(
      BeforeFault(fragment) + (found ? "it is a surface, and cannot be cut" : "there is none"));
  return *found;
}

/// The point of a mesh that lies farthest from all planes.
glm::dvec3 FarthestFrom(const std::vector<Osteotomy>& blades, const TriangleMesh& mesh)
{
  glm::dvec3 farthest(0.0);
  double most = -1.0;
  for (const glm::dvec3& point : mesh.points)
  {
    double nearest = 1e30;
    for (const Osteotomy& blade : blades)
      nearest =
        std::min(nearest, std::abs(glm::dot(point - blade.point, glm::normalize(blade.normal))));
    if (nearest > most)
      most = nearest, farthest = point;
  }
  return farthest;
}

std::vector<MeshRays> RaysOf(const CutBone& bone)
{
  std::vector<MeshRays> rays;
  for (const BoneFragment& fragment : bone.fragments)
    rays.emplace_back(fragment.mesh);
  return rays;
}

/// Which of all pieces of the whole bone lie in a piece: those that the cuts before left there.
class WithinPiece
{
public:
  WithinPiece(PlanBones& bones, const PlanFragment& divided, const ProgressFunction& progress)
  {
    const auto* piece = std::get_if<PieceSource>(&divided.source);
    if (!piece)
      return;
    this->Before = &bones.Divide(piece->fragment, progress);
    this->Rays = RaysOf(*this->Before);
    this->Wanted = this->At(piece->seed);
  }
  bool operator()(const glm::dvec3& place) const
  {
    return !this->Before || this->At(place) == this->Wanted;
  }

private:
  std::size_t At(const glm::dvec3& place) const
  {
    return NearestFragment(this->Before->fragments, this->Rays, place).first;
  }
  const CutBone* Before = nullptr; ///< null: the whole bone is asked for
  std::vector<MeshRays> Rays;
  std::size_t Wanted = 0;
};
} // namespace

ProposedPieces ProposePieces(
  const Plan& plan, const PlanImages& images, PlanId divided, const ProgressFunction& progress)
{
  const PlanFragment& fragment = Asked(plan, divided);
  const std::vector<PlanId> cuts = CutsThrough(plan, divided);
  if (cuts.empty())
    throw std::invalid_argument(BeforeFault(divided) + "no cut goes through it");
  std::vector<Osteotomy> blades;
  for (const PlanId id : cuts)
    blades.push_back(FindPlanObject<PlanCut>(plan, id)->blade);
  PlanBones bones(plan, images);
  const WithinPiece within(bones, fragment, PartOf(progress, 0.0, 0.5));
  const CutBone& bone = bones.Divide(divided, PartOf(progress, 0.5, 1.0));
  const std::vector<MeshRays> rays = RaysOf(bone);
  std::vector<PlanId> taken(bone.fragments.size(), 0);
  for (const PlanFragment& other : plan.fragments)
    if (const auto* piece = std::get_if<PieceSource>(&other.source);
        piece && piece->fragment == divided)
      if (const auto [n, away] = NearestFragment(bone.fragments, rays, piece->seed);
          away <= FarthestSeedMm && taken[n] == 0)
        taken[n] = other.id;
  ProposedPieces proposed;
  for (std::size_t n = 0; n < bone.fragments.size(); ++n)
  {
    const glm::dvec3 seed = FarthestFrom(blades, bone.fragments[n].mesh);
    if (within(seed))
      proposed.pieces.push_back(
        { seed, bone.fragments[n].volumeMm3, bone.fragments[n].crumb, taken[n] });
  }
  proposed.cuts = bones.CutsOf(divided);
  return proposed;
}

std::vector<glm::dvec3> ProposeDonorAxis(const Plan& plan, const PlanImages& images, PlanId donor,
  const std::array<glm::dvec3, 2>& tips, double radiusMm, const ProgressFunction& progress)
{
  Asked(plan, donor);
  PlanBones bones(plan, images);
  const BoneLabels labels = bones.Labels({ &donor, 1 }, PartOf(progress, 0.0, 0.5));
  return SayingErrors(
    [&]
    {
      return FindDonorAxis({ labels.grey, labels.View(), 1 }, bones.Isovalue(donor), IgnoreBelowMm3,
        tips[0], tips[1], radiusMm, PartOf(progress, 0.5, 1.0));
    },
    [&](const std::string& text) { return BeforeFault(donor) + text; });
}

} // namespace hasp
