#include "PassportText.h"

#include "vtkHaspVolumeFile.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

template <typename Vector>
Json Three(const Vector& v)
{
  return { v.x, v.y, v.z };
}

template <typename Vector>
std::string ThreeText(const Vector& v, const char* between)
{
  std::ostringstream text;
  text << v.x << between << v.y << between << v.z;
  return text.str();
}

Json Rows(const glm::dmat3& direction)
{
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row)
    rows.push_back({ direction[0][row], direction[1][row], direction[2][row] });
  return rows;
}

} // namespace

std::string PassportText(const Passport& passport)
{
  const GridGeometry& grid = passport.geometry;
  const glm::dvec3 size = glm::dvec3(grid.dims) * grid.spacing;
  std::ostringstream text;
  text << "format      " << passport.format;
  if (!passport.compression.empty())
    text << ", " << passport.compression;
  text << "\nmodality    " << (passport.modality.empty() ? "not said" : passport.modality)
       << "\nsamples     " << ThreeText(grid.dims, " x ") << ", " << passport.sampleType
       << "\nspacing     " << ThreeText(grid.spacing, " x ") << " mm"
       << "\nsize        " << ThreeText(size, " x ") << " mm"
       << "\norigin      " << ThreeText(grid.origin, ", ") << " mm (patient LPS)";
  for (int axis = 0; axis < 3; ++axis)
    text << "\n"
         << "ijk"[axis] << " axis      " << ThreeText(grid.direction[axis], ", ");
  text << "\nvalues      " << passport.minimum << " to " << passport.maximum
       << (passport.hounsfield ? " HU" : " (not HU)");
  if (passport.seriesFound > 1)
    text << "\nseries      " << passport.seriesChosen << " of " << passport.seriesFound;
  if (passport.filesSkipped > 0)
    text << "\nskipped     " << passport.filesSkipped << " files that are no images";
  if (passport.gapDeviationMm > 0.0)
    text << "\nslice gaps  differ from the spacing by up to " << passport.gapDeviationMm << " mm";
  for (const std::string& warning : passport.warnings)
    text << "\nwarning     " << warning;
  text << "\n";
  return text.str();
}

Json PassportJson(const Passport& passport)
{
  return { { "format", passport.format }, { "modality", passport.modality },
    { "dims", Three(passport.geometry.dims) }, { "spacing_mm", Three(passport.geometry.spacing) },
    { "origin_mm", Three(passport.geometry.origin) },
    { "direction_rows", Rows(passport.geometry.direction) }, { "sample_type", passport.sampleType },
    { "minimum", passport.minimum }, { "maximum", passport.maximum },
    { "hounsfield", passport.hounsfield }, { "series_found", passport.seriesFound },
    { "series_chosen", passport.seriesChosen }, { "files_skipped", passport.filesSkipped },
    { "gap_deviation_mm", passport.gapDeviationMm }, { "compression", passport.compression },
    { "warnings", passport.warnings } };
}

} // namespace hasp
