#pragma once
#include "Grid/TriangleMesh.h"
#include "Planning/Plan.h"
#include "vtkHaspPartLabel.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

/// The files of a transplant's segments.
namespace hasp
{

/// A file of this run, as it was written. Throws Failure.
std::string ReadWholeFile(const std::string& path);

/// Puts a transplant's segments below `folder`, in the defect and on the donor, and their names
/// into `part`. Of what the transplant's file holds: so they are the same for one that was kept.
void WriteSegments(const Plan& plan, PlanId object, const TriangleMesh& mesh,
  nlohmann::ordered_json& part, const PartLabel& label, const std::filesystem::path& folder);

} // namespace hasp
