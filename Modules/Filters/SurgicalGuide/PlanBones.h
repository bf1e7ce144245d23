#pragma once
#include "FragmentCutter.h"
#include "PlanRebuild.h"
#include "Planning/Plan.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
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

/// What the work returns; what it throws, but for Cancelled, with the text that `say` makes of its
/// own.
template <typename Work, typename Say>
decltype(auto) SayingErrors(const Work& work, const Say& say)
{
  try
  {
    return work();
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(say(error.what()));
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(say(error.what()));
  }
}

/// The fragments of a plan as meshes and as voxels, each made once. One thread at a time. Errors
/// begin with the fragment: "fragment 5: source.seed …".
class PlanBones
{
public:
  PlanBones(const Plan& plan, const PlanImages& images); ///< keeps references

  /// In the scan.
  const TriangleMesh& Mesh(PlanId fragment, const ProgressFunction& progress);
  /// What the cuts through the fragment that this one is a piece of did; none if it is no piece.
  std::vector<PlanCutMeasure> Cuts(PlanId fragment);
  /// All pieces of the whole bone that a fragment is of, after the cuts through it and through what
  /// it is a piece of; and what these cuts did.
  const CutBone& Divide(PlanId divided, const ProgressFunction& progress);
  std::vector<PlanCutMeasure> CutsOf(PlanId divided);
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
  const TriangleMesh& MeshOf(const PlanFragment& fragment, const ProgressFunction& progress);
  const PlanFragment& Fragment(PlanId id) const;
  const PlanFragment& Root(PlanId id) const;
  PlanId VolumeOf(const PlanFragment& root) const;
  const std::vector<std::uint8_t>& Mark(const PlanFragment& root);
  Pieces& PiecesOf(PlanId divided, const ProgressFunction& progress);
  std::size_t PieceAt(const Pieces& pieces, const PlanFragment& piece) const;
  void Number(Pieces& pieces, const PlanFragment& root);
  /// Writes `as` where a fragment is.
  void Label(const PlanFragment& fragment, std::uint16_t as, std::vector<std::uint16_t>& numbers,
    const ProgressFunction& progress);

  const Plan& Of;
  const PlanImages& Images;
  std::map<PlanId, std::vector<std::uint8_t>> Marks;
  std::map<PlanId, Pieces> Divided;
  std::map<PlanId, TriangleMesh> Whole;
};

} // namespace hasp
