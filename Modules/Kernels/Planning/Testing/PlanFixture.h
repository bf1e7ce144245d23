#pragma once
#include "RandomDocument.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

/// A folder of its own for a test, gone afterwards. Its name is one that no error may tell.
class PlanFolder
{
public:
  PlanFolder()
  {
    static int number = 0;
    this->Place = std::filesystem::path(testing::TempDir()) /
                  ("Erika-" + std::to_string(getpid()) + "-" + std::to_string(number++));
    std::filesystem::create_directory(this->Place);
  }
  ~PlanFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(this->Place, error);
  }
  PlanFolder(const PlanFolder&) = delete;
  PlanFolder& operator=(const PlanFolder&) = delete;

  std::filesystem::path Plan() const { return this->Place / "case.hasp"; }

private:
  std::filesystem::path Place;
};

inline std::string ReadBytes(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

inline void WriteBytes(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// The message that `act` throws; empty if it does not. None may tell the folder's name.
template <typename Act>
std::string Thrown(Act act)
{
  try
  {
    act();
    return {};
  }
  catch (const std::exception& error)
  {
    EXPECT_EQ(std::string(error.what()).find("rika"), std::string::npos) << error.what();
    return error.what();
  }
}
