#pragma once
#include <memory>
#include <string>

namespace hasp
{

struct ClusteredCells;
struct Session;

/// Reads a .hcells file, with progress, and lists what reading took among the resources; what the
/// cells hold is their holder's to list. Throws Failure: BadInput.
std::shared_ptr<const ClusteredCells> ReadCells(const std::string& path, Session& session);

} // namespace hasp
