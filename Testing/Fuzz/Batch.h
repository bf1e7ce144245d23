#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hasp
{

/// What became of one input.
enum class Outcome : std::uint32_t
{
  Opened,
  Refused ///< with a std::exception
};

struct BatchSettings
{
  std::uint64_t first = 0; ///< number of the first input
  std::uint64_t count = 0;
  std::uint64_t perFork = 500; ///< inputs a forked process runs before the next is forked
  double hangSeconds = 8.0;    ///< an input that takes longer is a hang
  std::size_t memoryBytes = std::size_t(3) << 30; ///< address space of a forked process
  std::filesystem::path folder; ///< empty; inputs may be written there, and nothing else
};

struct BatchResult
{
  std::uint64_t run = 0, opened = 0, refused = 0;
  std::uint64_t filesLeft = 0;    ///< files found that nobody asked for
  std::uint64_t bytesPrinted = 0; ///< on standard output and error: a library prints nothing
  std::uint64_t peakBytes = 0;    ///< resident, of the largest forked process
  std::vector<std::uint64_t> crashes, hangs; ///< the inputs' numbers
  double seconds = 0.0;

  bool Good() const;
};

/// Runs `input` for each number in forked processes, so that a crash or a hang ends that process
/// and no more; the next one goes on after the guilty input. `input` may write to the folder it is
/// given and must remove what it wrote.
///
/// Throws std::system_error if no process can be made. One thread.
BatchResult RunBatch(const BatchSettings& settings,
  const std::function<Outcome(std::uint64_t number, const std::filesystem::path& folder)>& input);

} // namespace hasp
