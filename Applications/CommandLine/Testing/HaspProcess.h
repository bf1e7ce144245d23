#pragma once
#include <gtest/gtest.h>

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

/// What a run of bin/hasp left behind.
struct HaspRun
{
  int exitCode = -1; ///< 128 + signal if one ended it
  std::string out;
  std::string err;
};

/// Runs bin/hasp with these arguments, on that display (empty: none), its output caught; or, where
/// a device is named, its standard output sent there.
HaspRun RunHasp(const std::vector<std::string>& arguments, const std::string& device = {},
  const std::string& display = {});

/// Runs bin/hasp, and expects that it ends well. What it wrote on its standard output.
std::string OutputOfHasp(const std::vector<std::string>& arguments);

/// Starts bin/hasp, its standard error a pipe's end. To be waited for.
pid_t StartHasp(
  const std::vector<std::string>& arguments, int errorPipe, const std::string& display = {});

/// A folder of its own for a test, removed afterwards. Its name is a canary: no text may show it.
class HaspTest : public testing::Test
{
protected:
  HaspTest();
  ~HaspTest() override;

  std::string Path(const std::string& name) const { return (this->folder / name).string(); }
  void WriteText(const std::string& name, const std::string& text) const;
  /// A coarse phantom of the given name.
  std::string Phantom(const std::string& name = "head.mha") const;
  /// Names in the folder, hidden ones too, sorted.
  std::vector<std::string> Names() const;

  std::filesystem::path folder;
};

/// The whole file.
std::string ReadBytes(const std::string& path);

/// Expects the exit code, a text on stderr that holds `words`, and no folder of the test in it.
void ExpectFailure(const HaspRun& run, int exitCode, const std::string& words);
