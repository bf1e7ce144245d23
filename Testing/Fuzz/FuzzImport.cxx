// Feeds readers with mutated files: no crash, no hang, no file written, nothing printed.
//
//   FuzzImport FORMAT|all COUNT [FIRST]
//
// prints a line a format and the number of each guilty input; FORMAT 1 NUMBER runs that input
// again.
#include "Batch.h"
#include "Mutation.h"
#include "Targets.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

/// Removed with all that is in it.
struct TemporaryFolder
{
  TemporaryFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "hasp-fuzz-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      throw std::runtime_error("no temporary folder");
    this->path = pattern;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->path, ignored);
  }
  std::filesystem::path path;
};

/// Mutating what is refused anyway would prove nothing.
bool SeedsAreSound(const hasp::Target& target, const std::vector<std::string>& seeds,
  const std::filesystem::path& folder, const std::filesystem::path& seedFolder)
{
  hasp::BatchSettings settings;
  settings.count = seeds.size();
  settings.folder = folder;
  const hasp::BatchResult result =
    hasp::RunBatch(settings, [&](std::uint64_t number, const std::filesystem::path& inputs)
      { return hasp::Try(target, seeds[number], inputs, seedFolder); });
  if (result.Good() && result.opened == seeds.size())
    return true;
  std::printf("%-8s only %llu of %zu seeds are opened\n", target.name.c_str(),
    static_cast<unsigned long long>(result.opened), seeds.size());
  return false;
}

bool Fuzz(const hasp::Target& target, std::uint64_t first, std::uint64_t count)
{
  const TemporaryFolder seedFolder, inputs, temporary;
  const auto seeds = hasp::SeedsOf(target, seedFolder.path);
  setenv("TMPDIR", temporary.path.c_str(), 1);
  if (!SeedsAreSound(target, seeds, inputs.path, seedFolder.path))
    return false;
  hasp::BatchSettings settings;
  settings.first = first;
  settings.count = count;
  settings.folder = inputs.path;
  const hasp::BatchResult result =
    hasp::RunBatch(settings, [&](std::uint64_t number, const std::filesystem::path& folder)
      { return hasp::Try(target, hasp::Mutate(seeds, number), folder, seedFolder.path); });
  unsetenv("TMPDIR");
  const bool temporaryLeft = !std::filesystem::is_empty(temporary.path);
  std::printf("%-8s %8llu inputs from %llu: %llu opened, %llu refused, %zu crashes, %zu hangs, "
              "%llu files written, %llu bytes printed; peak %.0f MiB, %.0f inputs/s\n",
    target.name.c_str(), static_cast<unsigned long long>(result.run),
    static_cast<unsigned long long>(first), static_cast<unsigned long long>(result.opened),
    static_cast<unsigned long long>(result.refused), result.crashes.size(), result.hangs.size(),
    static_cast<unsigned long long>(result.filesLeft) + (temporaryLeft ? 1 : 0),
    static_cast<unsigned long long>(result.bytesPrinted), double(result.peakBytes) / (1 << 20),
    double(result.run) / result.seconds);
  for (const std::uint64_t number : result.crashes)
    std::printf("  crash: FuzzImport %s 1 %llu\n", target.name.c_str(),
      static_cast<unsigned long long>(number));
  for (const std::uint64_t number : result.hangs)
    std::printf("  hang: FuzzImport %s 1 %llu\n", target.name.c_str(),
      static_cast<unsigned long long>(number));
  std::fflush(stdout);
  return result.Good() && !temporaryLeft && result.run == count;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::fputs("usage: FuzzImport FORMAT|all COUNT [FIRST]\n", stderr);
    return 2;
  }
  const std::string format = argv[1];
  const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
  const std::uint64_t first = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 0;
  bool good = true, known = false;
  for (const hasp::Target& target : hasp::Targets())
    if (format == "all" || format == target.name)
    {
      known = true;
      good = Fuzz(target, first, count) && good;
    }
  if (!known)
    std::fprintf(stderr, "FuzzImport: this build has no format %s\n", format.c_str());
  return known && good ? 0 : 1;
}
