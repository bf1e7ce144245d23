#pragma once
#include "Grid/GridGeometry.h"
#include "RGBPicture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// A folder of its own for a test, removed afterwards, and a shell in it without a display.
class ExampleTest : public testing::Test
{
protected:
  ExampleTest();
  ~ExampleTest() override;

  std::string Path(const std::string& name) const { return (this->folder / name).string(); }
  /// Runs an example of the build ("DrawIsosurface ball.mha 0 picture.png"); its exit code, and in
  /// `said` what it printed.
  int Run(const std::string& command);
  /// The same for any command.
  int Shell(const std::string& command);
  /// Writes samples as a .mha file into the folder.
  void Write(const std::string& name, const hasp::GridGeometry& grid,
    const std::vector<std::int16_t>& samples) const;
  /// ball.mha: 1000 - 100 |p - middle| on a grid that is turned and anisotropic. The isosurface of
  /// 0 is a ball of 10 mm in its middle.
  void WriteBall() const;

  std::filesystem::path folder;
  std::string said;
};

/// Lit pixels in columns [x0, x1): how many, and the box that holds them.
struct LitPart
{
  int count = 0, left = 0, right = -1, bottom = 0, top = -1;
  int Width() const { return this->right - this->left + 1; }
  int Height() const { return this->top - this->bottom + 1; }
};
LitPart FindLit(const hasp::RGBPicture& picture, int x0, int x1);

/// Expects a disc of a good size in the middle of columns [x0, x1).
void ExpectDisc(const hasp::RGBPicture& picture, int x0, int x1);
