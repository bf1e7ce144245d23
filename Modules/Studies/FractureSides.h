#pragma once
#include "Grid/PhantomScene.h"
#include "Studies/SyntheticFracture.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// What part of a ball of the intact world a fragment may hold: everything that decides there.
struct NearSides
{
  bool none = true; ///< the fragment holds nothing of the ball
  bool all = false; ///< it holds all of it, and no face is near
  std::uint32_t fragment = 0;
  /// Faces that are near, of the piece itself (if it is one), of chips and of pieces before it.
  struct Faces
  {
    std::vector<std::uint32_t> faces; ///< numbers of rough planes; the largest decides
    bool inside;                      ///< the piece's own: behind them; else outside them
  };
  std::vector<Faces> pieces;
  std::vector<std::uint32_t> bones;  ///< that may be the nearest in the ball; empty: its own alone
  std::vector<AnalyticSolid> solids; ///< theirs, as the ball sees them
};

/// Who holds what of intact bone. Fragments are numbered: bones first, then pieces. Immutable; any
/// thread.
class FractureSides
{
public:
  explicit FractureSides(const FractureSettings& settings);

  std::uint32_t Fragments() const;
  /// The pose that brings the fragment from the intact world to the broken one.
  const RigidPose& PoseOf(std::uint32_t fragment) const;
  NearSides Near(std::uint32_t fragment, const glm::dvec3& center, double radiusMm) const;

  /// The share of a place, in [0,1], that the scanner sees of the fragment.
  /// sides   of a ball that holds the point
  double Share(const NearSides& sides, const glm::dvec3& point) const;

private:
  void AddFaces(std::size_t bone, const std::vector<FractureFace>& faces);
  struct Side
  {
    double mm; ///< NEGATIVE INSIDE the fragment, behind what its face has lost
    glm::dvec3 outward;
  };
  Side FaceSide(std::uint32_t face, const glm::dvec3& point) const;
  Side PieceSide(const NearSides::Faces& faces, const glm::dvec3& point) const;
  /// Further from the plane than this nothing is within ReachMm of its heights.
  double FarMm(std::uint32_t face) const;
  double HalfGapMm(std::uint32_t face, const glm::dvec3& point) const;
  bool Holds(const NearSides& sides, const glm::dvec3& point) const;
  void AddBones(
    std::uint32_t bone, const glm::dvec3& center, double radiusMm, NearSides& near) const;

  FractureSettings Settings;
  SurfaceStep Step;
  double ReachMm; ///< further from its faces a fragment is as if it had none
  std::vector<RoughPlane> Planes, Losses;
  std::vector<std::vector<std::uint32_t>> FacesOf; ///< of each chip, then of each piece
  std::vector<std::size_t> BoneOf;                 ///< likewise
};

} // namespace hasp
