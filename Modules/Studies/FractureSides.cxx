#include "Studies/FractureSides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace hasp
{

FractureSides::FractureSides(const FractureSettings& settings)
  : Settings(settings),
    Step(settings.scanner),
    ReachMm(0.5 * settings.crackMm + settings.erodedMm + Step.reachMm)
{
  for (const FractureChip& chip : settings.chips)
    this->AddFaces(chip.bone, chip.faces);
  for (const FracturePiece& piece : settings.pieces)
    this->AddFaces(piece.bone, piece.faces);
}

void FractureSides::AddFaces(std::size_t bone, const std::vector<FractureFace>& faces)
{
  this->FacesOf.emplace_back();
  this->BoneOf.push_back(bone);
  for (FractureFace face : faces)
  {
    this->FacesOf.back().push_back(static_cast<std::uint32_t>(this->Planes.size()));
    this->Planes.emplace_back(face);
    face.seed += 0x10000; // what is lost has heights of its own: 1 rms is about the most
    face.roughMm = 1.0;
    this->Losses.emplace_back(face);
  }
}

std::uint32_t FractureSides::Fragments() const
{
  return static_cast<std::uint32_t>(this->Settings.bones.size() + this->Settings.pieces.size());
}

const RigidPose& FractureSides::PoseOf(std::uint32_t fragment) const
{
  static const RigidPose unmoved;
  const std::size_t bones = this->Settings.bones.size();
  return fragment < bones ? unmoved : this->Settings.pieces[fragment - bones].moved;
}

void FractureSides::AddBones(
  std::uint32_t bone, const glm::dvec3& center, double radiusMm, NearSides& near) const
{
  const std::vector<FractureBone>& bones = this->Settings.bones;
  if (bones.size() == 1)
    return;
  std::vector<double> bounds;
  for (const FractureBone& other : bones)
    bounds.push_back(other.solid->Bound(center).mm);
  const double least = *std::min_element(bounds.begin(), bounds.end());
  std::vector<std::uint32_t> nearest;
  for (std::uint32_t n = 0; n < bounds.size(); ++n)
    if (bounds[n] <= least + 2.0 * radiusMm) // each changes by at most the radius
      nearest.push_back(n);
  if (std::find(nearest.begin(), nearest.end(), bone) == nearest.end())
    near.none = true;
  else if (nearest.size() > 1)
  {
    near.all = false;
    near.bones = std::move(nearest);
    for (const std::uint32_t n : near.bones)
      near.solids.push_back(bones[n].solid->Near(center, radiusMm));
  }
}

NearSides FractureSides::Near(
  std::uint32_t fragment, const glm::dvec3& center, double radiusMm) const
{
  const std::size_t bones = this->Settings.bones.size();
  const bool isPiece = fragment >= bones;
  const std::size_t own =
    isPiece ? this->Settings.chips.size() + fragment - bones : this->FacesOf.size();
  const std::size_t bone = isPiece ? this->BoneOf[own] : fragment;
  NearSides near;
  near.fragment = fragment;
  for (std::size_t piece = 0; piece < this->FacesOf.size() && piece <= own; ++piece)
  {
    if (this->BoneOf[piece] != bone)
      continue;
    NearSides::Faces faces{ {}, piece == own };
    bool outside = false;
    for (const std::uint32_t face : this->FacesOf[piece])
    {
      const double mm = this->Planes[face].PlaneMm(center), far = this->FarMm(face) + radiusMm;
      outside = outside || mm > far;
      if (mm >= -far)
        faces.faces.push_back(face);
    }
    const bool within = !outside && faces.faces.empty();
    if (faces.inside ? outside : within)
      return near;
    if (!outside && !within)
      near.pieces.push_back(std::move(faces));
  }
  near.none = false;
  near.all = near.pieces.empty();
  this->AddBones(static_cast<std::uint32_t>(bone), center, radiusMm, near);
  return near;
}

double FractureSides::HalfGapMm(std::uint32_t face, const glm::dvec3& point) const
{
  const double lost =
    this->Settings.erodedMm == 0.0
      ? 0.0
      : this->Settings.erodedMm * std::clamp(this->Losses[face].HeightMm(point), 0.0, 1.0);
  return 0.5 * this->Settings.crackMm + lost;
}

double FractureSides::FarMm(std::uint32_t face) const
{
  const RoughPlane& plane = this->Planes[face];
  return plane.MostMm() + this->ReachMm * plane.Steepest();
}

FractureSides::Side FractureSides::PieceSide(
  const NearSides::Faces& faces, const glm::dvec3& point) const
{
  const Side outside{ faces.inside ? this->ReachMm : -this->ReachMm, { 0.0, 0.0, 1.0 } };
  // Most faces are far from most points: planes alone say so, and the highest one most often.
  std::size_t highest = 0;
  double highestMm = -std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < faces.faces.size(); ++n)
  {
    const double mm = this->Planes[faces.faces[n]].PlaneMm(point);
    if (mm > this->FarMm(faces.faces[n]))
      return outside;
    if (mm > highestMm)
    {
      highestMm = mm;
      highest = n;
    }
  }
  RoughPlane::Foot deepest{ -this->ReachMm, { 0.0, 0.0, 1.0 } };
  std::optional<std::uint32_t> decides;
  for (std::size_t n = 0; n < faces.faces.size(); ++n)
  {
    const std::uint32_t face = faces.faces[n == 0 ? highest : n == highest ? 0 : n];
    if (this->Planes[face].PlaneMm(point) < -this->FarMm(face))
      continue;
    const RoughPlane::Foot foot = this->Planes[face].FootOf(point);
    if (foot.mm >= this->ReachMm)
      return outside;
    if (foot.mm > deepest.mm)
    {
      deepest = foot;
      decides = face;
    }
  }
  const double gap = decides ? this->HalfGapMm(*decides, point) : 0.0;
  return faces.inside ? Side{ deepest.mm + gap, deepest.outward }
                      : Side{ -deepest.mm + gap, -deepest.outward };
}

bool FractureSides::Holds(const NearSides& sides, const glm::dvec3& point) const
{
  if (sides.bones.empty())
    return true;
  const std::size_t bones = this->Settings.bones.size();
  const std::size_t bone =
    sides.fragment < bones ? sides.fragment : this->Settings.pieces[sides.fragment - bones].bone;
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < sides.bones.size(); ++n)
  {
    const double mm = sides.solids[n].Bound(point).mm;
    if (mm < least)
    {
      least = mm;
      nearest = sides.bones[n];
    }
  }
  return nearest == bone;
}

double FractureSides::Share(const NearSides& sides, const glm::dvec3& point) const
{
  if (sides.none || !this->Holds(sides, point))
    return 0.0;
  if (sides.pieces.empty())
    return 1.0;
  Side outermost{ -this->ReachMm, { 0.0, 0.0, 1.0 } };
  for (auto faces = sides.pieces.rbegin(); faces != sides.pieces.rend(); ++faces) // its own first
  {
    const Side side = this->PieceSide(*faces, point);
    if (side.mm >= this->ReachMm) // nothing is seen of it, whatever the others say
      return 0.0;
    if (side.mm > outermost.mm)
      outermost = side;
  }
  return this->Step(-outermost.mm, outermost.outward);
}

} // namespace hasp
