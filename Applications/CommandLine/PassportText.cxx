#include "PassportText.h"

#include "vtkHaspVolumeFile.h"

#include <nlohmann/json.hpp>

#include <cmath>
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

std::string Rounded(double value, double steps)
{
  std::ostringstream text;
  text << std::round(value * steps) / steps;
  return text.str();
}

Json Known(const std::optional<double>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

void PutGeometry(const GridGeometry& grid, std::ostream& text)
{
  const glm::dvec3 size = glm::dvec3(grid.dims) * grid.spacing;
  text << "\nspacing     " << ThreeText(grid.spacing, " x ") << " mm"
       << "\nsize        " << ThreeText(size, " x ") << " mm"
       << "\norigin      " << ThreeText(grid.origin, ", ") << " mm (patient LPS)";
  for (int axis = 0; axis < 3; ++axis)
    text << "\n"
         << "ijk"[axis] << " axis      " << ThreeText(grid.direction[axis] + 0.0, ", ");
}

void PutValues(const Passport& passport, std::ostream& text)
{
  text << "\nvalues      " << passport.minimum << " to " << passport.maximum
       << (passport.hounsfield ? " HU" : " (the file does not say HU)");
  if (passport.airLevel)
    text << ", air at " << Rounded(*passport.airLevel, 1.0);
  if (passport.softTissueLevel)
    text << ", soft tissue at " << Rounded(*passport.softTissueLevel, 1.0);
}

void PutRescale(const std::vector<RescaleRun>& runs, std::ostream& text)
{
  constexpr std::size_t shown = 6;
  for (std::size_t n = 0; n < runs.size() && n < shown; ++n)
  {
    text << "\nrescale     " << runs[n].slope << " x stored + " << runs[n].intercept;
    if (runs.size() > 1)
      text << ", slices " << runs[n].firstSlice << " to " << runs[n].lastSlice;
  }
  if (runs.size() > shown)
    text << "\nrescale     ... " << runs.size() - shown << " more runs of slices: see --json";
}

void PutResampled(const ResampleRecord& r, std::ostream& text)
{
  text << "\nresampled   " << r.slicesMade << " slices made, " << r.slicesCopied << " measured";
  if (r.farthestMm > 0.0)
    text << ", up to " << Rounded(r.farthestMm, 1e3) << " mm apart";
  if (r.tiltDegrees > 0.0)
    text << ", tilt of " << Rounded(r.tiltDegrees, 10.0) << " degrees rectified";
  text << "\nerror       ";
  if (r.errorKnown)
    text << "of surfaces by resampling: " << Rounded(r.error50, 1e3) << " mm (half of them), "
         << Rounded(r.error95, 1e3) << " mm (95 %)";
  else
    text << "of surfaces by resampling: not known, there is nothing to measure it by";
}

/// What only a DICOM series says.
void PutDicom(const Passport& passport, std::ostream& text)
{
  if (!passport.transferSyntax.empty())
    text << "\npixels      " << passport.photometric << ", " << passport.transferSyntax;
  if (passport.lossy)
    text << "\nloss        compressed with loss";
  if (!passport.burnedIn.empty())
    text << "\nburned in   " << passport.burnedIn;
  if (!passport.patientPosition.empty())
    text << "\nposition    " << passport.patientPosition;
  if (passport.thicknessMm)
    text << "\nthickness   " << *passport.thicknessMm << " mm, as the file says";
  if (passport.kvp)
    text << "\ntube        " << *passport.kvp << " kV";
  if (passport.paddingValue)
    text << "\npadding     " << *passport.paddingValue << " outside the picture";
  PutRescale(passport.rescale, text);
  if (passport.tiltDegrees > 0.0 || passport.tiltTagDegrees)
    text << "\ntilt        " << Rounded(passport.tiltDegrees, 100.0) << " degrees measured";
  if (passport.tiltTagDegrees)
    text << ", " << *passport.tiltTagDegrees << " said";
  if (passport.missingSlices + passport.doubledSlices + passport.unevenGaps > 0)
    text << "\nslices      " << passport.missingSlices << " missing, " << passport.doubledSlices
         << " doubled, " << passport.unevenGaps << " uneven gaps";
  if (passport.resampled)
    PutResampled(*passport.resampled, text);
}

Json FaultsJson(const std::vector<ImportFault>& faults)
{
  Json all = Json::array();
  for (const ImportFault& fault : faults)
  {
    Json one{ { "kind", FaultName(fault.kind) }, { "text", fault.text }, { "slices", fault.slices },
      { "files", fault.files }, { "resamplable", fault.resamplable } };
    one["mm"] = fault.millimetres > 0.0 ? Json(fault.millimetres) : Json(nullptr);
    one["degrees"] = fault.degrees > 0.0 ? Json(fault.degrees) : Json(nullptr);
    all.push_back(std::move(one));
  }
  return all;
}

Json RescaleJson(const std::vector<RescaleRun>& runs)
{
  Json all = Json::array();
  for (const RescaleRun& run : runs)
    all.push_back({ { "first_slice", run.firstSlice }, { "last_slice", run.lastSlice },
      { "slope", run.slope }, { "intercept", run.intercept } });
  return all;
}

Json ResampledJson(const ResampleRecord& r)
{
  const std::optional<double> none;
  return { { "tilt_degrees", r.tiltDegrees }, { "farthest_move_mm", r.farthestMove },
    { "slices_measured", r.slicesMeasured }, { "slices_copied", r.slicesCopied },
    { "slices_made", r.slicesMade }, { "slices_filled", r.slicesFilled },
    { "farthest_mm", r.farthestMm }, { "forgiven_mm", r.forgivenMm },
    { "outside_share", r.outsideShare }, { "edges_judged", r.edgesJudged },
    { "error_p50_mm", Known(r.errorKnown ? r.error50 : none) },
    { "error_p95_mm", Known(r.errorKnown ? r.error95 : none) } };
}

} // namespace

