// Outlines in each eye, against those of a mesh.
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "ReportStereo.h"
#include "SilhouetteScene.h"

#include <algorithm>
#include <array>
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
    const std::array<StereoLayout, 2> eyes{ StereoLayout::Left, StereoLayout::Right };
    double alone = 0.0, paired = 0.0; // of the worse eye
    const auto pair = scene.OfPair();
    const Timing time = scene.Time();
    for (int eye = 0; eye < 2; ++eye)
    {
      const auto truth = mesh.OfEye(eyes[eye]);
      alone = std::max(alone, SilhouetteScene::Share(scene.OfEye(eyes[eye]), truth));
      paired = std::max(paired, SilhouetteScene::Share(pair[eye], truth));
    }
    char rival[80];
    std::snprintf(rival, sizeof rival, "the same eye drawn alone: %.3g", alone);
    ReportRow row = ErrorFigure("stereo.silhouette@" + method.id,
      { paired, "share of the mesh's pixels" }, rival, time,
      method.name + " against " + SilhouetteScene::Mesh().name +
        ", 400 x 400 pixels, worse eye of a pair");
    if (method.id != "vtk")
      row.bars = { { {}, alone } };
    context.report.rows.push_back(row);
  }
}

} // namespace hasp
