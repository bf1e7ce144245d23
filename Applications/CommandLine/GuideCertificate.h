#pragma once
#include "Evaluation/GuideGap.h"
#include "Evaluation/MeshCheck.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace hasp
{

struct GuideRecipe;

/// What is measured on a guide as it stands in its STL file.
struct GuideCertificate
{
  MeshCheck mesh;
  std::optional<std::size_t> selfIntersections; ///< none: not measured (see FaultsOf)
  GuideGap gap;
  double gapAskedMm = 0.0;
  double toleranceMm = 0.2; ///< of the gap
};

/// Reads the STL back, welds it and measures it against the bone of the volume. Throws
/// std::runtime_error if the file cannot be read; whatever the measurements throw.
GuideCertificate CertifyGuide(
  const std::string& stl, vtkImageData* volume, const GuideRecipe& recipe);

/// Why the guide must not be used, one sentence each; empty: it holds. The mesh must be closed,
/// 2-manifold, outward, of one piece, without degenerate triangles and self-intersections; at least
/// `leastShare` of the inner wall must lie within the tolerance of the gap asked for, and no
/// wall may touch bone. A build without CGAL cannot look for self-intersections: that is a fault
/// too.
std::vector<std::string> FaultsOf(const GuideCertificate& certificate, double leastShare);

/// A line a figure.
std::string CertificateText(const GuideCertificate& certificate);
nlohmann::ordered_json CertificateJson(const GuideCertificate& certificate);

} // namespace hasp
