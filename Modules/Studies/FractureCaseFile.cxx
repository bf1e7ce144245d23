#include "Studies/FractureCaseFile.h"

#include "Planning/DurableFile.h"
#include "Planning/StrictJson.h"
#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr const char* Subject = "fracture case";
constexpr const char* Format = "fracture-case/1";
constexpr const char* Axes = "LPS (DICOM patient)";
constexpr const char* Convention =
  "x_fractured = displacement_4x4 * x_anatomical; a plan assigns each fragment a 4x4 applied to "
  "fractured-scan coordinates; truth = reduction_4x4_truth = inverse(displacement_4x4)";
constexpr std::size_t MostText = 16U << 20U;
constexpr std::uint64_t MostCount = 1ULL << 53U;

Json MatrixOf(const RigidPose& pose)
{
  const glm::dmat3 turn = glm::mat3_cast(pose.orientation);
  Json rows = Json::array();
  for (int r = 0; r < 3; ++r)
    rows.push_back({ turn[0][r], turn[1][r], turn[2][r], pose.position[r] });
  rows.push_back({ 0.0, 0.0, 0.0, 1.0 });
  return rows;
}

/// Rows of four numbers.
RigidPose ReadPose(const StrictJson& object, const char* key)
{
  const Json& rows = object.List(key, 4);
  glm::dmat3 turn(0.0);
  RigidPose pose;
  if (rows.size() != 4)
    object.Fail(key, "must be four rows of four numbers");
  for (int r = 0; r < 4; ++r)
  {
    if (!rows[r].is_array() || rows[r].size() != 4)
      object.Fail(key, "must be four rows of four numbers");
    for (int c = 0; c < 4; ++c)
    {
      if (!rows[r][c].is_number())
        object.Fail(key, "must be four rows of four numbers");
      const double value = rows[r][c].get<double>();
      if (r == 3 && value != (c == 3 ? 1.0 : 0.0))
        object.Fail(key, "must have 0 0 0 1 as its last row");
      if (r < 3 && c < 3)
        turn[c][r] = value;
      else if (r < 3)
        pose.position[r] = value;
    }
  }
  const glm::dmat3 square = glm::transpose(turn) * turn;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(square[c][r] - (c == r ? 1.0 : 0.0)) <= 1e-6))
        object.Fail(key, "must be a rotation and a shift within 1e-6: no scale, no shear");
  if (glm::determinant(turn) < 0.0)
    object.Fail(key, "mirrors: a piece of bone cannot; is one axis the other way round?");
  pose.orientation = glm::normalize(glm::quat_cast(turn));
  return pose;
}

/// Both on the corners of the grid.
double FarthestApart(const RigidPose& pose, const RigidPose& other, const GridGeometry& grid)
{
  double most = 0.0;
  for (int c = 0; c < 8; ++c)
  {
    const glm::dvec3 corner =
      grid.IndexToWorld(glm::dvec3(grid.dims - 1) * glm::dvec3(c & 1, c >> 1 & 1, c >> 2));
    most = std::max(most, glm::distance(pose.Place(corner), other.Place(corner)));
  }
  return most;
}

Json ToJsonOf(const FractureCaseCut& cut)
{
  Json surfaces = Json::array();
  for (const FractureCaseSurface& surface : cut.surfaces)
  {
    Json bands = Json::array();
    for (const glm::dvec2& band : surface.bandsMm)
      bands.push_back({ band.x, band.y });
    surfaces.push_back({ { "point", ToJson(surface.point) }, { "normal", ToJson(surface.normal) },
      { "seed", surface.seed }, { "bands_mm", std::move(bands) },
      { "rms_height_mm", surface.rmsHeightMm }, { "sign", surface.sign > 0.0 ? 1 : -1 } });
  }
  return { { "new_label", cut.newLabel }, { "parent", cut.parent },
    { "surfaces", std::move(surfaces) } };
}

FractureCaseCut ReadCut(const Json& json, const std::string& name)
{
  const StrictJson read(json, Subject, name, { "new_label", "parent", "surfaces" });
  FractureCaseCut cut;
  cut.newLabel = static_cast<Label>(read.Count("new_label", 1, MaxLabel));
  cut.parent = static_cast<Label>(read.Count("parent", 1, MaxLabel));
  for (const Json& value : read.List("surfaces", 100))
  {
    const StrictJson surface(value, Subject, name + "." + ListKey("surfaces", cut.surfaces.size()),
      { "point", "normal", "seed", "bands_mm", "rms_height_mm", "sign" });
    FractureCaseSurface& s = cut.surfaces.emplace_back();
    s.point = surface.Vector("point");
    s.normal = surface.Vector("normal");
    s.seed = surface.Count("seed", 0, MostCount);
    for (const Json& band : surface.List("bands_mm", 100))
    {
      if (!band.is_array() || band.size() != 2 || !band[0].is_number() || !band[1].is_number())
        surface.Fail("bands_mm", "must be pairs of numbers: wavelength in mm, height");
      s.bandsMm.push_back({ band[0].get<double>(), band[1].get<double>() });
    }
    s.rmsHeightMm = surface.Number("rms_height_mm");
    s.sign = surface.Number("sign");
  }
  return cut;
}

