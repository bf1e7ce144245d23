#pragma once
#include "Grid/Progress.h"
#include "Model/ScanShelf.h"

#include <string>
#include <vector>

namespace hasp
{

/// What the planner can be tried on without a scan of one's own.
enum class Sample
{
  Skull, ///< Debian's real CT with a frontal defect, where it is installed; else a phantom with one
  Mandible, ///< a phantom's lower jaw, broken in four
  Fibula    ///< a phantom's head, and a leg to take bone from: two scans
};

/// The file of the real CT: $HASP_SAMPLE, or where Debian's invesalius-examples has it; empty: it
/// is not there. Any thread.
std::string SampleFile();

/// Makes or reads the scans of a sample, the patient's first. WORKER. Throws as ScanShelf::Read.
std::vector<ShelfScan> MakeSample(Sample sample, const ProgressFunction& progress);

} // namespace hasp
