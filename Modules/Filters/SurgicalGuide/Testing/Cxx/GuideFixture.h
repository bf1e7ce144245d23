#pragma once
#include "Evaluation/MeshCheck.h"
#include "FilterFixture.h"
#include "Grid/AnalyticVolumes.h"
#include "Planning/GuideRecipe.h"
#include "Planning/Osteotomy.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspVolumeView.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

/// A made-up bone, a recipe that fits it, and what the tests do with both.
namespace guidetest
{

/// An ellipsoid of bone, 1000 HU per mm at its surface's distance: closed-form truth.
inline hasp::AnalyticVolume Skull()
{
  // Bounds of an ellipsoid's distance: f = (|p/r| - 1) |p/r| / |p/r^2| has unit gradient at 0.
  const glm::dvec3 r(30, 26, 22);
  return { "ellipsoid",
    [r](const glm::dvec3& p)
    {
      const double k = glm::length(p / r);
      return k > 0 ? -(k - 1) * k / glm::length(p / (r * r)) : 20.0;
    },
    2.0 };
}

inline vtkSmartPointer<vtkImageData> ScanOf(
  const hasp::AnalyticVolume& bone, const glm::dvec3& spacing, double angle)
{
  const glm::dmat3 d(glm::rotate(glm::dmat4(1), angle, glm::normalize(glm::dvec3(1, -2, 3))));
  hasp::GridGeometry grid;
  grid.dims = glm::ivec3(glm::ceil(glm::dvec3(76) / spacing)) + 1;
  grid.spacing = spacing;
  grid.direction = d;
  grid.origin = -(d * (0.5 * spacing * glm::dvec3(grid.Cells())));
  return hasp::MakeImage(grid, hasp::SampleAnalytic<std::int16_t>(bone, grid, 200, 226));
}

inline glm::dvec3 OnSkull(double x, double y)
{
  return { x, y, 22 * std::sqrt(1 - x * x / 900 - y * y / 676) };
}

/// A band over the top of the ellipsoid with a slot and two holes, right through, with sharp edges.
inline hasp::GuideRecipe Band()
{
  hasp::GuideRecipe r;
  r.landmarks = { OnSkull(-9, 2), OnSkull(0, 3), OnSkull(9, 0) };
  r.withdrawal = { 0, 0, 1 };
  r.spacingMm = 0.5;
  r.widthMm = 12;
  r.thicknessMm = 2.5;
  r.edgeRadiusMm = 0;
  r.clearanceMm = 0;
  r.slots = { { OnSkull(0, 3), { 0, 1, 0 }, 1.2, 12, 500, 0 } };
  r.holes = { { OnSkull(-9, 2), { 0, 0, 1 }, 2.0, 500, 0 },
    { OnSkull(9, 0), { 0, 0, 1 }, 2.0, 500, 0 } };
  return r;
}

/// The guide as it comes back from a binary STL file.
inline hasp::TriangleMesh ThroughFile(vtkPolyData* guide)
{
  // CTest runs cases at the same time, each in a process of its own.
  const std::string path = testing::TempDir() + "TestGuide" + std::to_string(getpid()) + ".stl";
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(guide);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  EXPECT_EQ(writer->Write(), 1);
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->MergingOff();
  reader->Update();
  std::remove(path.c_str());
  return hasp::WeldPoints(hasp::MakeTriangleMesh(reader->GetOutput()));
}

/// What the filter answers: its mesh, and the error it reported, if any.
struct Answer
{
  vtkNew<vtkHaspGuideFilter> filter;
  std::string error;
  double share = 0.0; ///< of its work, as far as it came

  explicit Answer(vtkImageData* ct, const hasp::GuideRecipe& recipe,
    const std::vector<hasp::Osteotomy>& blades = {})
  {
    parttest::KeepWords(this->filter, this->error);
    parttest::KeepProgress(this->filter, this->share);
    this->filter->SetInputData(ct);
    this->filter->SetRecipe(recipe);
    this->filter->SetBlades(blades);
    this->filter->Update();
  }
  vtkPolyData* Guide() { return this->filter->GetOutput(); }
};

} // namespace guidetest
