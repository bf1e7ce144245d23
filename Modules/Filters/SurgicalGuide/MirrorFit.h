#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Planning/ImplantRecipe.h"

#include <cstdint>
#include <span>

namespace hasp
{

/// The plane at which bone is most like its own mirror image.
///
/// keep   one byte a sample of `ct`: bone is value >= isovalue, there
/// Method: places on the bone's surface, from distances on a grid of 2 mm, are mirrored, and their
/// distance to that surface is made least in squares (Gauss and Newton, three unknowns), from the
/// plane through their middle across the patient's left, and from four more, turned by 17 degrees;
/// the one of the least median wins. Places over three times the median off, and over 1 mm, do not
/// count: a hole has no counterpart, a jaw may stand aside. Heads turned by up to 25 degrees are
/// found; on the phantom's, with its hole, noise and a jaw aside, within 0.2 mm and 0.2 degrees.
/// Throws std::runtime_error if less than half of the places come to lie within 2 mm of bone; std::
/// invalid_argument and Cancelled as Coverage. Any thread; all cores; some seconds.
MirrorPlane FitMirrorPlane(const AnyGridView& ct, double isovalue,
  std::span<const std::uint8_t> keep, const ProgressFunction& progress = {});

/// A place's mirror image.
glm::dvec3 Mirrored(const MirrorPlane& plane, const glm::dvec3& point);

} // namespace hasp
