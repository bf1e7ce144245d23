#include "GuideRivals.h"

#include "MeasuredChild.h"
#include "PartCertificate.h"
#include "ScratchFolder.h"
#include "vtkHaspOutputFile.h"

#include "Evaluation/MeshCheck.h"
#include "Planning/GuideRecipeFile.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include "vtkVersion.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace hasp
{

RivalGuide MeshBooleanGuide(const GuideSubject& subject)
{
  constexpr double LimitS = 60.0;
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path program =
    fs::read_symlink("/proc/self/exe", none).replace_filename("hasp-guide-rival");
  RivalGuide guide;
  if (!fs::exists(program, none))
  {
    guide.ending = "absent: hasp-guide-rival, its child process, is not beside this program";
    return guide;
  }
  const ScratchFolder scratch;
  const std::string volume = scratch.Path() / "bone.mha", recipe = scratch.Path() / "guide.json",
                    stl = scratch.Path() / "guide.stl";
  try
  {
    WriteVolume(subject.image, volume);
    WriteGuideRecipe(recipe, subject.recipe);
    const MeasuredChild child = RunMeasured({ volume, recipe, stl }, { program.string(), LimitS });
    if (child.late)
      guide.ending = "60 s";
    else if (child.exitCode != 0 || std::sscanf(child.output.c_str(), "%lf", &guide.seconds) != 1)
      guide.ending = "exit code " + std::to_string(child.exitCode);
    else
      guide.mesh = ReadBackStl(stl);
  }
  catch (const std::runtime_error&)
  {
    guide.ending = "no result that could be read";
  }
  return guide;
}

std::string RivalText(const RivalGuide& guide, const GuideSubject& subject)
{
  const std::string name = std::string("VTK ") + vtkVersion::GetVTKVersion() +
                           " vtkFlyingEdges3D, patch moved along normals smoothed 20 times, "
                           "vtkBooleanOperationPolyDataFilter: ";
  if (!guide.ending.empty())
    return name + "no guide, " + guide.ending;
  const MeshCheck check = CheckMesh(guide.mesh);
  const GapShare gap = GapOf(guide.mesh, subject);
  char text[300];
  std::snprintf(text, sizeof text,
    "%.3g s without certificate, %zu triangles, %s, %s; 95 %% of the inner wall within %.3g mm of "
    "the gap (%.1f %% within 0.1)",
    guide.seconds, check.triangles, check.Closed() ? "closed" : "NOT CLOSED",
    check.Sound() ? "2-manifold" : "NOT 2-MANIFOLD", gap.p95Mm, 100.0 * gap.within);
  std::string crossings;
#if HASP_WITH_CGAL
  if (check.Sound())
    crossings =
      "; " + std::to_string(CountSelfIntersections(guide.mesh)) + " pairs of triangles that meet";
#endif
  return name + text + crossings;
}

} // namespace hasp
