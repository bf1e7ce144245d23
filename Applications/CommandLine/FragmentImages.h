#pragma once
#include "Planning/PlanFile.h"
#include "RunImages.h"

#include <string>
#include <vector>

namespace hasp
{

struct Session;

/// The scans and label maps of fragments of a plan: scans found among the files by their hashes,
/// label maps taken from the plan, or made of its recipes and not kept.
///
/// plan   the plan's path, as the user gave it
/// Throws Failure: BadInput, naming the volumes that no file is, and fragments by their ids.
RunImages ImagesOfFragments(const PlanDocument& document, const std::string& plan,
  const std::vector<PlanId>& fragments, const std::vector<std::string>& files, Session& session);

} // namespace hasp
