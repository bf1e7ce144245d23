#include "Failure.h"
#include "Files.h"
#include "HeadChoices.h"
#include "PictureFile.h"
#include "SceneChecks.h"
#include "SecondWindow.h"
#include "Session.h"
#include "StereoView.h"
#include "Verbs.h"
#include "ViewKeys.h"
#include "ViewWindow.h"
#include "VtkMessages.h"
#include "Windows.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOpenXR.h"

#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace hasp
{
namespace
{

struct Choices
{
  SceneChoices scene;
  SceneOptions options;
  StereoChoices stereo;
  HeadChoices head;
  bool squarePixels = true; ///< the window's width follows the screen's, where there is one
  bool fullScreen = false;
  std::optional<std::array<int, 2>> rightAt; ///< of the right eye's window of two, on the desktop
  std::string output;
};

ViewSettings SettingsOf(const LoadedScene& loaded, const SceneOptions& options)
{
  ViewSettings settings;
  settings.isoValue = options.isoValue;
  settings.camera = options.camera;
  if (options.drawing.mapper == "mip")
    settings.shown = "brightest values, " + WindowText(options.drawing.look);
  else if (loaded.passport)
  {
    settings.range = { loaded.passport->minimum, loaded.passport->maximum };
    settings.unit = loaded.passport->hounsfield ? "HU" : "";
  }
  return settings;
}

/// What does not go together, before anything is read.
void RequireFitting(const Choices& choices)
{
  const auto refuse = [](const std::string& text) { throw Failure(ExitCode::WrongUse, text); };
  if (!choices.head.source.empty() && !choices.stereo.InRoom())
    refuse("--head is where the head is before a screen; give --screen or --hmd too");
  if (!choices.head.source.empty() && !choices.output.empty())
    refuse("--output draws one picture; it waits for no head: leave out --head");
  const auto is = [&](StereoLayout l) { return choices.stereo.layout == StereoLayoutName(l); };
  const bool two = is(StereoLayout::DualWindow);
  if (!choices.output.empty() && (two || is(StereoLayout::QuadBuffer)))
    refuse("--output writes one picture, and --stereo " + choices.stereo.layout +
           " makes two; left and right draw one eye each");
  if (choices.rightAt && !two)
    refuse("--right-window-at is for --stereo dual-window");
  if (choices.fullScreen && two)
    refuse("--full-screen covers one screen; give --resolution and --right-window-at for two");
}

void OpenWindow(const Choices& choices, const StereoWindow& eyes, vtkRenderWindow* window)
{
  const auto size = WindowPixels(eyes, choices.options.resolution, choices.squarePixels);
  window->SetWindowName("hasp view"); // no name of a file: it may be a patient's
  window->SetSize(size[0], size[1]);
  window->SetFullScreen(choices.fullScreen);
  if (choices.rightAt)
  {
    window->BordersOff();
    window->SetPosition(0, 0);
  }
  if (eyes.output.layout == StereoLayout::QuadBuffer)
    window->StereoCapableWindowOn(); // before it opens
}

/// In VTK's window for a head-mounted display, which has eyes and a head of its own.
void RunOpenXR(Choices& choices, Session& session)
{
  if (const std::string lack = WhyNoOpenXR(); !lack.empty())
    throw Failure(ExitCode::CannotDraw, "--stereo openxr: " + lack);
  if (choices.stereo.Placed() || !choices.head.source.empty() || !choices.output.empty())
    throw Failure(ExitCode::WrongUse,
      "--stereo openxr has its own: leave out --screen, --hmd, --lens, --mirror, --head, --output");
  const LoadedScene loaded = ReadScene(choices.scene, choices.options, session);
  const OpenXRView view = MakeOpenXRView();
  view.interactor->Initialize();
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw in a head-mounted display");
  const SurfaceScene scene(view.renderer, loaded.input, choices.options, session);
  session.progress.Wipe();
  view.interactor->Start();
  ThrowVtkError(ExitCode::CannotDraw, "cannot draw in a head-mounted display");
  scene.ListResources(session.resources);
}

/// Until the window closes. What was recorded is written even where the drawing failed.
void RunRecorded(
  ViewWindow& view, const HeadChoices& head, const HeadRecorder& recorder, Session& session)
{
  try
  {
    view.Run();
  }
  catch (const Failure&)
  {
    try
    {
      WriteRecording(head, recorder, session);
    }
    catch (const Failure& second)
    {
      SayWarning(session, second.what());
    }
    throw;
  }
  WriteRecording(head, recorder, session);
}

void Run(Choices choices, Session& session)
{
  if (choices.options.light.eyesApart = choices.stereo.Any();
      choices.stereo.layout == StereoChoices::OpenXR)
    return RunOpenXR(choices, session);
  for (const std::string& file : { choices.output, choices.stereo.sketch })
    if (!file.empty())
      RequireWritable(file, { ".png" });
  if (!choices.output.empty() && !choices.stereo.sketch.empty())
    RequireDifferent(choices.stereo.sketch, choices.output, "--sketch and --output");
  RequireRecordable(choices.head);
  RequireFitting(choices);
  const StereoWindow shown = MakeStereoWindow(choices.stereo);
  if (choices.stereo.Any())
    choices.options.camera.aspect = EyeAspect(shown, choices.options.resolution);
  HeadPose rest;
  rest.position = RoomHead(choices.stereo).position;
  auto tracker = MakeHeadTracker(choices.head, rest);
  HeadRecorder recorder;
  if (!choices.head.record.empty())
    tracker->RecordTo(&recorder);
  RequireDisplay();
  const LoadedScene loaded = ReadScene(choices.scene, choices.options, session);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  OpenWindow(choices, shown, window);
  window->AddRenderer(renderer);
  interactor->SetRenderWindow(window);
  interactor->Initialize(); // first: VTK 9.1 crashes at the end where the window opened the display
  RequireOpenGL(window);
  SurfaceScene scene(renderer, loaded.input, choices.options, session);
  std::optional<SecondWindow> second;
  if (shown.output.layout == StereoLayout::DualWindow)
    second.emplace(
      interactor, std::array{ window->GetSize()[0], window->GetSize()[1] }, choices.rightAt);
  std::unique_ptr<StereoView> eyes;
  if (choices.stereo.Any())
    eyes = std::make_unique<StereoView>(
      renderer, window, choices.stereo, std::move(tracker), second ? second->Window() : nullptr);
  ViewSettings settings = SettingsOf(loaded, choices.options);
  settings.eyes = eyes.get();
  settings.overlay = !shown.hmd;
  if (second)
  {
    settings.closed = [&second] { second->Close(); };
    second->OnPointer([&](bool right) { eyes->PointIn(right ? second->Window() : window.Get()); });
  }
  settings.sayWarning = [&session](const std::string& text) { SayWarning(session, text); };
  ViewWindow view(scene, window, interactor, settings);
  if (!choices.stereo.sketch.empty())
    WriteFile(choices.stereo.sketch, eyes->SketchPng(scene.Content()));
  session.progress.Wipe();
  if (choices.output.empty())
    RunRecorded(view, choices.head, recorder, session);
  else
  {
    session.progress.Step("drawing");
    scene.SetFrameProgress([&session](double share) { session.progress.Share(share); });
    WriteFile(choices.output, PngFile(view.DrawComplete()));
    session.result["output"] = FileLabel(choices.output);
  }
  for (const ResourceUse& use : view.Resources())
    session.resources.push_back(use);
  if (choices.options.drawing.mapper == "mip")
    session.result["window"] = choices.options.drawing.look.window;
  else
    session.result["isovalue"] = view.IsoValue();
}

} // namespace

void AddViewVerb(CLI::App& app, Session& session)
{
  auto choices = std::make_shared<Choices>();
  SurfaceDrawing& drawing = choices->options.drawing;
  drawing.interactive = true;
  if (std::ranges::count(SurfaceMappers(), "raycaching") > 0)
    drawing.mapper = "raycaching"; // an isovalue that changes all the time
  CLI::App* verb =
    app.add_subcommand("view", "Show a volume in a window, with a slider for its isovalue");
  AddSceneOptions(*verb, choices->scene, choices->options);
  verb->add_option("--output", choices->output,
    "Wait for no one: write the window as a .png file when it is complete, and end");
  AddStereoOptions(*verb, choices->stereo);
  AddHeadOptions(*verb, choices->head);
  verb->add_flag("--full-screen", choices->fullScreen,
    "All of the screen: interlaced and checkerboard displays need each pixel in its place");
  verb
    ->add_option("--right-window-at", choices->rightAt,
      "X,Y on the desktop of the right eye's window of dual-window; both are without borders then, "
      "the left eye's at 0,0")
    ->delimiter(',');
  AddCommonOptions(*verb, session);
  verb->footer(ViewKeys() + "\n"
                            "Examples:\n"
                            "  hasp view head.mha\n"
                            "  hasp view head.mha --ambient-occlusion 25 --surface guide.stl\n"
                            "  hasp view head.mha --stereo interlaced --screen 520x292 "
                            "--full-screen --head opentrack\n"
                            "  hasp view head.mha --stereo anaglyph --screen 520x320 --head mouse\n"
                            "  hasp view head.mha --output window.png\n"
                            "It needs a display; hasp render draws pictures without.\n"
                            "Exit codes: 0 done, 1 wrong use, 2 bad input, 4 cannot draw.");
  verb->callback(
    [&session, choices, verb]
    {
      choices->squarePixels = verb->count("--resolution") == 0;
      ChooseMapperForLight(choices->options, verb->count("--mapper") > 0);
      session.run = [&session, choices] { Run(*choices, session); };
    });
}

} // namespace hasp
