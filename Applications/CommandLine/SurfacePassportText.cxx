#include "SurfacePassportText.h"

#include "Evaluation/MeshCheck.h"
#include "vtkHaspSurfaceFile.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

std::string Three(const glm::dvec3& v, const char* between)
{
  std::ostringstream text;
  text << v.x << between << v.y << between << v.z;
  return text.str();
}

const char* YesNo(bool yes)
{
  return yes ? "yes" : "no";
}

} // namespace

std::string SurfacePassportText(const SurfacePassport& passport, const MeshCheck& mesh)
{
  std::ostringstream text;
  text << "format      " << passport.format << ", " << passport.encoding << "\nspace       "
       << (passport.space.empty() ? "not said, LPS is taken" : passport.space) << "\ntriangles   "
       << passport.triangles << ", " << passport.degenerate << " without an area\npoints      "
       << passport.points << ", " << passport.coordinateType << "\nsize        "
       << Three(passport.maximum - passport.minimum, " x ") << " mm\nfrom        "
       << Three(passport.minimum, ", ") << " mm (patient LPS)\nto          "
       << Three(passport.maximum, ", ") << " mm\nclosed      " << YesNo(mesh.Closed());
  if (!mesh.Closed())
    text << ", " << mesh.borderEdges << " edges at holes";
  text << "\n2-manifold  " << YesNo(mesh.TwoManifold()) << "\noutward     " << YesNo(mesh.Outward())
       << "\npieces      " << mesh.pieces << "\narea        " << mesh.areaMm2 << " mm2";
  if (mesh.Closed())
    text << "\nvolume      " << mesh.volumeMm3 << " mm3";
  if (passport.cutPolygons > 0)
    text << "\ncut         " << passport.cutPolygons << " faces of more than three corners";
  if (!passport.label.name.empty())
    text << "\npart        " << passport.label.name;
  if (!passport.label.hash.empty())
    text << "\nmade from   " << passport.label.hash;
  for (const SurfacePiece& piece : passport.pieces)
    text << "\nobject      " << piece.name << ", " << piece.triangles << " triangles";
  for (const std::string& warning : passport.warnings)
    text << "\nwarning     " << warning;
  text << "\n";
  return text.str();
}

Json SurfacePassportJson(const SurfacePassport& passport, const MeshCheck& mesh)
{
  const auto three = [](const glm::dvec3& v) { return Json{ v.x, v.y, v.z }; };
  Json json{ { "format", passport.format }, { "encoding", passport.encoding }, { "space", nullptr },
    { "coordinate_type", passport.coordinateType }, { "points", passport.points },
    { "triangles", passport.triangles }, { "cut_polygons", passport.cutPolygons },
    { "degenerate", passport.degenerate }, { "minimum_mm", three(passport.minimum) },
    { "maximum_mm", three(passport.maximum) }, { "closed", mesh.Closed() },
    { "border_edges", mesh.borderEdges }, { "manifold", mesh.TwoManifold() },
    { "outward", mesh.Outward() }, { "pieces", mesh.pieces }, { "area_mm2", mesh.areaMm2 },
    { "volume_mm3", nullptr }, { "warnings", passport.warnings } };
  if (!passport.space.empty())
    json["space"] = passport.space;
  if (mesh.Closed())
    json["volume_mm3"] = mesh.volumeMm3;
  json["part"] = { { "name", passport.label.name }, { "hash", passport.label.hash },
    { "does_not_hold", passport.label.doesNotHold } };
  json["objects"] = Json::array();
  for (const SurfacePiece& piece : passport.pieces)
    json["objects"].push_back({ { "name", piece.name }, { "triangles", piece.triangles } });
  return json;
}

} // namespace hasp
