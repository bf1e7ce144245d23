#pragma once

namespace hasp
{

/// The program: understands the command line, opens the window, offers what a crash left, and does
/// what a script asks for. Returns the exit code: 0 done, 1 wrong use, 2 bad input, 3 a part does
/// not hold, 4 nothing can be drawn.
int RunPlanner(int argc, char* argv[]);

} // namespace hasp