std::string PassportText(const Passport& passport)
{
  const GridGeometry& grid = passport.geometry;
  std::ostringstream text;
  text << "format      " << (passport.format.empty() ? "not known" : passport.format);
  if (!passport.compression.empty())
    text << ", " << passport.compression;
  text << "\nmodality    " << (passport.modality.empty() ? "not said" : passport.modality);
  if (grid.dims.x > 0)
  {
    text << "\nsamples     " << ThreeText(grid.dims, " x ") << ", " << passport.sampleType;
    PutGeometry(grid, text);
  }
  if (passport.faults.empty())
    PutValues(passport, text);
  if (passport.seriesFound > 1)
    text << "\nseries      " << passport.seriesChosen << " of " << passport.seriesFound;
  if (passport.filesSkipped > 0)
    text << "\nskipped     " << passport.filesSkipped << " files that are no images";
  if (passport.gapDeviationMm > 0.0)
    text << "\nslice gaps  differ from their mean by up to " << passport.gapDeviationMm << " mm";
  PutDicom(passport, text);
  if (passport.segments > 0)
    text << "\nsegments    " << passport.segments;
  if (!passport.hash.empty())
    text << "\nhash        " << passport.hash;
  for (const std::string& warning : passport.warnings)
    text << "\nwarning     " << warning;
  for (const ImportFault& fault : passport.faults)
    text << "\nfault       " << fault.text << "."
         << (!fault.resamplable ? ""
              : fault.kind == FaultKind::DoubledSlices
                ? " --resample mends it if the pictures are the same."
                : " --resample mends it.");
  text << "\n";
  return text.str();
}

Json PassportJson(const Passport& passport)
{
  const bool whole = passport.faults.empty();
  Json json{ { "format", passport.format }, { "modality", passport.modality },
    { "dims", Three(passport.geometry.dims) }, { "spacing_mm", Three(passport.geometry.spacing) },
    { "origin_mm", Three(passport.geometry.origin) },
    { "direction_rows", Rows(passport.geometry.direction) }, { "sample_type", passport.sampleType },
    { "minimum", whole ? Json(passport.minimum) : Json(nullptr) },
    { "maximum", whole ? Json(passport.maximum) : Json(nullptr) },
    { "hounsfield", passport.hounsfield }, { "air_level", Known(passport.airLevel) },
    { "soft_tissue_level", Known(passport.softTissueLevel) },
    { "series_found", passport.seriesFound }, { "series_chosen", passport.seriesChosen },
    { "files_skipped", passport.filesSkipped }, { "gap_deviation_mm", passport.gapDeviationMm },
    { "compression", passport.compression }, { "photometric", passport.photometric },
    { "transfer_syntax", passport.transferSyntax }, { "burned_in", passport.burnedIn },
    { "lossy", passport.lossy }, { "patient_position", passport.patientPosition },
    { "thickness_mm", Known(passport.thicknessMm) }, { "kvp", Known(passport.kvp) },
    { "padding_value", Known(passport.paddingValue) }, { "rescale", RescaleJson(passport.rescale) },
    { "tilt_degrees", passport.tiltDegrees },
    { "tilt_tag_degrees", Known(passport.tiltTagDegrees) },
    { "missing_slices", passport.missingSlices }, { "doubled_slices", passport.doubledSlices },
    { "uneven_gaps", passport.unevenGaps }, { "warnings", passport.warnings },
    { "segments", passport.segments }, { "faults", FaultsJson(passport.faults) } };
  json["hash"] = passport.hash.empty() ? Json(nullptr) : Json(passport.hash);
  json["resampled"] =
    whole && passport.resampled ? ResampledJson(*passport.resampled) : Json(nullptr);
  return json;
}

} // namespace hasp
