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
  Skull,    ///< Debian's real CT with a frontal defect, where it is there; else a phantom with one
  Mandible, ///< a phantom's lower jaw, broken in four
  Fibula    ///< a phantom's head, and a leg to take bone from: two scans
};

/// The file of the real CT: $HASP_SAMPLE; or where Debian's invesalius-examples has it, where
/// Utilities/Scripts/cranium puts it in the checkout whose build folder the program is in, or in
/// share/hasp beside the installed program. Empty: it is not there. RENDER.
std::string SampleFile();

/// Makes or reads the scans of a sample, the patient's first. file: SampleFile(). WORKER. Throws as
/// ScanShelf::Read.
std::vector<ShelfScan> MakeSample(
  Sample sample, const std::string& file, const ProgressFunction& progress);

} // namespace hasp
