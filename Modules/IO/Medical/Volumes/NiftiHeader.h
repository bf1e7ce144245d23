#pragma once
#include "Grid/GridGeometry.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace hasp
{

/// The fields of a NIfTI-1 or NIfTI-2 header that matter for volumes, as its specifications
/// (nifti1.h, nifti2.h) name them; all others are neither read nor set.
struct NiftiHeader
{
  int version = 1; ///< 1: 348 bytes, float32; 2: 540 bytes, double
  bool bigEndian = false;
  bool singleFile = true; ///< samples follow in the same file (magic "n+1", "n+2")
  std::int64_t dim[8] = {};
  int datatype = 0;
  int bitpix = 0;
  double pixdim[8] = {};
  double voxOffset = 0.0;
  double slope = 0.0, intercept = 0.0;
  int qformCode = 0, sformCode = 0;
  double quatern[3] = {};
  double qoffset[3] = {};
  double srow[12] = {};
  int units = 0; ///< xyzt_units
};

/// Index to world: columns are index steps, RAS, in the header's unit.
struct NiftiAffine
{
  glm::dmat3 matrix{ 1.0 };
  glm::dvec3 shift{ 0.0 };
};

constexpr std::size_t NiftiHeaderBytes[] = { 0, 348, 540 }; ///< by version

/// 1 or 2 by the first bytes; 0 if they are of no NIfTI header.
int NiftiVersion(std::string_view start);

/// From at least NiftiHeaderBytes of the version, of either byte order.
NiftiHeader DecodeNiftiHeader(std::string_view bytes);

/// Little-endian, with the four bytes that say "no extension": the samples come next, and
/// voxOffset is set so. For version 1 values are rounded to float32.
std::string EncodeNiftiHeader(const NiftiHeader& header);

NiftiAffine SformOf(const NiftiHeader& header);
/// As the specification has it: rotation by the quaternion, times pixdim, third axis times qfac.
NiftiAffine QformOf(const NiftiHeader& header);

/// Sizes, qform and sform (both "scanner") in mm for a geometry. A quaternion whose real part is
/// near 0 loses three digits in float32, and LPS is a half turn from RAS, where it is 0. So rows
/// and slices may have to be stored turned: then the real part is at least 1/2.
NiftiHeader NiftiFor(const GridGeometry& geometry, bool& flipX, bool& flipY);

} // namespace hasp
