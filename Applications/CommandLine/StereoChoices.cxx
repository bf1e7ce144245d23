#include "StereoChoices.h"

#include "Failure.h"
#include "LensFile.h"
#include "Session.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

constexpr double LeastScreenMm = 50.0, MostScreenMm = 1e5;
constexpr double MostTangent = 10.0;

std::vector<std::string> Layouts()
{
  std::vector<std::string> names;
  for (int layout = 0; layout <= int(StereoLayout::QuadBuffer); ++layout)
    names.push_back(StereoLayoutName(StereoLayout(layout)));
  names.push_back(StereoChoices::OpenXR);
  return names;
}

void AddOutputOptions(CLI::App& verb, StereoChoices& choices)
{
  verb
    .add_option("--stereo", choices.layout,
      "How two eyes become one picture: side-by-side, top-bottom, anaglyph, interlaced (the top "
      "row "
      "is the left eye's), checkerboard, left, right, dual-window, quad-buffer; openxr: a "
      "head-mounted display by "
      "VTK's own window; mono draws one eye")
    ->check(CLI::IsMember(Layouts()))
    ->capture_default_str();
  verb
    .add_option("--eye-resolution", choices.resolution,
      "Of each eye; half: two eyes share the pixels of one, as many displays want it")
    ->check(CLI::IsMember({ "full", "half" }))
    ->capture_default_str();
  verb.add_option("--mirror", choices.mirror, "For a display seen in a mirror: what it turns over")
    ->check(CLI::IsMember({ "none", "horizontal", "vertical", "both" }))
    ->capture_default_str();
  verb.add_flag("--swap-eyes", choices.swapEyes, "Each eye takes the other's pixels");
  verb.add_option("--lens", choices.lens,
    ".json file of a lens before each eye: the picture is pre-distorted for it");
}

void AddRoomOptions(CLI::App& verb, StereoChoices& choices)
{
  CLI::Option* screen = verb.add_option("--screen", choices.screen,
    "WIDTHxHEIGHT of the screen in mm, say 520x320: the picture is right for eyes before it. "
    "The screen stands where the camera looks at, and fills its view");
  CLI::Option* hmd =
    verb
      .add_option("--hmd", choices.hmd,
        "left,right,up,down: tangents of what the left eye sees in a head-mounted display; the "
        "right eye's are its mirror image")
      ->delimiter(',')
      ->excludes(screen);
  verb
    .add_option("--eye-angle", choices.eyeAngle,
      "Degrees between the eyes seen from the middle, where no screen is given")
    ->check(Within(0.0, 90.0))
    ->default_str("2")
    ->excludes(screen)
    ->excludes(hmd);
  verb
    .add_option("--eye-separation", choices.eyeSeparationMm,
      "mm between the eyes, before a screen; adults: 54 to 74; 0: both see the same")
    ->check(Within(0.0, 200.0))
    ->default_str("63");
  verb
    .add_option("--head-position", choices.headMm,
      "x,y,z mm of the middle between the eyes, from the middle of the screen: right, up, towards "
      "the viewer")
    ->delimiter(',')
    ->default_str("0,0,600");
  verb
    .add_flag("--life-size", choices.lifeSize,
      "A mm of the patient is a mm on the screen; else --zoom says what fills it")
    ->excludes(verb.get_option("--zoom"));
  verb
    .add_option("--sketch", choices.sketch,
      ".png file: a plan of screen, eyes and content, to hold against the desk")
    ->needs(screen);
}

MirrorFlip FlipOf(const std::string& name)
{
  return name == "horizontal" ? MirrorFlip::Horizontal
         : name == "vertical" ? MirrorFlip::Vertical
         : name == "both"     ? MirrorFlip::Both
                              : MirrorFlip::None;
}

StereoHmd HmdOf(const std::array<double, 4>& tangents)
{
  const FieldOfView left{ tangents[0], tangents[1], tangents[2], tangents[3] };
  return { { left, { left.right, left.left, left.up, left.down } } };
}