Json ToJsonOf(const FractureCaseFragment& fragment)
{
  const RigidPose& pose = fragment.anatomicalToFractured;
  const double shift =
    glm::distance(pose.Place(fragment.centroidAnatomicalMm), fragment.centroidAnatomicalMm);
  return { { "label", fragment.label }, { "name", fragment.name },
    { "voxels_anatomical", fragment.voxelsAnatomical },
    { "voxels_fractured", fragment.voxelsFractured }, { "volume_mm3", fragment.volumeMm3 },
    { "centroid_anatomical_mm", ToJson(fragment.centroidAnatomicalMm) },
    { "displacement_4x4", MatrixOf(pose) }, { "reduction_4x4_truth", MatrixOf(pose.Inverse()) },
    { "displacement_rotation_deg", glm::degrees(glm::length(RotationVector(pose.orientation))) },
    { "displacement_of_centroid_mm", shift },
    { "start_error_mm", { { "mean", fragment.startMeanMm }, { "max", fragment.startMostMm } } } };
}

FractureCaseFragment ReadFragment(
  const Json& json, const std::string& name, const GridGeometry& grid)
{
  const StrictJson read(json, Subject, name,
    { "label", "name", "voxels_anatomical", "voxels_fractured", "volume_mm3",
      "centroid_anatomical_mm", "displacement_4x4", "reduction_4x4_truth",
      "displacement_rotation_deg", "displacement_of_centroid_mm", "start_error_mm" });
  FractureCaseFragment fragment;
  fragment.label = static_cast<Label>(read.Count("label", 1, MaxLabel));
  fragment.name = read.Text("name");
  fragment.voxelsAnatomical = read.Count("voxels_anatomical", 0, MostCount);
  fragment.voxelsFractured = read.Count("voxels_fractured", 0, MostCount);
  fragment.volumeMm3 = read.Number("volume_mm3");
  fragment.centroidAnatomicalMm = read.Vector("centroid_anatomical_mm");
  fragment.anatomicalToFractured = ReadPose(read, "displacement_4x4");
  const RigidPose back = ReadPose(read, "reduction_4x4_truth");
  if (!(FarthestApart(back * fragment.anatomicalToFractured, {}, grid) <= 1e-4))
    read.Fail("reduction_4x4_truth", "is not the inverse of displacement_4x4 within 1e-4 mm");
  for (const char* derived : { "displacement_rotation_deg", "displacement_of_centroid_mm" })
    read.Number(derived); // of the matrix, for readers
  const StrictJson start(
    read.Get("start_error_mm"), Subject, name + ".start_error_mm", { "mean", "max" });
  fragment.startMeanMm = start.Number("mean");
  fragment.startMostMm = start.Number("max");
  return fragment;
}

Json ToJsonOf(const FractureCaseDamage& damage)
{
  return { { "crack_mm", damage.crackMm }, { "eroded_mm", damage.erodedMm },
    { "lost_chips", damage.lostChips }, { "chip_mm", damage.chipMm },
    { "noise_hu", damage.noiseHU }, { "blur_mm", ToJson(damage.blurMm) },
    { "cone_beam", damage.coneBeam }, { "seed", damage.seed } };
}

FractureCaseDamage ReadDamage(const Json& json)
{
  const StrictJson read(json, Subject, "damage",
    { "crack_mm", "eroded_mm", "lost_chips", "chip_mm", "noise_hu", "blur_mm", "cone_beam",
      "seed" });
  return { true, read.Number("crack_mm"), read.Number("eroded_mm"),
    static_cast<std::uint32_t>(read.Count("lost_chips", 0, 10000)), read.Number("chip_mm"),
    read.Number("noise_hu"), read.Vector("blur_mm"), read.Flag("cone_beam"),
    read.Count("seed", 0, MostCount) };
}

GridGeometry ReadGrid(const StrictJson& file)
{
  GridGeometry grid;
  grid.spacing = file.Vector("spacing_mm");
  grid.origin = file.Vector("origin_mm");
  const std::vector<std::uint32_t> dims = file.Counts("dims_xyz", 1, 65535);
  if (dims.size() != 3)
    file.Fail("dims_xyz", "must be three numbers");
  grid.dims = { dims[0], dims[1], dims[2] };
  if (file.Has("axes_xyz"))
  {
    const std::vector<glm::dvec3> axes = file.Vectors("axes_xyz", 3);
    if (axes.size() != 3)
      file.Fail("axes_xyz", "must be three directions");
    grid.direction = { axes[0], axes[1], axes[2] };
  }
  grid.Validate();
  return grid;
}

