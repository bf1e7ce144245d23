// hasp-part-trial: random parts and cuts, in a process of its own, so that a crash or a loop
// without an end costs `hasp report guides` one part.
//
// Usage: hasp-part-trial kinds               a kind a line, and its shares
//        hasp-part-trial KIND FIRST COUNT    a PartLine for each seed, as soon as it is there
#include "PartKinds.h"
#include "VtkMessages.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

int main(int argc, char** argv)
{
  const hasp::VtkMessageCapture capture([](const std::string&) {});
  if (argc == 2 && std::string_view(argv[1]) == "kinds")
    for (const hasp::PartKind& kind : hasp::PartKinds())
      std::printf("%s %u\n", kind.name, kind.shares);
  if (argc != 4)
    return argc == 2 ? 0 : 2;
  for (const hasp::PartKind& kind : hasp::PartKinds())
  {
    if (std::string_view(argv[1]) != kind.name)
      continue;
    const auto first = std::uint32_t(std::strtoul(argv[2], nullptr, 10));
    const auto count = std::uint32_t(std::strtoul(argv[3], nullptr, 10));
    for (std::uint32_t seed = first; seed < first + count; ++seed)
    {
      hasp::PartLine line = kind.tryOne(seed);
      line.seed = seed;
      std::fputs(hasp::FormatPartLine(line).c_str(), stdout);
      std::fflush(stdout);
    }
    return 0;
  }
  return 2;
}
