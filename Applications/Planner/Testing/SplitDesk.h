#pragma once
#include "StepsOneDesk.h"

#include "Segmenter.h"
#include "Steps/ImportPanel.h"
#include "Steps/SplitPanel.h"
#include "vtkHaspOutputFile.h"

#include "vtkImageData.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hasp::testing
{

inline constexpr double JoinedMm = -4.0; ///< the balls are one bone

/// Two balls that are painted.
struct SplitDesk : StepsOneDesk
{
  explicit SplitDesk(const CanaryFolder& folder, double gapMm = JoinedMm)
    : StepsOneDesk(folder),
      gapMm(gapMm),
      import(this->planner),
      panel(this->planner)
  {
    WriteVolume(TwoBalls(gapMm), folder.File("scan.mha"));
    this->import.ImportPath(QString::fromStdString(folder.File("scan.mha")));
    this->Settle();
    this->planner.scene.SetIsovalue(226.0);
    this->planner.scene.LookFrom('A');
    this->Settle();
  }
  /// The foremost place of a ball, to who looks from the front.
  QPoint Front(int side)
  {
    return this->PixelOf(BallMiddle(this->gapMm, side) + glm::dvec3(0.0, -BallMm, 0.0));
  }
  void Paint(int label, int side)
  {
    this->panel.Paint().SetLabel(label);
    this->Settle();
    this->desk.Drag(this->desk.scene, this->Front(side), this->Front(side) + QPoint(6, 0));
    this->panel.Paint().Preview().Finish();
    this->Settle();
  }
  const SegmentationRecipe& Recipe() const { return this->Now().segmentations.at(0).recipe; }
  /// The labels that are shown.
  std::vector<std::uint16_t> Shown()
  {
    vtkImageData* labels = this->panel.Paint().Preview().Labels();
    const auto* first = static_cast<const std::uint16_t*>(labels->GetScalarPointer());
    return { first, first + labels->GetNumberOfPoints() };
  }
  std::vector<std::uint16_t> Segmented() const
  {
    const SegmentedScan made = SegmentScan(this->planner.scene.ShownImage(), this->Recipe());
    const auto* first = static_cast<const std::uint16_t*>(made.labels->GetScalarPointer());
    return { first, first + made.labels->GetNumberOfPoints() };
  }

  double gapMm;
  ImportPanel import;
  SplitPanel panel;
};

} // namespace hasp::testing
