#include "Volumes/IndexSteps.h"
#include "Volumes/NiftiHeader.h"
#include "Volumes/SampleFile.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

// NIfTI-1 and -2 in a single file, plain or gzipped. Its space is RAS; x and y are turned to LPS.
// What holds is what holds for nibabel: the sform if its code is above 0, then the qform, then
// pixdim alone. But a skewed sform gives way to a sound qform, and where neither is there nibabel
// turns x and puts the volume's centre at the origin, for which there is no ground.
namespace hasp
{
namespace
{

NiftiHeader ReadHeader(const std::filesystem::path& file, bool zipped)
{
  SampleFile whole;
  whole.header = whole.data = file;
  whole.zipped = zipped;
  SampleStream stream(whole);
  std::string bytes(4, '\0');
  std::error_code error;
  if (!zipped && std::filesystem::file_size(file, error) < NiftiHeaderBytes[1])
    ThrowFileError(file, "is too short for a NIfTI header; copy it again");
  stream.Read(bytes.data(), bytes.size());
  const int version = NiftiVersion(bytes);
  if (version == 0)
    ThrowFileError(file, "is no NIfTI-1 or NIfTI-2 file: its first number is neither 348 nor 540");
  bytes.resize(NiftiHeaderBytes[version]);
  stream.Read(bytes.data() + 4, bytes.size() - 4);
  const NiftiHeader header = DecodeNiftiHeader(bytes);
  if (!header.singleFile)
    ThrowFileError(file, "is one of a pair (.hdr and .img) or an Analyze file; save it as a single "
                         ".nii file");
  return header;
}

StoredType TypeOf(const std::filesystem::path& file, const NiftiHeader& header)
{
  static const std::map<int, StoredType> types{ { 2, StoredType::UInt8 }, { 4, StoredType::Int16 },
    { 8, StoredType::Int32 }, { 16, StoredType::Float32 }, { 64, StoredType::Float64 },
    { 256, StoredType::Int8 }, { 512, StoredType::UInt16 }, { 768, StoredType::UInt32 },
    { 1024, StoredType::Int64 }, { 1280, StoredType::UInt64 } };
  const auto found = types.find(header.datatype);
  if (found == types.end())
    ThrowFileError(file, "datatype is " + std::to_string(header.datatype) +
                           "; whole numbers of 8 to 64 bits, float32 and float64 are read: "
                           "colours, complex and long numbers are not");
  if (header.bitpix != int(8 * BytesOf(found->second)))
    ThrowFileError(file, "datatype " + std::to_string(header.datatype) + " has " +
                           std::to_string(8 * BytesOf(found->second)) + " bits, bitpix says " +
                           std::to_string(header.bitpix) + ": the header is damaged");
  return found->second;
}

SampleFile SamplesOf(const std::filesystem::path& file, const NiftiHeader& h, bool zipped)
{
  SampleFile samples;
  samples.header = samples.data = file;
  samples.zipped = zipped;
  samples.bigEndian = h.bigEndian;
  samples.type = TypeOf(file, h);
  if (h.dim[0] < 3 || h.dim[0] > 7)
    ThrowFileError(file, "dim[0] is " + std::to_string(h.dim[0]) +
                           ", must be 3, or 4 with one "
                           "volume");
  for (int a = 4; a <= h.dim[0]; ++a)
    if (h.dim[a] > 1)
      ThrowFileError(file, "holds " + std::to_string(h.dim[a]) +
                             " volumes or components, must hold 1; save one of them");
  std::copy(h.dim + 1, h.dim + 4, samples.size);
  const double least = double(NiftiHeaderBytes[h.version]);
  if (!(h.voxOffset >= least && h.voxOffset <= 1e15) || h.voxOffset != std::floor(h.voxOffset))
    ThrowFileError(file, "vox_offset is " + Text(h.voxOffset) + ", must be a whole number from " +
                           Text(least) + " on");
  (zipped ? samples.skip : samples.offset) = static_cast<std::uint64_t>(h.voxOffset);
  if (std::isnan(h.slope) || h.slope == 0.0) // the specification's and nibabel's "not scaled"
    return samples;
  if (!std::isfinite(h.slope) || !std::isfinite(h.intercept))
    ThrowFileError(file, "scl_slope and scl_inter must be finite");
  samples.slope = h.slope;
  samples.intercept = h.intercept;
  return samples;
}

double MillimetresPerUnit(
  const std::filesystem::path& file, const NiftiHeader& h, Passport& passport)
{
  switch (h.units & 7)
  {
    case 1:
      return 1000.0;
    case 2:
      return 1.0;
    case 3:
      return 0.001;
    case 0:
      passport.warnings.push_back("The file says no unit of length; it is taken as mm.");
      return 1.0;
    default:
      ThrowFileError(file, "its unit of length is none of m, mm and micrometre");
  }
}

/// Largest distance of a corner between two affines, in the header's unit.
double Disagreement(const NiftiHeader& h, const NiftiAffine& a, const NiftiAffine& b)
{
  double worst = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    glm::dvec3 at(0.0);
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = corner & (1 << axis) ? double(h.dim[1 + axis] - 1) : 0.0;
    const double apart = glm::length((a.matrix - b.matrix) * at + a.shift - b.shift);
    if (!(apart <= worst)) // NaN counts
      worst = apart;
  }
  return worst;
}

NiftiAffine ChooseAffine(
  const std::filesystem::path& file, const NiftiHeader& h, double unit, Passport& passport)
{
  const NiftiAffine sform = SformOf(h), qform = QformOf(h);
  const auto skewed = [](const NiftiAffine& form)
  { return !(SkewDegrees(form.matrix) <= SkewLimitDegrees); };
  const bool sized = h.pixdim[1] > 0.0 && h.pixdim[2] > 0.0 && h.pixdim[3] > 0.0;
  if (h.sformCode > 0 && h.qformCode > 0)
  {
    if (skewed(sform) && sized && !skewed(qform))
    {
      passport.warnings.push_back("The file's sform has axes " + Text(SkewDegrees(sform.matrix)) +
                                  " degrees off right angles; its qform is taken instead.");
      return qform;
    }
    const double apart = unit * Disagreement(h, sform, qform);
    if (!(apart <= 1e-3))
      passport.warnings.push_back("The file's sform and qform place the volume up to " +
                                  Text(apart) + " mm apart; the sform is taken.");
    return sform;
  }
  if (h.sformCode > 0)
    return sform;
  if (!sized)
    ThrowFileError(file, "pixdim holds a spacing that is not > 0; a spacing is never guessed");
  if (h.qformCode > 0)
    return qform;
  passport.warnings.push_back("The file does not say how it lies in the patient (sform and qform "
                              "codes are 0): axes are taken as right, anterior and superior. Check "
                              "left and right.");
  NiftiAffine plain;
  for (int a = 0; a < 3; ++a)
    plain.matrix[a][a] = h.pixdim[1 + a];
  return plain;
}

} // namespace

