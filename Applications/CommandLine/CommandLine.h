#pragma once

namespace hasp
{

/// Reads the command line, runs its verb and says what went wrong. Returns the process's exit code;
/// throws nothing that main should not see as a defect of its own.
int RunCommandLine(int count, char** arguments);

} // namespace hasp
