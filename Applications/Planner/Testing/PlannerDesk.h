#pragma once
#include "../../CommandLine/Testing/TestScreen.h"
#include "PlannerProcess.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// A screen, and a folder of its own that is removed afterwards; its name is a canary: no text may
/// show it. Skips its cases where Xvfb is not installed.
class PlannerDesk : public testing::Test
{
protected:
  static constexpr const char* Canary = "Mustermann_Erika_1964";

  PlannerDesk()
    : Screen({}, "1280x800"),
      folder(std::filesystem::temp_directory_path() /
             (std::string(Canary) + "-desk-" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->folder);
  }
  ~PlannerDesk() override
  {
    std::error_code ignored; // a folder that stays is no reason to fail the test
    std::filesystem::remove_all(this->folder, ignored);
  }
  void SetUp() override
  {
    if (this->Screen.Display().empty())
      GTEST_SKIP() << "Xvfb is not installed";
  }
  /// Each one finds what the one before has left in its home.
  std::unique_ptr<PlannerProcess> Open(std::vector<std::string> words = {})
  {
    return std::make_unique<PlannerProcess>(
      PlannerStart{ this->Screen.Display(), this->folder / "home", std::move(words) });
  }

  TestScreen Screen;
  std::filesystem::path folder;
};
