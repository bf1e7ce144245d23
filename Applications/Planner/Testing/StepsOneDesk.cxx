#include "StepsOneDesk.h"

#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <QtTest>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace hasp::testing
{
namespace
{
constexpr double BoneValue = 226.0, ValuePerMm = 500.0;
constexpr int MostMs = 60'000;
int Desks = 0; ///< each works in a folder of its own
}

CanaryFolder::CanaryFolder()
{
  std::string pattern =
    (std::filesystem::temp_directory_path() / (std::string(Canary) + "-XXXXXX")).string();
  if (!mkdtemp(pattern.data()))
    throw std::runtime_error("no folder can be made");
  this->Place = pattern;
}

CanaryFolder::~CanaryFolder()
{
  std::error_code ignored; // a folder that stays is no reason to fail a test
  std::filesystem::remove_all(this->Place, ignored);
}

std::filesystem::path CanaryFolder::Folder(const std::string& name) const
{
  std::filesystem::create_directories(this->Place / name);
  return this->Place / name;
}

StepsOneDesk::StepsOneDesk(const CanaryFolder& folder, const std::string& state)
  : planner({ folder.Folder(state), folder.Folder("plans") },
      folder.Folder("work-" + std::to_string(++Desks)), this->desk.grid)
{
  QObject::connect(&this->planner, &Planner::Said, &this->planner,
    [this](const QString& text, bool fault) { (fault ? this->faults : this->said) << text; });
  // As the window does.
  const auto follow = [this]
  {
    vtkImageData* image = this->planner.scene.ShownImage();
    if (image != this->planner.views.Image())
      this->planner.views.SetImage(image, false);
  };
  QObject::connect(&this->planner.plan, &PlanSession::Changed, &this->planner, follow);
  QObject::connect(&this->planner.scene, &PlanScene::PropsChanged, &this->planner, follow);
}

bool StepsOneDesk::Settle()
{
  const bool idle = QTest::qWaitFor([this] { return this->planner.jobs.IsIdle(); }, MostMs);
  this->desk.Settle();
  return idle && this->planner.jobs.IsIdle();
}

QPoint StepsOneDesk::PixelOf(const glm::dvec3& world) const
{
  const auto pixel = this->desk.scene.PixelOf(world);
  if (!pixel)
    throw std::logic_error("it is behind the viewer");
  return pixel->toPoint();
}

glm::dvec3 BallMiddle(double gapMm, int side)
{
  return { side * (BallMm + 0.5 * gapMm), 0.0, 0.0 };
}

vtkSmartPointer<vtkImageData> TwoBalls(double gapMm)
{
  GridGeometry grid;
  grid.dims = { 60, 32, 32 };
  grid.spacing = glm::dvec3(1.0);
  grid.origin = -0.5 * glm::dvec3(grid.dims - 1);
  std::vector<std::int16_t> samples;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
      {
        const glm::dvec3 place = grid.IndexToWorld({ i, j, k });
        const double mm = std::min(glm::distance(place, BallMiddle(gapMm, 1)),
                            glm::distance(place, BallMiddle(gapMm, -1))) -
                          BallMm;
        samples.push_back(
          std::int16_t(std::lround(glm::clamp(BoneValue - ValuePerMm * mm, -1000.0, 2000.0))));
      }
  return MakeImage(grid, samples);
}

} // namespace hasp::testing
