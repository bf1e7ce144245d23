#ifndef vtkHaspCellFile_h
#define vtkHaspCellFile_h

#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro

#include <cstddef> // for sizes
#include <memory>  // for cells
#include <string>  // for paths

/// Active cells in files (.hcells), without a pipeline: what vtkHaspClusteredCellReader and
/// vtkHaspClusteredCellWriter are skins of. Any thread, one per file.
///
/// The file, little-endian (Utilities/Docs/Formats.md): a head of 224 bytes with a CRC-32 of its
/// own, then what ClusteredCells holds, as it lies in memory, with a CRC-32 of all of it. It holds
/// no text, and nothing of the volume but the samples at the cells' corners and where they lie.
namespace hasp
{

struct ClusteredCells; // of Isosurface/ClusteredCells.h

struct CellReadSettings
{
  std::size_t memoryLimitBytes = std::size_t(4) << 30; ///< of the cells; checked before it is taken
};

/// Does the name end in .hcells?
VTKHASPIOMEDICAL_EXPORT bool IsCellFileName(const std::string& path);

/// For whoever reads something else, `wanted` ("volume"): throws std::runtime_error, with what the
/// file is and what to do, if it begins as active cells do, whatever its name. Never for what is
/// no regular file.
VTKHASPIOMEDICAL_EXPORT void RefuseCells(const std::string& path, const std::string& wanted);

/// UTF-8 path. Sizes are held against the file's before memory is taken, checksums before anything
/// is believed, and then each cluster by ValidateCells: whoever draws or traces what comes out need
/// not doubt a number in it, whoever wrote the file.
/// Throws std::runtime_error with the file's label, what is wrong and what to do; Cancelled.
/// One pass over the file and one over the cells.
VTKHASPIOMEDICAL_EXPORT std::shared_ptr<const ClusteredCells> LoadCells(const std::string& path,
  const CellReadSettings& settings = {}, const ProgressFunction& progress = {});

/// Writes whole or not at all; the name ends in .hcells. The same cells give the same bytes.
/// Throws std::invalid_argument for cells that ValidateCells refuses, std::runtime_error for the
/// file, Cancelled; the earlier file is then as it was. One pass over the cells and two over their
/// bytes.
VTKHASPIOMEDICAL_EXPORT void WriteCells(
  const ClusteredCells& cells, const std::string& path, const ProgressFunction& progress = {});

} // namespace hasp

#endif