OpenedVolume OpenNifti(const std::filesystem::path& file, const VolumeReadSettings& settings)
{
  char start[2] = {};
  std::ifstream(file, std::ios::binary).read(start, 2);
  const bool zipped = start[0] == '\x1f' && start[1] == '\x8b'; // whatever the name says
  const NiftiHeader h = ReadHeader(file, zipped);
  OpenedVolume opened;
  Passport& passport = opened.passport;
  SampleFile samples = SamplesOf(file, h, zipped);
  CheckSamples(samples, settings, passport);
  const double unit = MillimetresPerUnit(file, h, passport);
  const NiftiAffine affine = ChooseAffine(file, h, unit, passport);
  const glm::dvec3 toLps(-unit, -unit, unit);
  glm::dmat3 steps;
  for (int a = 0; a < 3; ++a)
  {
    passport.geometry.dims[a] = static_cast<int>(h.dim[1 + a]);
    steps[a] = affine.matrix[a] * toLps;
  }
  passport.geometry.origin = affine.shift * toLps;
  SetIndexSteps(file, steps, passport.geometry);
  passport.format = h.version == 1 ? "NIfTI-1" : "NIfTI-2";
  passport.compression = zipped ? "gzip" : "";
  opened.samples = std::make_shared<const SampleFile>(samples);
  opened.load = [samples, geometry = passport.geometry](const ProgressFunction& progress, Passport&)
  { return LoadSamples(samples, geometry, progress); };
  return opened;
}

} // namespace hasp
