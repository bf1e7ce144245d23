#include "ExampleRun.h"

#include "Grid/AnalyticVolumes.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/gtc/matrix_transform.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>

namespace fs = std::filesystem;

ExampleTest::ExampleTest()
  : folder(fs::temp_directory_path() / ("hasp-examples-" + std::to_string(getpid())))
{
  fs::create_directories(this->folder);
}

ExampleTest::~ExampleTest()
{
  std::error_code ignored; // a folder that stays is no reason to fail the test
  fs::remove_all(this->folder, ignored);
}

int ExampleTest::Run(const std::string& command)
{
  return this->Shell("'" HASP_PROGRAMS "'/" + command);
}

int ExampleTest::Shell(const std::string& command)
{
  const std::string log = this->Path("log.txt");
  const int status = std::system(
    ("cd '" + this->folder.string() + "' && unset DISPLAY && " + command + " >log.txt 2>&1")
      .c_str());
  std::ifstream file(log);
  this->said = { std::istreambuf_iterator<char>(file), {} };
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void ExampleTest::Write(const std::string& name, const hasp::GridGeometry& grid,
  const std::vector<std::int16_t>& samples) const
{
  hasp::WriteVolume(hasp::MakeImage(grid, samples), this->Path(name));
}

void ExampleTest::WriteBall() const
{
  hasp::GridGeometry grid;
  grid.dims = { 41, 41, 29 };
  grid.spacing = { 0.7, 0.7, 1.0 };
  grid.direction =
    glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.4, glm::normalize(glm::dvec3(1, 2, -1))));
  const glm::dvec3 middle(30, -20, 500);
  grid.origin = middle - grid.direction * (0.5 * grid.spacing * glm::dvec3(grid.Cells()));
  this->Write("ball.mha", grid,
    hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere(middle, 10.0), grid, 100.0, 0.0));
}

LitPart FindLit(const hasp::RGBPicture& picture, int x0, int x1)
{
  LitPart lit{ 0, picture.width, -1, picture.height, -1 };
  for (int y = 0; y < picture.height; ++y)
    for (int x = x0; x < x1; ++x)
    {
      const std::uint8_t* pixel = picture.At(x, y);
      if (pixel[0] + pixel[1] + pixel[2] == 0)
        continue;
      ++lit.count;
      lit.left = std::min(lit.left, x);
      lit.right = std::max(lit.right, x);
      lit.bottom = std::min(lit.bottom, y);
      lit.top = std::max(lit.top, y);
    }
  return lit;
}

void ExpectDisc(const hasp::RGBPicture& picture, int x0, int x1)
{
  const LitPart lit = FindLit(picture, x0, x1);
  EXPECT_GT(lit.Width(), 100);
  // Round and in the middle to a pixel at either end.
  EXPECT_NEAR(lit.Width(), lit.Height(), 2);
  EXPECT_NEAR(lit.left + lit.right, x0 + x1 - 1, 2);
  EXPECT_NEAR(lit.bottom + lit.top, picture.height - 1, 2);
  // A box of 100 pixels may be wrong by one pixel each way: 2 % of its area.
  EXPECT_NEAR(lit.count, std::numbers::pi / 4 * lit.Width() * lit.Height(), 0.02 * lit.count);
}
