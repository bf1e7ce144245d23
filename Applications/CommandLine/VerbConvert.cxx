#include "Conversion.h"
#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspSurfaceFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

namespace hasp
{
namespace
{

constexpr const char* VolumeEndings = ".mha, .vti, .nrrd, .nii, .nii.gz, .seg.nrrd";
constexpr const char* SurfaceEndings = ".stl, .3mf, .ply, .obj";

bool EndsLike(const std::string& path, std::initializer_list<const char*> endings)
{
  std::string name = std::filesystem::path(path).filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(
    endings.begin(), endings.end(), [&](const char* ending) { return name.ends_with(ending); });
}

void RefuseOneForBoth(const ConvertOptions& options)
{
  std::error_code ignored; // where there is no OUT yet
  if (std::filesystem::equivalent(options.volume.input, options.output, ignored))
    throw Failure(ExitCode::WrongUse, "IN and OUT are the same; give OUT another name");
}

void Run(const ConvertOptions& options, Session& session)
{
  RefuseOneForBoth(options);
  RefuseCells(options.volume.input, "volume and no triangles");
  if (IsCellFileName(options.output))
    throw Failure(
      ExitCode::WrongUse, "active cells are for one isovalue: hasp cells makes them of a volume");
  const OutputKind kind = KindOfOutput(options.output);
  const bool surface = IsSurfaceName(options.volume.input);
  if (kind == OutputKind::Unknown)
    throw Failure(
      ExitCode::WrongUse, std::string("OUT has an ending that nothing is written for; known are ") +
                            VolumeEndings + " for volumes, " + SurfaceEndings +
                            " for surfaces; without an ending it is a folder of DICOM slices");
  if (!surface && kind == OutputKind::Surface)
    throw Failure(ExitCode::WrongUse,
      "a volume has no surface until an isovalue is chosen: hasp render draws one, hasp guide "
      "makes a guide for one; convert keeps volumes volumes");
  if (surface && kind != OutputKind::Surface)
    throw Failure(ExitCode::WrongUse,
      std::string("a surface is no volume; give OUT one of the endings ") + SurfaceEndings);
  if (kind == OutputKind::Slices)
    RequireWritableFolder(options.output);
  else
    RequireWritable(options.output, {});
  if (surface)
    ConvertSurface(options, session);
  else
    ConvertVolume(options, kind, session);
  session.result["output"] =
    kind == OutputKind::Slices && !session.showNames ? "the folder" : FileLabel(options.output);
}

} // namespace

OutputKind KindOfOutput(const std::string& path)
{
  const std::filesystem::path name(path);
  std::error_code ignored;
  if (!name.has_filename() || !name.has_extension() || std::filesystem::is_directory(name, ignored))
    return OutputKind::Slices;
  if (EndsLike(path, { ".seg.nrrd" }))
    return OutputKind::Segmentation;
  if (EndsLike(path, { ".mha", ".vti", ".nrrd", ".nii", ".nii.gz" }))
    return OutputKind::Volume;
  return EndsLike(path, { ".stl", ".3mf", ".ply", ".obj" }) ? OutputKind::Surface
                                                            : OutputKind::Unknown;
}

void AddConvertVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* verb = app.add_subcommand(
    "convert", "Write a volume or surface in another format, read back and compared");
  AddVolumeOptions(*verb, options->volume);
  verb->get_option("IN")->description("Volume or surface: a file, or a folder of slices");
  verb
    ->add_option("OUT", options->output,
      std::string("Its ending decides: ") + VolumeEndings + ", " + SurfaceEndings +
        "; without one a folder of DICOM slices, new or empty")
    ->required();
  verb->add_option("--modality", options->modality, "Of DICOM slices, if IN does not say it")
    ->check(CLI::IsMember({ "CT", "MR", "OT" }));
  verb->add_flag(
    "--hounsfield", options->hounsfield, "The values are HU of a CT; IN cannot say it");
  verb->add_flag("--quantise", options->quantise,
    "DICOM slices may round samples that are no whole numbers; says by how much");
  AddCommonOptions(*verb, session);
  verb->footer("The written file is read back and compared sample by sample, and every place "
               "within 0.0001 mm; what\ndiffers is not kept. DICOM slices hold nothing of the "
               "patient but the image.\nExamples:\n"
               "  hasp convert slices/ head.nrrd\n"
               "  hasp convert head.mha slices --hounsfield\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 what was written differs.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
