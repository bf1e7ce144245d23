// Outlines in each eye, against those of a mesh.
#include "CellRows.h"
#include "ReportRegistry.h"
#include "ReportStereo.h"
#include "SilhouetteScene.h"

#include <algorithm>
#include <cstdio>

namespace hasp
{

void ReportStereoSilhouettes(ReportContext& context)
{
  context.progress(0.9, "stereo: outlines");
  SilhouetteScene mesh(SilhouetteScene::Mesh());
  for (const SilhouetteScene::Method& method : SilhouetteScene::Methods())
  {
    SilhouetteScene scene(method);
    const auto share = [&](StereoLayout eye)
    { return SilhouetteScene::Share(scene.Outline(eye), mesh.Outline(eye)); };
    const double mono = share(StereoLayout::Mono);
    const double eyes = std::max(share(StereoLayout::Left), share(StereoLayout::Right));
    char rival[80];
    std::snprintf(rival, sizeof rival, "the same in mono: %.3g", mono);
    ReportRow row = ErrorFigure("stereo.silhouette@" + method.id,
      { eyes, "share of the mesh's pixels" }, rival, scene.Time(),
      method.name + " against " + SilhouetteScene::Mesh().name + ", 400 x 400 pixels, worse eye");
    // Pixels on the outline are few: a dozen of 50,000 fall either way by chance.
    if (method.id != "vtk")
      row.bars = { { {}, mono + 2.5e-4 } };
    context.report.rows.push_back(row);
  }
}

} // namespace hasp
