#pragma once
#include "Planning/SegmentationRecipe.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hasp
{

/// Strokes that say what belongs to which fragment, and what the fragments are called: what a
/// SplitStep is told by a file. A plain value.
struct Seeds
{
  std::vector<LabelName> names;     ///< each label once
  std::vector<BrushStroke> strokes; ///< of labels that have a name; at most MostStrokes
  /// Control points of Slicer's markups that were left out, because nobody had placed them yet.
  std::size_t notPlaced = 0;
  /// Where each stroke stands in the file that it was read from, for messages:
  /// "labels[0].strokes[1]", "markups[2].controlPoints[4]", of several files "file 2: markups[0]".
  /// Empty if it was not read. Does not count when seeds are compared.
  std::vector<std::string> places = {};

  bool operator==(const Seeds& other) const noexcept
  {
    return this->names == other.names && this->strokes == other.strokes &&
           this->notPlaced == other.notPlaced;
  }
};

/// Throws std::invalid_argument unless names and strokes are legal in a recipe and each stroke's
/// label is among the names. The message names the key, and no text of the user's.
void ValidateSeeds(const Seeds& seeds);

/// Our own file, readable by people; world is patient LPS, mm:
///
///   { "format": "hasp-seeds-1",
///     "labels": [{ "label": 2, "name": "ramus", "colour": "#e3dac9",
///                  "strokes": [{ "radiusMm": 2, "points": [[x,y,z], …] }, …] }, …] }
///
/// Strict: every key must be there, and no other. What is read back has its strokes in the order of
/// their labels in `names`, those of a label in the order that they had; notPlaced is not kept, and
/// places are those of the file.
/// Errors are std::runtime_error (file, syntax) or std::invalid_argument (content) and say which
/// key, never the file's name or text. Needs HASP_ENABLE_JSON. Any thread.
Seeds ParseSeeds(const std::string& json);
std::string FormatSeeds(const Seeds& seeds);
/// As a whole or not at all, at most 16 MiB.
void WriteSeeds(const std::string& path, const Seeds& seeds);

/// What 3D Slicer's markups do not say.
struct MarkupsChoices
{
  double radiusMm = 2.0;        ///< of strokes whose markup has no size in mm, (0, 50]
  std::uint16_t firstLabel = 2; ///< of those that have no number, [1, 65535]
};

/// Reads one of our own, or 3D Slicer's markups (.mrk.json, schema 1.x), one file or several, each
/// of at most 16 MiB. A list of points (Fiducial) is a dot each, a Line, Curve or ClosedCurve one
/// stroke, straight from one control point to the next: Slicer's own curve is rounder where they
/// lie far apart. Other markups are refused.
///
/// - Each markup is a label: of the number that FormatMarkups left in the descriptions of its
///   control points, else of the next free one from firstLabel on. Markups of the same number, or
///   of the same name (Slicer keeps none in its files), are one label.
/// - The colour is that of selected points, as Slicer draws them, else the markup's own.
/// - The radius is half the glyph's size where that is in mm (useGlyphScale is false).
/// - RAS becomes LPS, um becomes mm; without a word it is LPS and mm, as Slicer takes it.
/// - Control points without a place are counted and left out; a markup that has no others is
///   refused.
///
/// Labels and descriptions of control points are the user's words: none is kept or said. Errors as
/// above; of several files they say the number of the file, from 1.
Seeds ReadSeeds(const std::vector<std::string>& paths, const MarkupsChoices& choices = {});
/// The same of texts.
Seeds ParseAnySeeds(const std::vector<std::string>& texts, const MarkupsChoices& choices = {});

/// A .mrk.json for Slicer: a curve a stroke, and lists of points for strokes of one point; as wide
/// as the brush. ReadSeeds gives the same back, also when Slicer has stored each markup in a file
/// of its own, but for the names.
std::string FormatMarkups(const Seeds& seeds);
void WriteMarkups(const std::string& path, const Seeds& seeds);

} // namespace hasp
