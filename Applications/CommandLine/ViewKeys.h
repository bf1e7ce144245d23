#pragma once
#include <string>

/// The keys of `hasp view`, by X11's names. Any thread.
namespace hasp
{

/// Hundredths of the isovalue's range that a key steps, 0 for other keys.
int IsoValueStep(const std::string& key);

/// What mouse and keys do, a line each: for --help.
std::string ViewKeys();

} // namespace hasp
