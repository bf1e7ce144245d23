#include "ReportTerms.h"

#include "LightTerms.h"
#include "PlannerTerms.h"
#include "ReductionTerms.h"
#include "SegmentationTerms.h"

namespace hasp
{
namespace
{

std::vector<ReportTerm> IsosurfaceTerms()
{
  return {
    { "isosurface.frame",
      "time of a frame of the cells / of mesh: VTK's mesh, direct: a ray cast, volume1 and "
      "volume025: VTK's volume mapper with steps of 1 and a quarter voxel; @: the body and its "
      "samples along an axis" },
    { "isosurface.rms",
      "root of the mean square of what a method draws off the true surface, along the rays" },
    { "isosurface.p99", "the same, exceeded by one pixel of a hundred" },
    { "isosurface.max", "the same, of the worst pixel" },
    { "isosurface.missed", "share of the surface's pixels in which a method draws none" },
    { "isosurface.bytes.mesh", "bytes of the cells / of VTK's mesh" },
    { "isosurface.error_time", "error against time of a frame; lower left is better" },
  };
}

std::vector<ReportTerm> CellTerms()
{
  return {
    { "cells.extract",
      "time from the volume to active cells / to the mesh; next: of another isovalue" },
    { "cells.bytes.exact", "bytes of the cells / of an indexed mesh that packs its vertices; "
                           "float, vtk: of larger meshes" },
    { "cells.bytes.compact", "the same of cells with 8 bits a corner" },
    { "cells.bytes.drawing", "bytes for drawing / of the cells themselves, by renderer" },
    { "cells.bytes.bvh", "bytes beside the cells for tracing / of an indexed mesh" },
    { "cells.compact", "how far compact cells move the surface (rms, p999, max), how many cells "
                       "they change, and the time to make them" },
    { "cells.depth", "how far the drawn surface lies from the true one, by renderer; max: of the "
                     "worst one; grazing: rays along the surface too; random: by random rays" },
    { "cells.missed", "share of the surface's pixels or rays that are missed, by renderer" },
    { "cells.edit", "time to bring cells up to date after a change of 1 % / to extract all anew" },
    { "cells.frame", "time of a frame / of the mesh's, by renderer; large: of the largest volume" },
    { "cells.growth", "power of the samples along an axis with which bytes or times grow" },
    { "cells.rays",
      "rays traced against cells, times as fast as against triangles; ao: short rays "
      "for ambient occlusion; packets: against 16 rays at once, incoherent: that go any "
      "way; memory: bytes of both" },
    { "cells.build.rays", "time from the volume to the first ray / the same with triangles" },
    { "cells.stream", "a volume on disk, larger than memory: gib held, and time to the first "
                      "picture; @: samples along an axis" },
    { "cells.error_time", "error against time of a frame; lower left is better" },
  };
}

std::vector<ReportTerm> RaycachingTerms()
{
  return {
    { "raycaching.psnr", "peak signal to noise of a still picture against the truth; one: of one "
                         "picture; centre: against a ray at each pixel's centre" },
    { "raycaching.depth.median", "how far from the surface cached bricks lie, of half the pixels" },
    { "raycaching.holes", "share of the surface's pixels left open when the head jitters; "
                          "unpredicted: without prediction" },
    { "raycaching.head",
      "how far the head is from where it was drawn for (error), and holes so; unpredicted as "
      "above" },
    { "raycaching.bricks.unique", "bricks alive / distinct ones: 1, or some are there twice" },
    { "raycaching.speedup",
      "frames along a path against primary: direct rays, skipping: those that skip empty blocks, "
      "vtk: VTK's volume mapper; then the path, none for the orbit; @ the mode: cache, auto" },
    { "raycaching.first95",
      "time until 95 % of the pixels are shown after a change (cut, jump, ...) / a mesh's first "
      "frame; @ the mode" },
    { "raycaching.cost.isovalue", "time of the first frame after a jump of the isovalue / of "
                                  "direct rays that show as much" },
    { "raycaching.cost.lit", "time of a lit frame / of rays cast anew for each pixel" },
    { "raycaching.ao", "noise of still light: its slope over frames and over casts, and its floor; "
                       "error: the curve" },
    { "raycaching.stereo", "bricks, time of the second eye and of the pair / of one eye" },
    { "cells.stereo", "time of the second eye / the first's, and of the pair / of one in mono, of "
                      "active cells; @: by which renderer" },
    { "raycaching.soak",
      "a long walk: growth of memory and cache, bricks that are there twice, and errors" },
    { "raycaching.error_time", "error against time after a change; lower left is better" },
  };
}

std::vector<ReportTerm> HapticTerms()
{
  return {
    { "haptics.simd.static",
      "contact of a point shell that does not change: forces alone; then the vectors: avx2 or "
      "avx512 (AVX3 in the data); native: against plain code compiled for this processor; @256: a "
      "map of 256^3 "
      "samples, else 128^3" },
    { "haptics.simd.matrix", "the same with gradients and the 6x6 stiffness matrix" },
    { "haptics.simd.dynamic",
      "points drawn and felt as a body moves, against plain code; @: its speed, else 100 mm/s" },
    { "haptics.wrench", "what vectors are off by from one point after the other; int16: what a map "
                        "of int16 is off by from one of floats; the worst of all cases" },
    { "haptics.dynamic.error",
      "error of the force with points that follow contact, as a share of the error with as many "
      "points all over the body; @: points, else 4096" },
    { "haptics.error",
      "error of the force by levels of a shell, and by time allowed (budgets); "
      "falls: how much of the error the next finer level leaves, at worst; @press, "
      "@fit: how the bodies touch" },
    { "haptics.levels", "levels more that vectors evaluate in the same time as plain code" },
    { "haptics.points",
      "points that a whole tick evaluates in 1 ms of CPU time; @: points of the shell, else "
      "100,000" },
    { "haptics.snap",
      "Snap-to-fit: ms of a whole tick (@: points, else 5000), and ripple of the force held" },
    { "haptics.falcon", "a model of a device: what its driver leaves of a tick; ticks of delay" },
    { "haptics.coarse",
      "a tick with the coarse phase, which leaves out points that are far; separated, near, "
      "touching, pressed: ever nearer; inside: a body on itself, where nothing is far and it can "
      "only cost; @256: a map of 256^3 samples" },
    { "haptics.loop",
      "a loop of 1 kHz on the wall's clock: lateness of a tick that half (p50), 1 of 100 (p99) or "
      "1 of 1000 (p999) exceed, and the share of ticks missed; others' work on the machine "
      "counts, so these have no bar; lateness: the curve" },
  };
}

std::vector<ReportTerm> DistanceTerms()
{
  return {
    { "distance.rms.chamfer_aa",
      "error of the surface at an offset of 0, 2 or 5 voxels by anti-aliased <3,4,5> / by binary "
      "<3,4,5>: what the papers claim of anti-aliasing, as we understand it" },
    { "distance.offset", "the same of the guides' transform / of anti-aliased <3,4,5>" },
    { "distance.rms.guide",
      "root of the mean square of what the guides' transform (CoverageDistance) is off by on exact "
      "coverage, within 3 voxels of the surface" },
    { "distance.max.guide", "the same at worst" },
    { "distance.rms.far", "the same of the whole field, within 40 voxels" },
    { "distance.cost",
      "time of the guides' transform / of anti-aliased <3,4,5> by Hasp itself: guide: "
      "its band of 4 voxels, far: the whole field; @: samples along an axis" },
    { "distance.rms.ct",
      "error on images as a scanner makes them: by coverage of them; grey: of the grey values as "
      "they are; chamfer: anti-aliased <3,4,5> by coverage" },
    { "distance.speed.edt", "exact Euclidean distance to a mask, times as fast as ITK's; vtk: as "
                            "VTK's; @2threads: both on "
                            "two threads" },
    { "distance.field",
      "time of the guides' transform / of a transform of others; the errors of both are told" },
    { "distance.wall", "how far the thinnest place of a shell of 3 voxels around a scanned bone is "
                       "off what was asked, "
                       "/ the same by binary <3,4,5>; chamfer_aa, euclid: by anti-aliased <3,4,5>, "
                       "by exact distances "
                       "to the mask" },
    { "distance.error_time",
      "error within 3 voxels against time, a sphere in 32^3, 64^3, 128^3 and "
      "256^3 voxels; lower left is better" },
    { "contour.manifold",
      "share of contours that are closed and 2-manifold, of random trees of solids" },
    { "contour.crossing",
      "share of those in which no triangles meet but in shared edges and points" },
    { "contour.fallback", "share of those that gave no surface though a sample lies inside" },
    { "contour.flatness", "how far the walls of a slot are off their planes, at most" },
    { "contour.edge", "radius of edges that are sharp in truth, at most" },
    { "contour.hole", "diameter of a drilled hole, off" },
    { "contour.boolean_rival", "share of good results of a Boolean of meshes on the same trees" },
  };
}

std::vector<ReportTerm> GuideTerms()
{
  return {
    { "guides.manifold",
      "share of random guides, plates and implants made that are sound; error: how many are not" },
    { "guides.crashes", "random parts that ended their process or took 20 s" },
    { "guides.fallback", "random parts that a method below the part's own gave up on" },
    { "guides.refused",
      "share of refusals, and of nonsense, with the error that names what is wrong" },
    { "guides.planes",
      "how far saw planes found in written guides are off the recipe's, at worst" },
    { "guides.conservation",
      "share of bone that fragments and kerfs of random cuts do not account for, at worst" },
    { "guides.certificate.found", "parts with a defect that are red for that very reason" },
    { "guides.certificate.false", "clean parts that are red" },
    { "guides.time", "from a recipe to an STL file that is read back and certified, median" },
    { "guides.gap.p95", "95 % of the inner wall's area are within that of the gap asked for" },
    { "guides.preview",
      "from a recipe to the active cells that show the guide, median; error: how far the finished "
      "mesh's points are off what they show" },
    { "guides.plan", "share of random plans that come back as they were saved" },
  };
}

std::vector<ReportTerm> StereoTerms()
{
  return {
    { "stereo.place.max",
      "how far a ball is drawn from where it must be in either eye, at worst; @mesh, @volume" },
    { "stereo.disparity.max", "the same for each layout of a window; hmd: head-mounted" },
    { "stereo.pair.time", "time of a pair / of VTK's own stereo" },
    { "stereo.silhouette", "share of a mesh's pixels by which an outline differs, by mapper" },
    { "stereo.error_time", "error against time of a pair; lower left is better" },
  };
}

std::vector<ReportTerm> OthersOf(const std::string& report)
{
  if (report == "import")
    return {
      { "import.faults", "folders with a fault that Hasp accepts, beside how many READER does" },
      { "import", "FORMAT.time.READER: time to read a file of that format / that reader's; the "
                  "error is where samples lie; error_time: both as curves" },
    };
  if (report == "stability")
    return {
      { "stability.pass", "share of the cases below that came out as predicted" },
      { "stability.rows",
        "how many cases there are, all told below: id, outcome, the figure that the prediction "
        "rests on and its limit, what was tried. Of haptics: stable below the limit; else it "
        "oscillates (the figure is above 1: that is predicted, too), gives the hand energy (more "
        "than 1 mJ), gets deep (half a voxel, or half of a plate) or through; k: contact in N/mm, "
        "T: tick in ms, d: ticks of delay, F: share of what a plate stands" },
    };
  return {};
}

} // namespace

std::vector<ReportTerm> TermsOf(const std::string& report)
{
  std::vector<ReportTerm> terms = report == "isosurface"     ? IsosurfaceTerms()
                                  : report == "cells"        ? CellTerms()
                                  : report == "raycaching"   ? RaycachingTerms()
                                  : report == "distance"     ? DistanceTerms()
                                  : report == "guides"       ? GuideTerms()
                                  : report == "haptics"      ? HapticTerms()
                                  : report == "light"        ? LightTerms()
                                  : report == "planner"      ? PlannerTerms()
                                  : report == "reduction"    ? ReductionTerms()
                                  : report == "segmentation" ? SegmentationTerms()
                                  : report == "stereo"       ? StereoTerms()
                                                             : OthersOf(report);
  if (!terms.empty())
    terms.push_back({ report + ".memory.peak", "memory of the process at most, so far" });
  return terms;
}

} // namespace hasp