Json LandmarksToJson(const std::vector<FractureCaseLandmark>& landmarks)
{
  Json json = Json::object();
  for (const FractureCaseLandmark& landmark : landmarks)
    json[landmark.name] = { { "label", landmark.label },
      { "anatomical_mm", ToJson(landmark.anatomicalMm) },
      { "fractured_mm", ToJson(landmark.fracturedMm) } };
  return json;
}

std::vector<FractureCaseLandmark> ReadLandmarks(const StrictJson& file)
{
  const Json& json = file.Get("landmarks");
  if (!json.is_object() || json.size() > 10000)
    file.Fail("landmarks", "must be an object of at most 10000 entries");
  std::vector<FractureCaseLandmark> landmarks;
  for (const auto& [name, value] : json.items()) // names are the file's words: errors say numbers
  {
    const StrictJson read(value, Subject, ListKey("landmarks", landmarks.size()),
      { "label", "anatomical_mm", "fractured_mm" });
    landmarks.push_back({ name, static_cast<Label>(read.Count("label", 1, MaxLabel)),
      read.Vector("anatomical_mm"), read.Vector("fractured_mm") });
  }
  return landmarks;
}

void CheckHeader(const StrictJson& file)
{
  if (file.Text("format") != Format)
    file.Fail("format", std::string("must be ") + Format);
  if (file.Text("units") != "mm")
    file.Fail("units", "must be mm");
  if (!file.Text("axes").starts_with("LPS"))
    file.Fail("axes", "must be LPS");
  file.Text("convention");
}

FractureCaseTruth CaseFromJson(const Json& json)
{
  const StrictJson file(json, Subject, "",
    { "format", "case", "units", "axes", "spacing_mm", "origin_mm", "dims_xyz", "axes_xyz",
      "fixed_labels", "convention", "cuts", "fragments", "landmarks", "residual_overlap_voxels",
      "damage" });
  CheckHeader(file);
  FractureCaseTruth truth;
  truth.name = file.Text("case");
  truth.geometry = ReadGrid(file);
  for (const std::uint32_t label : file.Counts("fixed_labels", 1, MaxLabel))
    truth.fixed.push_back(static_cast<Label>(label));
  for (const Json& cut : file.List("cuts"))
    truth.cuts.push_back(ReadCut(cut, ListKey("cuts", truth.cuts.size())));
  for (const Json& fragment : file.List("fragments"))
    truth.fragments.push_back(
      ReadFragment(fragment, ListKey("fragments", truth.fragments.size()), truth.geometry));
  if (file.Has("landmarks"))
    truth.landmarks = ReadLandmarks(file);
  if (file.Has("damage"))
    truth.damage = ReadDamage(file.Get("damage"));
  ValidateFractureCase(truth);
  return truth;
}

} // namespace

std::string FormatFractureCase(const FractureCaseTruth& truth)
{
  ValidateFractureCase(truth);
  const GridGeometry& grid = truth.geometry;
  Json json = { { "format", Format }, { "case", truth.name }, { "units", "mm" }, { "axes", Axes },
    { "spacing_mm", ToJson(grid.spacing) }, { "origin_mm", ToJson(grid.origin) },
    { "dims_xyz", { grid.dims.x, grid.dims.y, grid.dims.z } } };
  if (!(grid.direction == glm::dmat3(1.0)))
    json["axes_xyz"] = { ToJson(grid.direction[0]), ToJson(grid.direction[1]),
      ToJson(grid.direction[2]) };
  json["fixed_labels"] = truth.fixed;
  json["convention"] = Convention;
  for (const char* list : { "cuts", "fragments" })
    json[list] = Json::array();
  for (const FractureCaseCut& cut : truth.cuts)
    json["cuts"].push_back(ToJsonOf(cut));
  for (const FractureCaseFragment& fragment : truth.fragments)
    json["fragments"].push_back(ToJsonOf(fragment));
  json["landmarks"] = LandmarksToJson(truth.landmarks);
  if (truth.damage.known)
    json["damage"] = ToJsonOf(truth.damage);
  return FormatJson(json, Subject);
}

FractureCaseTruth ParseFractureCase(const std::string& text)
{
  return ReadJson(text, Subject, CaseFromJson);
}

void WriteFractureCase(const std::filesystem::path& folder, const FractureCaseTruth& truth)
{
  WriteDurably(
    folder / FractureCaseFiles::Truth, FormatFractureCase(truth), FractureCaseFiles::Truth);
}

FractureCaseTruth ReadFractureCase(const std::filesystem::path& folder)
{
  return ParseFractureCase(
    ReadWhole(folder / FractureCaseFiles::Truth, MostText, FractureCaseFiles::Truth));
}

} // namespace hasp
