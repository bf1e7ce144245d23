#pragma once
#include "Planning/SeedsFile.h"
#include "Planning/StrictJson.h"

#include <string>
#include <vector>

namespace hasp
{

/// One markup of 3D Slicer's as strokes. Internal.
struct SlicerMarkup
{
  std::uint16_t label = 0; ///< 0: not said
  LabelName name;          ///< its label is not set
  bool hasColour = false;
  std::vector<BrushStroke> strokes; ///< their labels are not set
  std::vector<std::string> places;  ///< one a stroke: Seeds::places
};

/// Whether it is a file of markups, sound or not.
bool IsMarkups(const Json& json);

/// Adds what the file holds to `markups` and counts the control points without a place. `subject`
/// begins messages. Throws std::invalid_argument. Internal. Any thread.
void ReadMarkups(const Json& json, const std::string& subject, double radiusMm,
  std::vector<SlicerMarkup>& markups, std::size_t& notPlaced);

/// Numbers for those that have none.
Seeds SeedsOfMarkups(std::vector<SlicerMarkup> markups, std::uint16_t firstLabel);

Json MarkupsToJson(const Seeds& seeds);

} // namespace hasp
