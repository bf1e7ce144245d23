// The certificate on seeded parts, printed: BenchCertificate [parts of each kind, 20] [first seed]
#include "CertificateTrial.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 20;
  const auto seed = std::uint32_t(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1000);
  std::size_t found = 0, defective = 0;
  for (int n = 0; n <= hasp::SeededDefects; ++n)
  {
    const auto defect = static_cast<hasp::SeededDefect>(n);
    const std::size_t parts = n == 0 ? count * hasp::SeededDefects : count;
    const hasp::CertificateTrial trial =
      hasp::TryCertificate(defect, seed + std::uint32_t(n == 0 ? 100000 : 1000 * n), parts);
    std::printf("%-18s %4zu parts, red %4zu, found %4zu; %6.0f triangles, %6.1f ms each\n",
      hasp::SeededDefectName(defect), trial.parts, trial.red, trial.found,
      double(trial.triangles) / double(parts), trial.milliseconds / double(parts));
    for (const std::string& wrong : trial.wrong)
      std::printf("  WRONG: %s\n", wrong.c_str());
    std::fflush(stdout);
    if (n > 0)
    {
      found += trial.found;
      defective += trial.parts;
    }
  }
  std::printf("found %zu of %zu\n", found, defective);
  return found == defective ? 0 : 1;
}
