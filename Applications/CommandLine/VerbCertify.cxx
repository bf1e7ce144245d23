#include "CertificatePage.h"
#include "Failure.h"
#include "Files.h"
#include "GuideClaims.h"
#include "ImplantClaims.h"
#include "PartCertificate.h"
#include "PlateClaims.h"
#include "RecipePart.h"
#include "Session.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspSurfaceFile.h"
#include "vtkHaspVolumeView.h"

#include "Planning/PartRecipeFile.h"

#include <CLI/CLI.hpp>

#include <glm/geometric.hpp>

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace hasp
{
namespace
{

struct CertifyOptions
{
  std::string part, recipe, html;
  VolumeChoices bone;
  std::vector<double> axis; ///< none, or L, P, S
  double leastShare = 0.95;
};

PartClaims ClaimsOfGuide(const GuideRecipe& recipe, const CertifyOptions& options)
{
  std::optional<glm::dvec3> axis;
  if (!options.axis.empty())
    axis = glm::dvec3(options.axis[0], options.axis[1], options.axis[2]);
  if (axis && !(glm::length(*axis) > 0.0))
    throw Failure(ExitCode::WrongUse, "--insertion-axis must not be 0, 0, 0");
  if (!axis && recipe.axisSearchDeg > 0.0)
    throw Failure(ExitCode::WrongUse,
      "the recipe searches its insertion axis: give the one that `hasp guide --json` names, with "
      "--insertion-axis");
  return ClaimsOf(recipe, options.leastShare, axis);
}

/// Where a plate's screws, or an implant's axis and holes, are the recipe does not say: they are
/// laid on the bone again.
PartClaims ClaimsOfRecipe(
  const PartRecipe& recipe, vtkImageData* bone, const CertifyOptions& options)
{
  if (const auto* guide = std::get_if<GuideRecipe>(&recipe))
    return ClaimsOfGuide(*guide, options);
  if (!options.axis.empty())
    throw Failure(ExitCode::WrongUse, "--insertion-axis is for guides");
  return Try(ExitCode::BadInput, "",
    [&]
    {
      if (const auto* plate = std::get_if<PlateRecipe>(&recipe))
        return ClaimsOf(*plate, FindScrewAxes(ViewImage(bone), *plate), options.leastShare);
      const auto& implant = std::get<ImplantRecipe>(recipe);
      const PlacedImplant placed = PlaceImplant(ViewImage(bone), implant);
      return ClaimsOf(implant, placed.axis, placed.holes);
    });
}

void Run(const CertifyOptions& options, Session& session)
{
  if (!IsSurfaceName(options.part))
    throw Failure(ExitCode::WrongUse, "PART must be a surface: .stl, .3mf, .ply, .obj or .vtp");
  if (!options.html.empty())
    RequireWritable(options.html, { ".html" });
  std::optional<PartRecipe> recipe;
  if (options.recipe.empty())
    SayWarning(session, "without --recipe there is no gap, slot or hole to hold the part to");
  else
    recipe = ReadRecipeFile(options.recipe, ReadPartRecipe);
  const PrintedPart part = ReadPart(options.part, session);
  const LoadedVolume bone = ReadVolume(options.bone, session);
  SayWarnings(bone.passport, session);
  const PartClaims claims = recipe ? ClaimsOfRecipe(*recipe, bone.image, options) : PartClaims();
  const FitCertificate certificate = CertifyPart(part, bone.image, claims, session);
  WriteCertificatePage(part.mesh, bone.image, certificate,
    { options.html, options.part, options.recipe, {} }, session);
  if (!certificate.Holds())
    throw Faulty(certificate, "the part does not hold");
}

} // namespace

void AddCertifyVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<CertifyOptions>();
  CLI::App* verb =
    app.add_subcommand("certify", "Measure a part as it was written, and hold it to its recipe");
  verb->add_option("PART", options->part, "The surface, as it will be printed")->required();
  verb->add_option("--bone", options->bone.input, "The volume: a file, or a folder of slices")
    ->required();
  AddSeriesOptions(*verb, options->bone);
  verb->add_option("--recipe", options->recipe, "The .json file that says what the part must be");
  verb
    ->add_option("--insertion-axis", options->axis,
      "The direction it lifts off along, L,P,S: of a recipe that searches it")
    ->delimiter(',')
    ->expected(3)
    ->needs("--recipe");
  AddLeastShare(*verb, options->leastShare)->needs("--recipe");
  verb->add_option("--html", options->html,
    "Write the certificate, with pictures, to this .html file, whether it holds or not");
  AddCommonOptions(*verb, session);
  verb->footer(
    "Measured on the file alone: closed, 2-manifold, self-intersections, pieces, walls, gap to "
    "the\n"
    "bone, slots, holes, and whether it can be put on along its axis. In inches, centimetres or\n"
    "metres, mirrored or in RAS it is told so. Without --recipe the mesh alone is measured.\n"
    "Example: hasp certify guide.stl --bone head.mha --recipe guide.json --json\n"
    "Exit codes: 0 it holds (without --recipe: its mesh is sound), 1 wrong use, 2 bad input,\n"
    "3 it does not hold, or its file says so.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
