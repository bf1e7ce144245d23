#pragma once
#include "FragmentCutter.h"
#include "PlanRebuild.h"
#include "Planning/Plan.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace hasp
{

/// Samples of a volume, each with the number of its bone, 0 for none.
struct BoneLabels
{
  AnyGridView grey; ///< whose samples
  std::vector<std::uint16_t> numbers;

  AnyGridView View() const
  {
    return GridView<const std::uint16_t>{ numbers.data(), GeometryOf(grey) };
  }
};

/// The fragments of a plan as meshes and as voxels, each made once. One thread at a time.
class PlanBones
{
public:
  PlanBones(const Plan& plan, const PlanImages& images); ///< keeps references

  /// In the scan. Errors begin with "fragment ID: ".
  const TriangleMesh& Mesh(PlanId fragment, const ProgressFunction& progress);
  /// What the cuts through the fragment that this one is a piece of did; none if it is no piece.
  std::vector<PlanCutMeasure> Cuts(PlanId fragment);
  /// fragments[n] is n + 1. They must be of one volume.
  BoneLabels Labels(std::span<const PlanId> fragments, const ProgressFunction& progress);
  double Isovalue(PlanId fragment) const;
  double SpacingMm(PlanId fragment) const;
  const AnyGridView& Grey(PlanId volume) const;

private:
  struct Pieces
  {
    std::vector<PlanId> cuts; ///< in the order in which they are made
    CutBone bone;
    std::vector<std::uint16_t> numbers; ///< of the pieces by samples; empty until asked for
  };
  const PlanFragment& Fragment(PlanId id) const;
  const PlanFragment& Root(PlanId id) const;
  PlanId VolumeOf(const PlanFragment& root) const;
  const std::vector<std::uint8_t>& Mark(const PlanFragment& root);
  Pieces& PiecesOf(PlanId divided, const ProgressFunction& progress);
  std::size_t PieceAt(const Pieces& pieces, const PlanFragment& piece) const;
  void Number(Pieces& pieces, const PlanFragment& root);

  const Plan& Of;
  const PlanImages& Images;
  std::map<PlanId, std::vector<std::uint8_t>> Marks;
  std::map<PlanId, Pieces> Divided;
  std::map<PlanId, TriangleMesh> Whole;
};

} // namespace hasp
