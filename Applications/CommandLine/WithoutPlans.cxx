// In place of MirrorStep.cxx in a build without plans: there are no such options.
#include "MirrorStep.h"

namespace hasp
{

void AddMirrorStepOptions(CLI::App&, MirrorStep&) {}
void RequireMirrorStep(const MirrorStep&) {}
void RequireScanInPlan(const MirrorStep&, const std::string&) {}
void KeepMirror(const MirrorStep&, const std::string&, double, const MirrorPlane&, Session&) {}

} // namespace hasp
