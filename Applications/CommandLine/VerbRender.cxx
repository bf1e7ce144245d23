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
  std::string stereo = "mono";
  RenderOptions render;
};

void Run(Choices choices, Session& session)
{
  RequireWritable(choices.output, { ".png" });
  const LoadedScene loaded = ReadScene(choices.scene, choices.render, session);
  RenderScene scene(loaded.input, choices.render, session);
  WriteFile(choices.output, scene.DrawPng());
  session.result["output"] = FileLabel(choices.output);
}

void AddStereoOptions(CLI::App& verb, Choices& choices)
{
  verb
    .add_option("--stereo", choices.stereo,
      "mono, side-by-side, top-bottom, left, right or anaglyph; two eyes make the picture twice "
      "as wide or high")
    ->check(CLI::IsMember({ "mono", "side-by-side", "top-bottom", "left", "right", "anaglyph" }))
    ->capture_default_str();
  verb
    .add_option(
      "--eye-angle", choices.render.eyeAngle, "Degrees between the eyes, seen from the middle")
    ->check(Within(0.0, 90.0))
    ->capture_default_str();
}

} // namespace

void AddRenderVerb(CLI::App& app, Session& session)
{
  auto choices = std::make_shared<Choices>();
  CLI::App* verb = app.add_subcommand(
    "render", "Draw an isosurface of a volume, or active cells, into a PNG file");
  AddSceneOptions(*verb, choices->scene, choices->render);
  verb->add_option("--output", choices->output, "The .png file; its folder must exist")->required();
  AddStereoOptions(*verb, *choices);
  AddCommonOptions(*verb, session);
  verb->footer("Examples:\n"
               "  hasp render head.mha --isovalue 226 --output head.png\n"
               "  hasp render head.mha --isovalue 226 --view right --surface guide.stl \\\n"
               "       --stereo side-by-side --resolution 960,1080 --output pair.png\n"
               "  hasp render head.mha --isovalue 226 --output head.png --explain\n"
               "  hasp render head.hcells --output head.png\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 4 cannot draw.");
  verb->callback(
    [&session, choices]
    {
      choices->render.stereo = StereoLayoutFromName(choices->stereo);
      session.run = [&session, choices] { Run(*choices, session); };
    });
}

} // namespace hasp
