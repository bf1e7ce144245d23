#pragma once
#include "TransplantBuilder.h"

#include <nlohmann/json.hpp>

#include <string>

/// What `hasp transplant` says of what it made.
namespace hasp
{

/// "segment-1.stl" in the defect, and "donor-segment-1.stl" where it is cut from.
std::string SegmentFile(std::size_t segment);
std::string DonorSegmentFile(std::size_t segment);
/// Of the jaw after the resection: "fragment-1.stl".
std::string StumpFile(const BoneFragment& fragment);
/// What stays in the patient and is more than a crumb.
bool IsStump(const BoneFragment& fragment);

/// One of a transplant's segments, and one of its joints; mm and degrees.
nlohmann::ordered_json DescribeSegment(
  const DonorSegment& cut, double volumeMm3, std::size_t triangles);
nlohmann::ordered_json DescribeJoint(const MadeJoint& joint);

/// Segments, joints, donor cuts, stumps, vessel and skin; mm and degrees.
nlohmann::ordered_json DescribeTransplant(const MadeTransplant& made);

/// The same on standard output as a table, without places.
void PrintTransplant(const MadeTransplant& made);

} // namespace hasp
