#pragma once
#include <memory>
#include <string>

namespace hasp
{

struct ClusteredCells;
struct Session;

/// Reads a .hcells file, with progress, and lists the "active cells, file" among the resources.
/// Throws Failure: BadInput.
std::shared_ptr<const ClusteredCells> ReadCells(const std::string& path, Session& session);

} // namespace hasp
