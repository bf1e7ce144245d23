#include "LightTerms.h"

namespace hasp
{

std::vector<ReportTerm> LightTerms()
{
  return {
    { "light.furnace",
      "the same light from everywhere on what gives all of it back: how far radiance is from the "
      "light's own, 1, at worst; diffuse, coat, metal: on a ball; concave: in channels, with many "
      "bounces; without a kind: the worst of them" },
    { "light.sphere", "direct light of a plane on which a sphere lies, off its closed form, at the "
                      "worst place; sky: under daylight, against a sum over the sky" },
    { "light.reciprocity", "how far what an eye gets of a lamp is from what it gets when both "
                           "change places, in standard errors of the two" },
    { "light.energy",
      "mean radiance by the number of bounces, at most, of what the furnace allows; "
      "increments: what a bounce adds, of what the one before added" },
    { "light.sobol",
      "CPU time of light by 64 scrambled Sobol points / by as many random ones as make the same "
      "error, and the error by time as curves; ao: openness within 25 mm, bounce1, bounce3: paths "
      "under daylight; slope: of the error over samples, in logarithms" },
    { "light.hybrid",
      "CPU time of light that is kept on surfaces (SceneLightCache) / of paths traced anew until "
      "they have the same error; still: the view stays, up to so many pictures, else 16; moving: "
      "it turns; without a kind: the worse of still and moving; error_time: the curves" },
    { "light.rays",
      "rays traced against cells, times as fast as against triangles of the same surface; ao: is "
      "anything in the way, bounces: what comes next, each through a scene as light asks, and "
      "(tracer) of its one body alone; paths: whole paths; rate: rays a second, the slowest of "
      "these; without a kind: the worst ratio" },
    { "light.extreme",
      "pixel: the brightest sample, and mean: the light, of a map with one pixel of a million; "
      "black: light where there is none; inside: an eye in a hollow ball of bone; small, large, "
      "spacing: the same scene at other sizes, and with cells of 100:1" },
    { "light.transparency",
      "pictures of so many translucent layers of cells and meshes, of 255, off all that each "
      "pixel's ray meets, sorted on the CPU; peeled: depth peeling; weighted: VTK's default; "
      "unsorted: "
      "blended as drawn; time: peeling's over theirs" },
  };
}

} // namespace hasp
