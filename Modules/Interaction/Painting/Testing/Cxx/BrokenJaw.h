#ifndef BrokenJaw_h
#define BrokenJaw_h

// A broken jaw, and a session that splits it.
#include "PaintScene.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspSegmentationSession.h"
#include "vtkHaspStrokeActor.h"
#include "vtkHaspVolumeView.h"

#include "Grid/Phantom.h"
#include "Segmentation/LabelHash.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedShortArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

namespace hasp::testing
{

constexpr double VoxelMm = 1.5, PixelSize = 0.5,
                 BreakMm = 2.0; // where it is broken: right of menton

inline glm::dvec3 Menton()
{
  for (const PhantomLandmark& landmark : PhantomLandmarks({}))
    if (landmark.name == "menton")
      return landmark.point;
  throw std::logic_error("the phantom has no menton");
}

/// The body of the phantom's mandible; two sheets of voxels are as dark as a fresh fracture.
inline vtkSmartPointer<vtkImageData> BrokenJaw()
{
  GridGeometry grid;
  grid.spacing = glm::dvec3(VoxelMm);
  grid.dims = { 60, 30, 18 };
  grid.origin = Menton() + glm::dvec3(-45.0, -8.0, -4.0);
  std::vector<std::int16_t> samples = SamplePhantom(grid, {});
  for (std::size_t n = 0; n < samples.size(); ++n)
    if (const double x = grid.origin.x + VoxelMm * double(n % 60) - Menton().x;
        std::abs(x + BreakMm) < VoxelMm && samples[n] > 260)
      samples[n] = 260;
  return MakeImage(grid, samples);
}

struct JawScene : PaintScene
{
  JawScene()
  {
    this->session->SetScan(this->scan);
    this->session->SetMapper(this->mapper);
    this->session->SetPainter(this->painter);
    this->session->SetStrokeActor(this->strokes);
    this->mapper->SetIsoValue(226.0);
    this->mapper->SetRendererToRasterize();
    vtkNew<vtkActor> actor;
    actor->SetMapper(this->mapper);
    this->renderer->AddActor(actor);
    this->renderer->AddViewProp(this->strokes);
    vtkCamera* camera = this->renderer->GetActiveCamera(); // from anterior, superior up
    const glm::dvec3 at = Menton();
    camera->SetPosition(at.x, at.y - 100.0, at.z);
    camera->SetFocalPoint(at.x, at.y, at.z);
    camera->SetViewUp(0, 0, 1);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5 * PixelSize * Side);
    camera->SetClippingRange(10, 200);
    this->painter->SetRadiusMm(1.5);
  }
  /// Along the chin, mm to the left of menton.
  void Drag(int label, double fromMm, double toMm)
  {
    const auto pixel = [](double mm) {
      return glm::ivec2(std::lround(100.0 + mm / PixelSize), std::lround(100.0 + 6.0 / PixelSize));
    };
    this->painter->SetLabel(label);
    PaintScene::Drag({ pixel(fromMm), pixel(toMm) });
    ASSERT_FALSE(this->painter->GetPieces().empty()) << "no bone there";
  }
  void Key(const char* symbol, const char* keys = "")
  {
    this->Say(vtkCommand::KeyPressEvent, { 5, 5 }, keys, symbol);
  }
  vtkUnsignedShortArray* Labels()
  {
    return vtkUnsignedShortArray::SafeDownCast(
      this->session->GetImage()->GetPointData()->GetArray("Labels"));
  }
  GridView<const Label> Map()
  {
    return { this->Labels()->GetPointer(0), ImageGeometry(this->session->GetImage()) };
  }
  std::uint64_t Hash() { return HashLabels(this->Map()); }
  std::map<Label, int> Voxels()
  {
    std::map<Label, int> voxels;
    const GridView<const Label> map = this->Map();
    for (std::size_t n = 0; n < map.geometry.Size(); ++n)
      ++voxels[map.data[n]];
    return voxels;
  }

  static inline const vtkSmartPointer<vtkImageData> Jaw = BrokenJaw();
  vtkImageData* const scan = Jaw;
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  vtkNew<vtkHaspStrokeActor> strokes;
  vtkNew<vtkHaspSegmentationSession> session;
};

} // namespace hasp::testing

#endif
