// A picture of the whole window for each step, of the phantom's plan with all its parts.
//
//   TestPlannerLooks --make FOLDER        the plan that the pictures are of; takes a minute or two
//   TestPlannerLooks STEP FOLDER --baseline FILE --output FOLDER [--record]
#include "../../CommandLine/Testing/HaspProcess.h"
#include "../../CommandLine/Testing/TestScreen.h"
#include "HaspRenderTest.h"
#include "PlannerProcess.h"

#include <QFontInfo>
#include <QGuiApplication>

#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>

namespace
{

namespace fs = std::filesystem;

constexpr const char* Font =
  "DejaVu Sans";                // that baselines are made with: Debian's fonts-dejavu-core
constexpr double LongS = 600.0; // for parts, while others build

/// What a step's picture is of.
struct Look
{
  std::optional<int> object{}; ///< chosen in the list
  const char* from = "alt+1";  ///< keys: where the 3D view is seen from
};
const std::map<std::string, Look> Looks{ { "import", {} }, { "split", {} },
  { "reduce", { 6, "alt+1" } }, { "cut", { 3, "alt+shift+3" } }, { "guide", { 8, "alt+shift+3" } },
  { "plate", { 9, "alt+shift+3" } }, { "check", { 8, "alt+shift+3" } }, { "export", {} } };

/// Qt's own, whatever the desktop of who runs this has.
void ForgetDesktop()
{
  for (const char* name : { "QT_STYLE_OVERRIDE", "QT_QPA_PLATFORMTHEME", "QT_SCALE_FACTOR",
         "QT_FONT_DPI", "QT_SCREEN_SCALE_FACTORS", "QT_AUTO_SCREEN_SCALE_FACTOR" })
    unsetenv(name);
}

bool HasFont(int argc, char* argv[])
{
  setenv("QT_QPA_PLATFORM", "offscreen", 1); // of this process alone
  const QGuiApplication application(argc, argv);
  return QFontInfo(QGuiApplication::font()).family() == Font;
}

std::string Scan(const fs::path& folder)
{
  return (folder / "head.mha").string();
}
std::string Plan(const fs::path& folder)
{
  return (folder / "case.hasp").string();
}

/// On a home of its own: tests run side by side.
PlannerProcess Open(const TestScreen& screen, const fs::path& folder, const std::string& home)
{
  fs::remove_all(folder / home);
  return PlannerProcess(
    { screen.Display(), folder / home, { Plan(folder), Scan(folder), "--language", "en" }, LongS });
}

void Run(const std::vector<std::string>& words)
{
  const HaspRun run = RunHasp(words);
  if (run.exitCode != 0)
    throw std::runtime_error(run.err);
}

int Make(const TestScreen& screen, const fs::path& folder)
{
  fs::remove_all(folder);
  fs::create_directories(folder);
  Run({ "phantom", "--spacing", "1,1,1", "--quiet", "--output", Scan(folder) });
  Run({ "plan", Plan(folder), "--new" });
  Run({ "plan", Plan(folder), "--apply", HASP_PLAN_EDITS });
  PlannerProcess planner = Open(screen, folder, "home");
  planner.Click("step.check");
  planner.Click("check.makeall");
  planner.Key("ctrl+s");
  const bool saved = planner.State("message") == "Saved.";
  planner.CloseWindow();
  return planner.ExitCode() == 0 && saved ? EXIT_SUCCESS : EXIT_FAILURE;
}

hasp::RGBPicture PictureOf(const QImage& image)
{
  hasp::RGBPicture picture(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
    {
      const QRgb pixel = image.pixel(x, y);
      std::uint8_t* to = picture.At(x, image.height() - 1 - y);
      to[0] = qRed(pixel);
      to[1] = qGreen(pixel);
      to[2] = qBlue(pixel);
    }
  return picture;
}

int Judge(const TestScreen& screen, const fs::path& folder, int argc, char* argv[])
{
  const std::string step = argv[1];
  const Look look = Looks.at(step);
  PlannerProcess planner = Open(screen, folder, "home-" + step);
  planner.Click("message.close");
  planner.Click("step." + step);
  if (look.object)
    planner.ClickId("objects", *look.object);
  if (step == "check")
    planner.ClickRow("check.table", 3);       // the guide's certificate
  planner.ClickAt("view.coronal", 0.4, 0.86); // the jaw, in all slices
  planner.ClickAt("view.axial", 0.385, 0.22);
  planner.Key(look.from);
  planner.Hand().Move(640, 795); // beside all that lights up below the pointer
  planner.WaitSettled();
  return hasp::CheckPicture(PictureOf(planner.Hand().Picture()), argc, argv);
}

} // namespace

int main(int argc, char* argv[])
try
{
  ForgetDesktop();
  if (!HasFont(argc, argv))
  {
    std::cout << "skipped: the window's font is not " << Font
              << ", which the baselines are made with: install fonts-dejavu-core\n";
    return EXIT_SUCCESS;
  }
  const TestScreen screen({}, "1280x800");
  if (screen.Display().empty())
  {
    std::cout << "skipped: Xvfb is not installed\n";
    return EXIT_SUCCESS;
  }
  if (argc == 3 && std::string(argv[1]) == "--make")
    return Make(screen, argv[2]);
  if (argc < 3 || !Looks.contains(argv[1]))
    throw std::invalid_argument("usage: TestPlannerLooks STEP FOLDER --baseline FILE …");
  return Judge(screen, argv[2], argc, argv);
}
catch (const std::exception& error)
{
  std::cerr << "TestPlannerLooks: " << error.what() << "\n";
  return EXIT_FAILURE;
}
