#include "Failure.h"
#include "Files.h"
#include "RenderScene.h"
#include "SceneChoices.h"
#include "Session.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace hasp
{
namespace
{

struct Choices
{
  SceneChoices scene;
  std::string output;
  RenderOptions render;
};

/// Two windows and a driver's buffers are no file.
void RequireOnePicture(const StereoChoices& stereo)
{
  const auto is = [&](StereoLayout layout) { return stereo.layout == StereoLayoutName(layout); };
  if (stereo.layout == StereoChoices::OpenXR || is(StereoLayout::DualWindow) ||
      is(StereoLayout::QuadBuffer))
    throw Failure(ExitCode::WrongUse,
      "--stereo " + stereo.layout + " is for hasp view; left and right draw one eye each");
}

void Run(Choices choices, Session& session)
{
  RequireWritable(choices.output, { ".png" });
  const std::string& sketch = choices.render.stereo.sketch;
  if (!sketch.empty())
  {
    RequireWritable(sketch, { ".png" });
    RequireDifferent(sketch, choices.output, "--sketch and --output");
  }
  RequireOnePicture(choices.render.stereo);
  MakeStereoWindow(choices.render.stereo); // before anything is read
  const LoadedScene loaded = ReadScene(choices.scene, choices.render, session);
  RenderScene scene(loaded.input, choices.render, session);
  const std::string picture = scene.DrawPng();
  const std::string plan = sketch.empty() ? "" : scene.SketchPng(); // both, or nothing
  WriteFile(choices.output, picture);
  session.result["output"] = FileLabel(choices.output);
  if (!sketch.empty())
    WriteFile(sketch, plan);
}

} // namespace

void AddRenderVerb(CLI::App& app, Session& session)
{
  auto choices = std::make_shared<Choices>();
  CLI::App* verb =
    app.add_subcommand("render", "Draw an isosurface, the brightest values or skin and bone of a "
                                 "volume, or active cells, into a PNG file");
  AddSceneOptions(*verb, choices->scene, choices->render);
  verb->add_option("--output", choices->output, "The .png file; its folder must exist")->required();
  AddStereoOptions(*verb, choices->render.stereo);
  AddCommonOptions(*verb, session);
  verb->footer("Examples:\n"
               "  hasp render head.mha --isovalue 226 --output head.png\n"
               "  hasp render head.mha --isovalue 226 --view right --surface guide.stl \\\n"
               "       --stereo side-by-side --resolution 960,1080 --output pair.png\n"
               "  hasp render head.mha --isovalue 226 --stereo anaglyph --screen 520x320 \\\n"
               "       --life-size --sketch desk.png --output head.png\n"
               "  hasp render head.mha --isovalue 226 --output head.png --explain\n"
               "  hasp render head.hcells --output head.png\n"
               "  hasp render head.mha --mapper mip --window 0,2000 --output brightest.png\n"
               "  hasp render head.mha --mapper composite --output skin-and-bone.png\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 4 cannot draw.");
  verb->callback(
    [&session, choices, verb]
    {
      choices->render.squarePixels = verb->count("--resolution") == 0;
      session.run = [&session, choices] { Run(*choices, session); };
    });
}

} // namespace hasp
