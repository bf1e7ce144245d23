#include "HaspRenderTest.h"

#include "PictureFiles.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

struct Arguments
{
  fs::path baseline{};
  fs::path output{};
  bool record = false;
};

Arguments ReadArguments(int argc, char* argv[])
{
  Arguments arguments;
  for (int a = 1; a < argc; ++a)
  {
    const std::string_view word = argv[a];
    if (word == "--record")
      arguments.record = true;
    else if (word == "--baseline" && a + 1 < argc)
      arguments.baseline = argv[++a];
    else if (word == "--output" && a + 1 < argc)
      arguments.output = argv[++a];
  }
  if (arguments.baseline.empty() || arguments.output.empty())
    throw std::invalid_argument("usage: TestX --baseline FILE --output FOLDER [--record]");
  return arguments;
}

std::string UpdateCommand(const fs::path& baseline)
{
  return "Utilities/Scripts/update-baseline " + baseline.stem().string();
}

int Record(const RGBPicture& picture, const fs::path& file)
{
  RGBPicture plain = picture;
  for (std::size_t p = 3; p < plain.pixels.size(); ++p)
    plain.pixels[p] = plain.pixels[p % 3];
  if (plain.pixels == picture.pixels)
    throw std::runtime_error("nothing to record: all of the picture has one colour");
  WritePNG(picture, file);
  std::cout << "recorded " << file.string() << "\n";
  return EXIT_SUCCESS;
}

/// One comparison, in words. `broken` is empty if the picture passes.
struct Verdict
{
  PictureDifference difference{};
  std::vector<std::string> broken{};
  fs::path baseline{};
};

Verdict Judge(const RGBPicture& picture, const fs::path& baseline, const PictureLimits& limits)
{
  const RGBPicture expected = ReadPNG(baseline);
  Verdict verdict{ ComparePictures(picture, expected), {}, baseline };
  verdict.broken = FindBrokenLimits(verdict.difference, limits);
  constexpr double vtkLimit = 0.15; // vtkRegressionTestImage's
  if (MeasureAsVTKDoes(picture, expected) > vtkLimit)
    verdict.broken.emplace_back("VTK's own comparison fails, too");
  return verdict;
}

/// TestX.png, TestX_1.png, TestX_2.png … as far as they are there.
std::vector<fs::path> ListAlternates(const fs::path& baseline)
{
  std::vector<fs::path> files = { baseline };
  for (int n = 1;; ++n)
  {
    const fs::path file =
      baseline.parent_path() /
      (baseline.stem().string() + "_" + std::to_string(n) + baseline.extension().string());
    if (!fs::exists(file))
      return files;
    files.push_back(file);
  }
}

int Compare(const RGBPicture& picture, const Arguments& arguments, const PictureLimits& limits)
{
  const fs::path name = arguments.baseline.stem();
  const fs::path gotFile = arguments.output / (name.string() + ".png");
  const fs::path differenceFile = arguments.output / (name.string() + ".difference.png");
  fs::remove(gotFile); // of an earlier run
  fs::remove(differenceFile);
  Verdict best;
  try
  {
    for (const fs::path& file : ListAlternates(arguments.baseline))
    {
      Verdict verdict = Judge(picture, file, limits);
      if (best.baseline.empty() || verdict.difference.mean < best.difference.mean ||
          verdict.broken.empty())
        best = std::move(verdict);
      if (best.broken.empty())
        break;
    }
  }
  catch (const std::exception&)
  {
    WritePNG(picture, gotFile);
    throw;
  }
  std::cout << name.string() << ": " << Describe(best.difference, limits) << "\n";
  if (best.broken.empty())
    return EXIT_SUCCESS;

  WritePNG(picture, gotFile);
  WritePNG(DrawDifference(picture, ReadPNG(best.baseline)), differenceFile);
  for (const std::string& sentence : best.broken)
    std::cout << "  " << sentence << "\n";
  std::cout << "  got         " << gotFile.string() << "\n  difference  " << differenceFile.string()
            << "  (8 times)\n  baseline    " << best.baseline.string()
            << "\n  If the new picture is right: " << UpdateCommand(arguments.baseline) << "\n";
  return EXIT_FAILURE;
}

template <typename Get>
int Check(int argc, char* argv[], const PictureLimits& limits, const Get& getPicture)
{
  try
  {
    const Arguments arguments = ReadArguments(argc, argv);
    const RGBPicture picture = getPicture();
    if (arguments.record)
      return Record(picture, arguments.output / arguments.baseline.filename());
    return Compare(picture, arguments, limits);
  }
  catch (const std::exception& error)
  {
    std::cout << "render test: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}

} // namespace

int CheckPicture(vtkRenderWindow* window, int argc, char* argv[], const PictureLimits& limits)
{
  return Check(argc, argv, limits, [window] { return GrabWindow(window); });
}

int CheckPicture(const RGBPicture& picture, int argc, char* argv[], const PictureLimits& limits)
{
  return Check(argc, argv, limits, [&picture] { return picture; });
}

} // namespace hasp
