#pragma once

namespace hasp
{

/// "0.1.0"
const char* Version();

/// The commit this was built from, "+" appended if the tree had changes; "unknown" outside git.
const char* Commit();

} // namespace hasp