/// What would be left out without a word.
void RequireFitting(const StereoChoices& choices)
{
  const StereoLayout layout = StereoLayoutFromName(choices.layout);
  const auto refuse = [](const std::string& text) { throw Failure(ExitCode::WrongUse, text); };
  if (!choices.InRoom() && (choices.eyeSeparationMm || choices.headMm || choices.lifeSize))
    refuse(
      "--eye-separation, --head-position and --life-size are mm before a screen; give --screen "
      "or --hmd too");
  if (!choices.InRoom() && !choices.lens.empty())
    refuse("--lens is for a display whose shape is known; give --hmd or --screen too");
  if (layout == StereoLayout::Mono &&
      (choices.eyeAngle || choices.eyeSeparationMm || choices.hmd || choices.swapEyes))
    refuse(
      "--eye-angle, --eye-separation, --hmd and --swap-eyes are for two eyes; give --stereo too");
  if (const double mm = choices.eyeSeparationMm.value_or(63.0); mm > 0.0 && mm < 10.0)
    refuse("--eye-separation must be 0 or from 10 to 200 mm; adults have 54 to 74");
  if (choices.hmd && std::any_of(choices.hmd->begin(), choices.hmd->end(),
                       [](double tangent) { return std::abs(tangent) > MostTangent; }))
    refuse("--hmd must be tangents, at most 10 (84 degrees): 1 is 45 degrees");
  if (choices.swapEyes && (layout == StereoLayout::Left || layout == StereoLayout::Right))
    refuse("--swap-eyes is for two eyes; --stereo left and right draw one");
  if (choices.resolution == "half" && layout != StereoLayout::SideBySide &&
      layout != StereoLayout::TopBottom && layout != StereoLayout::Interlaced &&
      layout != StereoLayout::Checkerboard)
    refuse("--eye-resolution half is for --stereo side-by-side, top-bottom, interlaced and "
           "checkerboard, where two eyes share pixels");
}

} // namespace

bool StereoChoices::InRoom() const
{
  return !this->screen.empty() || this->hmd;
}

bool StereoChoices::Placed() const
{
  return this->mirror != "none" || !this->lens.empty() || this->InRoom();
}

bool StereoChoices::Any() const
{
  return this->layout != "mono" || this->Placed();
}

void AddStereoOptions(CLI::App& verb, StereoChoices& choices)
{
  AddOutputOptions(verb, choices);
  AddRoomOptions(verb, choices);
}

StereoWindow MakeStereoWindow(const StereoChoices& choices)
{
  RequireFitting(choices);
  StereoWindow window;
  window.output = { StereoLayoutFromName(choices.layout),
    choices.resolution == "half" ? StereoResolution::Half : StereoResolution::Full,
    FlipOf(choices.mirror), choices.swapEyes };
  if (!choices.lens.empty())
    try
    {
      window.lens = ReadLens(choices.lens);
    }
    catch (const std::exception& error)
    {
      throw Failure(ExitCode::BadInput, std::string("--lens: ") + error.what());
    }
  if (choices.hmd)
    window.hmd = HmdOf(*choices.hmd);
  if (!choices.screen.empty())
  {
    const auto size = ScreenSize(choices.screen);
    window.screen.emplace();
    window.screen->widthMm = size[0];
    window.screen->heightMm = size[1];
  }
  try
  {
    ValidateStereoWindow(window);
    ViewsOfEyes(window, RoomHead(choices), glm::dmat4(1.0));
  }
  catch (const std::invalid_argument& error)
  {
    if (window.screen || window.hmd) // else there are no eyes in the room
      throw Failure(ExitCode::WrongUse, error.what());
  }
  return window;
}

StereoHead RoomHead(const StereoChoices& choices)
{
  StereoHead head;
  const auto at = choices.headMm.value_or(std::array{ 0.0, 0.0, 600.0 });
  head.position = { at[0], at[1], at[2] };
  head.eyeSeparationMm = choices.eyeSeparationMm.value_or(63.0);
  return head;
}

std::array<double, 2> ScreenSize(const std::string& text)
{
  const auto times = text.find('x');
  std::array<double, 2> size{};
  const auto read = [&](std::size_t first, std::size_t end, double& value)
  {
    const auto [stop, error] = std::from_chars(text.data() + first, text.data() + end, value);
    return error == std::errc() && stop == text.data() + end && value >= LeastScreenMm &&
           value <= MostScreenMm;
  };
  if (times == text.npos || !read(0, times, size[0]) || !read(times + 1, text.size(), size[1]))
    throw Failure(ExitCode::WrongUse, "--screen must be WIDTHxHEIGHT in mm, each from 50 to "
                                      "100000, say 520x320: measure what lights up");
  return size;
}

double EyeAspect(const StereoWindow& window, std::array<int, 2> view)
{
  return window.screen ? window.screen->widthMm / window.screen->heightMm
                       : double(view[0]) / view[1];
}

std::array<int, 2> WindowPixels(
  const StereoWindow& window, std::array<int, 2> view, bool squarePixels)
{
  constexpr int most = 16384; // of what OpenGL draws to, on most machines
  if (window.screen && squarePixels)
    view[0] = std::max(1L, std::lround(view[1] * window.screen->widthMm / window.screen->heightMm));
  const glm::ivec2 size = ComposedSize(window.output, { view[0], view[1] });
  if (std::max(size.x, size.y) > most)
    throw Failure(ExitCode::WrongUse, "two eyes make a picture of " + std::to_string(size.x) +
                                        " x " + std::to_string(size.y) + " pixels, at most " +
                                        std::to_string(most) + " go; give a smaller --resolution");
  return { size.x, size.y };
}

} // namespace hasp
