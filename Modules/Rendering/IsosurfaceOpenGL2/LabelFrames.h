#ifndef LabelFrames_h
#define LabelFrames_h

#include "CellLabels.h"
#include "Grid/GridGeometry.h"

#include <glm/vec2.hpp>

#include <vector>

/// What is said of labels, as shaders and culling take it.
struct LabelFrames
{
  std::vector<glm::dmat4> moves;          ///< index coordinates to moved ones; the first stays
  std::vector<std::uint32_t> moveOfLabel; ///< by label; labels beyond the last stay
  /// By label, the last for all beyond: number of the move and flags (CellFrame.glsl); RGBA.
  std::vector<glm::uvec2> table;

  LabelFrames() = default;
  LabelFrames(const hasp::CellLabels& labels, const hasp::GridGeometry& geometry);
  bool Moved() const { return this->moves.size() > 1; }
};

#endif
