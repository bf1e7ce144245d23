#ifndef ImplantClaims_h
#define ImplantClaims_h

#include "Evaluation/PartClaims.h"
#include "Grid/GridView.h"
#include "vtkHaspFiltersSurgicalGuideModule.h" // for export macro

#include <span>   // for the holes
#include <vector> // for those found

namespace hasp
{

struct ImplantRecipe;

/// Where an implant comes to lie.
struct PlacedImplant
{
  glm::dvec3 axis;               ///< unit, out of the head
  std::vector<glm::dvec3> holes; ///< places on their axes, world mm
};

/// What a recipe does not say: how its implant lies on a scan; no mesh is made. Throws as
/// vtkHaspImplantFilter reports. Any thread; all cores; most of an implant's time.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PlacedImplant PlaceImplant(
  const AnyGridView& scan, const ImplantRecipe& recipe);

/// What an implant of vtkHaspImplantFilter promises, for CertifyFit (Evaluation/FitCertificate.h)
/// to hold its file to. Free of VTK.
///
/// axis   that it was made with, unit, out of the head: it is put in against it without meeting
///        bone (the filter's field data "Axis")
/// holes  a place on the axis of each of its holes ("Holes"); they are 0.1 mm true
/// Walls: as thick as the recipe says, less half its spacing (a contour bevels an edge by less); at
/// holes as thick as what is between them, or between them and the edge, where that is less. The
/// hole in the skull is not claimed as a gap: along an irregular edge an implant may have more
/// clearance than asked for. Throws std::invalid_argument as ValidateImplantRecipe does. Any
/// thread.
VTKHASPFILTERSSURGICALGUIDE_EXPORT PartClaims ClaimsOf(
  const ImplantRecipe& recipe, const glm::dvec3& axis, std::span<const glm::dvec3> holes);

} // namespace hasp

#endif
