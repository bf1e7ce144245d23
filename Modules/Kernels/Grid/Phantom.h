#pragma once
#include "Grid/AnalyticSolid.h"
#include "Grid/AnalyticVolumes.h"
#include "Grid/Progress.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hasp
{

enum class PhantomAnatomy
{
  Head,         ///< skull, mandible, teeth
  Fibula,       ///< a left fibula alone: the donor bone of a transplant, as a scan of its own
  HeadAndFibula ///< both in one world, the fibula 150 mm to the patient's left
};

/// Bones that are pieces of their own. Teeth stand in their jaw; a joint gap and a gap between the
/// rows of teeth keep the mandible apart from the cranium.
enum class PhantomPart
{
  Cranium,    ///< vault with the defect, orbits, nose, zygomatic arches, maxilla
  UpperTeeth, ///< 13: the left first premolar (24) is missing
  Mandible,   ///< body, rami, coronoid processes, condyles
  LowerTeeth, ///< 13: the right first molar (46) is missing
  Fibula      ///< tapered, three-sided, bowed; 346 mm long
};

/// A model of a cone-beam scanner's faults, not of its physics. Its grey values are not HU.
struct ConeBeamModel
{
  bool on = false;
  double scale = 0.75;   ///< grey = scale * HU' + offset, > 0; HU' is the cupped value
  double offset = 200.0; ///< grey
  double cupping = 0.12; ///< HU' + 1000 is this share lower on the axis than at cupRadiusMm; [0,1)
  double cupRadiusMm = 100.0; ///< > 0
};

/// Metal crowns on a left and a right lower molar (36 and 47), and what they do to a
/// reconstruction: rays that leave each crown, alternately bright and dark, and a dark band between
/// the two. A deterministic pattern of the right shape, not a simulation of beam hardening.
struct MetalModel
{
  bool on = false;
  double crownHU = 8000.0; ///< a 12-bit scanner would show 3071
  double streakHU = 500.0; ///< amplitude of the rays at a crown's edge; >= 0
  double bandHU = 400.0;   ///< depth of the dark band; >= 0
  double decayMm = 25.0;   ///< rays fall to 1/e over this way, > 0
  double sliceMm = 5.0;    ///< rays fall to 1/sqrt(e) this far above and below the crowns, > 0
};

/// A head-like CT with closed-form truth: what stands in for a real scan where none is at hand.
///
/// Skin, skull and brain are ellipsoids around `center` (axes along L, P, S); a skew rounded box
/// through the right frontal bone is the defect. Face, jaws and teeth follow the skull's radii.
/// Every surface belongs to an AnalyticSolid, so distances to it are known (PhantomSolid).
struct PhantomSettings
{
  PhantomAnatomy anatomy = PhantomAnatomy::Head;
  glm::dvec3 center{ 0.0 }; ///< world mm, patient LPS; of the skull, or of a fibula alone
  glm::dvec3 skinRadii{ 76.0, 96.0,
    92.0 };                   ///< mm, half width (L), half length (P), half height (S)
  double scalpMm = 6.0;       ///< skin to outer table, and soft tissue around every bone, > 0
  double skullMm = 7.0;       ///< outer to inner table, > 0
  double skullBaseMm = -70.0; ///< no vault below center + this along S
  bool defect = true;         ///< the hole in the right frontal bone

  double tableMm = 2.0;        ///< compact bone of the cranium, from each surface, > 0
  double jawCortexMm = 2.2;    ///< of the mandible, > 0
  double fibulaCortexMm = 3.5; ///< where it is thinnest: its canal is round; > 0
  double enamelMm = 1.2;       ///< > 0

  double airHU = -1000.0;  ///< outside, in the nose and the throat
  double softHU = 40.0;    ///< skin, brain, orbits, defect
  double boneHU = 1000.0;  ///< compact bone; the 226 HU surface lies within edgeMm of its surface
  double diploeHU = 500.0; ///< between the cranium's tables
  double jawMarrowHU = 300.0;    ///< in the mandible
  double fibulaMarrowHU = -30.0; ///< in the fibula's canal
  double dentineHU = 1700.0;     ///< roots and the cores of crowns
  double enamelHU = 2800.0;

  double edgeMm = 1.0; ///< width of the soft step at each surface where no blur is asked for, > 0
  glm::dvec3 blurMm{ 0.0 }; ///< standard deviations of the scanner's point spread along L, P, S;
                            ///< >= 0. Any > 0 takes the place of edgeMm.
  double sliceMm = 0.0;     ///< slice thickness: a box along S on top of the blur; >= 0
  double noiseHU = 0.0;     ///< standard deviation of added noise (grey values in cone beam), >= 0
  bool grain = false;       ///< noise is correlated over neighbours in i and j, as after a filter
  std::uint64_t seed = 1;   ///< of noise and streaks; the same seed gives the same samples
  double fieldRadiusMm = 0.0; ///< outside this cylinder along S there is nothing; 0: no limit
  MetalModel metal;
  ConeBeamModel coneBeam;
};

/// The parts that the settings' anatomy has.
std::vector<PhantomPart> PhantomParts(const PhantomSettings& settings);
/// "cranium", "upper teeth" ...
const char* NameOf(PhantomPart part);

/// The truth: a part, or all bones and teeth. Ask its Distance: true, NEGATIVE INSIDE. All
/// functions here throw std::invalid_argument on bad settings, with the value and the legal range.
AnalyticSolid PhantomSolid(const PhantomSettings& settings);
AnalyticSolid PhantomSolid(const PhantomSettings& settings, PhantomPart part);

/// PhantomSolid(settings).Distance(point). For more than a few points keep the solid.
SolidDistance PhantomDistance(const PhantomSettings& settings, const glm::dvec3& point);

/// All bones and teeth as an isosurface's field: mm, > 0 INSIDE bone (the other way round than
/// distances), 0 on its surface. It is a bound of the distance (never larger in size), so
/// FirstSurface may step by it.
AnalyticVolume PhantomBone(const PhantomSettings& settings);

/// A named point on a bone's surface.
struct PhantomLandmark
{
  std::string name; ///< "condylion left", "gonion right", "menton", "fibula upper end" ...
  PhantomPart part;
  glm::dvec3 point; ///< world mm, on the part's surface within 1e-9 mm
};
std::vector<PhantomLandmark> PhantomLandmarks(const PhantomSettings& settings);

/// Where the defect is, so that a guide's landmarks can be put around it.
struct PhantomDefect
{
  glm::dvec3 center;  ///< on the outer table, world mm; right (x < center), anterior, superior
  glm::dvec3 outward; ///< unit normal of the outer table there
  glm::dvec3 along;   ///< unit, the long way of the hole in the tangent plane
  glm::dvec3 across;  ///< unit, the short way: outward x along
  double lengthMm;    ///< along, edge to edge
  double widthMm;     ///< across, edge to edge
};
PhantomDefect DefectOf(const PhantomSettings& settings);

/// A point on the outer table at most 1e-9 mm off: where the ray from `center` along `direction`
/// (any length > 0) leaves the vault as it would be without the defect, fossae and base.
glm::dvec3 PhantomOuterTable(const PhantomSettings& settings, const glm::dvec3& direction);

/// The phantom as CT samples on any grid, rounded to integers. All threads, the same samples with
/// any number of them. Costs by the surface, not by the volume: boxes that no surface comes near
/// are filled at once. Throws std::invalid_argument on bad settings or geometry.
///
/// Each surface is a step in the distance (near edges: in its bound). Without blur the step is a
/// cubic of width edgeMm. With blur it is the response of a flat surface to the point spread, in
/// closed form. Where bone is curved, sharp or thin against the blur it errs: within 1 mm of bone
/// by 15 HU (root mean square) at 0.3 mm of blur, 50 HU at 0.6 mm with slices of 0.6 mm, 80 HU at 1
/// mm with slices of 2 mm, and by some hundred HU at single edges (TestPhantomScanner measures it).
std::vector<std::int16_t> SamplePhantom(
  const GridGeometry& geometry, const PhantomSettings& settings = {});

/// Slices first <= k < last of the same samples into dims.x * dims.y * (last - first) places: bit
/// for bit those of SamplePhantom. Memory beyond them does not depend on the grid. Progress is told
/// of this slab alone.
void SamplePhantomSlab(const GridGeometry& geometry, const PhantomSettings& settings, int first,
  int last, std::span<std::int16_t> samples, const ProgressFunction& progress = {});

/// The plain way: each sample evaluated by itself. The reference that SamplePhantomSlab is held to.
void SamplePhantomPlainly(const GridGeometry& geometry, const PhantomSettings& settings, int first,
  int last, std::span<std::int16_t> samples);

/// An upright grid of the given spacing (mm, > 0) that holds the whole phantom with 4 mm of air.
GridGeometry PhantomGrid(const glm::dvec3& spacing, const PhantomSettings& settings = {});

/// The same box with the given number of samples per axis, each > 1.
GridGeometry PhantomGridOfSize(const glm::ivec3& dims, const PhantomSettings& settings = {});

} // namespace hasp
