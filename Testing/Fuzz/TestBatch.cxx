// The harness itself: it must see what it is there to see.
#include "Batch.h"
#include "Mutation.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <stdexcept>

using namespace hasp;

namespace
{

class Batch : public ::testing::Test
{
protected:
  Batch()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "hasp-batch-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
      throw std::runtime_error("no temporary folder");
    this->settings.folder = pattern;
    this->settings.count = 40;
    this->settings.perFork = 15; // no divisor of the count
  }
  ~Batch() override { std::filesystem::remove_all(this->settings.folder); }

  BatchSettings settings;
};

TEST_F(Batch, EveryInputRunsOnceWhateverTheForks)
{
  this->settings.first = 7;
  const BatchResult result =
    RunBatch(this->settings, [](std::uint64_t number, const std::filesystem::path&)
      { return number % 2 == 0 ? Outcome::Opened : Outcome::Refused; });
  EXPECT_TRUE(result.Good());
  EXPECT_EQ(result.run, 40U);
  EXPECT_EQ(result.opened, 20U);
  EXPECT_GT(result.peakBytes, 0U);
}

TEST_F(Batch, CrashesAreCountedAndTheRestGoesOn)
{
  const BatchResult result = RunBatch(this->settings,
    [](std::uint64_t number, const std::filesystem::path&)
    {
      if (number == 3)
        raise(SIGSEGV);
      if (number == 14) // the last of its fork
        throw std::runtime_error("nobody catches this");
      if (number == 20)
        _exit(0); // ends early without a signal
      return Outcome::Opened;
    });
  EXPECT_EQ(result.crashes, (std::vector<std::uint64_t>{ 3, 14, 20 }));
  EXPECT_EQ(result.opened, 37U);
  EXPECT_FALSE(result.Good());
}

TEST_F(Batch, AHangIsEnded)
{
  this->settings.hangSeconds = 0.2;
  const BatchResult result = RunBatch(this->settings,
    [](std::uint64_t number, const std::filesystem::path&)
    {
      while (number == 5)
        pause();
      return Outcome::Opened;
    });
  EXPECT_EQ(result.hangs, (std::vector<std::uint64_t>{ 5 }));
  EXPECT_EQ(result.opened, 39U);
}

TEST_F(Batch, FilesAndWordsLeftBehindAreSeen)
{
  const BatchResult result = RunBatch(this->settings,
    [](std::uint64_t number, const std::filesystem::path& folder)
    {
      if (number == 2)
        std::ofstream(folder / "left") << "x";
      if (number == 4 && write(STDERR_FILENO, "said", 4) != 4)
        abort();
      return Outcome::Opened;
    });
  EXPECT_EQ(result.filesLeft, 1U);
  EXPECT_EQ(result.bytesPrinted, 4U);
  EXPECT_FALSE(result.Good());
}

TEST_F(Batch, MemoryIsLimited)
{
  this->settings.memoryBytes = std::size_t(256) << 20;
  const BatchResult result = RunBatch(this->settings,
    [](std::uint64_t number, const std::filesystem::path&)
    {
      if (number == 9)
        std::fill_n(new volatile char[std::size_t(1) << 30], 1, 'x'); // nobody can leave this out
      return Outcome::Opened;
    });
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "AddressSanitizer needs the addresses that the limit takes away";
#endif
  EXPECT_EQ(result.crashes, (std::vector<std::uint64_t>{ 9 }));
}

TEST(Mutation, IsTheSameForTheSameNumberAndElseNearlyNever)
{
  std::vector<std::string> seeds(2); // of different bytes: a piece of equal ones moved is no fault
  std::mt19937 engine(1);
  for (std::string& seed : seeds)
    std::generate_n(std::back_inserter(seed), 3000, [&] { return static_cast<char>(engine()); });
  std::set<std::string> all;
  std::size_t unchanged = 0;
  for (std::uint64_t number = 0; number < 2000; ++number)
  {
    const std::string bytes = Mutate(seeds, number);
    EXPECT_EQ(bytes, Mutate(seeds, number));
    all.insert(bytes);
    unchanged += bytes == seeds[0] || bytes == seeds[1] ? 1 : 0;
  }
  EXPECT_GT(all.size(), 1800U); // cut off at the same place, say
  EXPECT_LT(unchanged, 40U);
  EXPECT_THROW(Mutate({}, 1), std::invalid_argument);
}

} // namespace
