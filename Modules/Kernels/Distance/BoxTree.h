#pragma once
#include "Distance/ImplicitSolid.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace hasp
{

/// Boxes in a binary tree: those of many whose excess at a place may be at most a bound, nearest
/// first. Built once, O(n log^2 n); asked from any thread without memory of its own.
class BoxTree
{
public:
  explicit BoxTree(const std::vector<ImplicitSolid::Box>& boxes);

  /// The hull of all.
  const ImplicitSolid::Box& Hull() const { return this->Nodes.front().box; }

  /// Calls visit(n) for each box n whose excess at x is at most `bound`, which visit may lower, and
  /// for some within SolidTieMm of it, so that rounding leaves out none.
  template <typename Visit>
  void Within(const glm::dvec3& x, const double& bound, const Visit& visit) const noexcept
  {
    // Halves: 2^32 boxes are 32 levels, and each level leaves one node behind.
    struct Waiting
    {
      double excess;
      std::uint32_t at;
    };
    std::array<Waiting, 40> waiting; // left as it is: to clear it takes as long as a few boxes
    std::size_t count = 0;
    waiting[count++] = { this->Nodes.front().box.Excess(x), 0 };
    while (count > 0)
    {
      const auto [excess, at] = waiting[--count];
      if (excess > bound + SolidTieMm)
        continue;
      const Node& node = this->Nodes[at];
      if (node.second == 0)
      {
        visit(node.item);
        continue;
      }
      Waiting near{ this->Nodes[at + 1].box.Excess(x), at + 1 };
      Waiting far{ this->Nodes[node.second].box.Excess(x), node.second };
      if (far.excess < near.excess)
        std::swap(near, far);
      waiting[count++] = far;
      waiting[count++] = near;
    }
  }

private:
  /// The first child follows its parent.
  struct Node
  {
    ImplicitSolid::Box box;
    std::uint32_t second; ///< the other child; 0: a leaf
    std::uint32_t item;   ///< of a leaf
  };
  void Build(
    const std::vector<ImplicitSolid::Box>& boxes, std::uint32_t* first, std::uint32_t* last);

  std::vector<Node> Nodes;
};

} // namespace hasp
