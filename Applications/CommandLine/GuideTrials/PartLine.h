#pragma once
#include "Grid/TriangleMesh.h"

#include <cstdint>
#include <optional>
#include <string>

namespace hasp
{

/// What came of a random part.
enum class PartOutcome
{
  Sound,   ///< closed, 2-manifold, outward, one piece, does not meet itself
  Refused, ///< by an error that names what is wrong
  Open,    ///< made, and not closed, not 2-manifold, not outward or in pieces
  Crossed, ///< made, and meets itself
  Empty,   ///< no part, and no error
  Wrong,   ///< nonsense was made, what is sound was refused, or the error names something else
  FellBack ///< a method below the part's own gave up
};

/// In words: "sound", "meets itself".
const char* PartOutcomeName(PartOutcome outcome);

/// A line of hasp-part-trial, the child process that makes random parts.
struct PartLine
{
  std::uint32_t seed = 0;
  PartOutcome outcome = PartOutcome::Empty;
  double figure = 0.0, second = 0.0; ///< what the kind measures besides: PartKind tells
  std::size_t triangles = 0;
  double seconds = 0.0; ///< of making it
  std::string text{};   ///< what it is, and the error
};

std::string FormatPartLine(const PartLine& line);
/// None unless it is whole.
std::optional<PartLine> ParsePartLine(const std::string& text);

/// What is known of a part before it is made, and what came of it.
struct TriedPart
{
  std::string kind;         ///< "plain", "hole in air" ...
  bool mayBeRefused = true; ///< else it must be made
  std::string refusal{};    ///< if it must be refused: the error has these words
  std::string owner{};      ///< "guide": errors of its own begin so, "guide: ..."
  std::string error{};      ///< what was thrown or reported; empty if nothing
  TriangleMesh mesh{};      ///< AsWritten, or read back from its file and welded
};

/// A mesh as a binary STL file keeps it: coordinates of 32 bits, points of one place made one.
TriangleMesh AsWritten(TriangleMesh mesh);

/// Without CGAL nothing is said of parts that meet themselves. Any thread.
PartLine JudgePart(const TriedPart& part);

} // namespace hasp
