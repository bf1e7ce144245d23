#include "SceneDesk.h"

#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <QDir>
#include <QtTest>

#include <algorithm>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace hasp::testing
{

const std::string BallsHash(64, 'b');

SceneDesk::SceneDesk()
  : plan(this->folder.path().toStdString()),
    scene(this->plan, this->scans, this->jobs, this->view)
{
  const auto keep = [this](const QString& text) { this->refused << text; };
  QObject::connect(&this->plan, &PlanSession::Refused, keep);
  QObject::connect(&this->scene, &PlanScene::Refused, keep);
  QObject::connect(&this->jobs, &JobQueue::Failed,
    [this](const QString&, const QString& text) { this->refused << text; });
  this->view.resize(600, 500);
  this->view.show();
  if (!QTest::qWaitForWindowExposed(&this->view))
    throw std::runtime_error("the window did not open");
}

SceneDesk::~SceneDesk() = default;

PlanId SceneDesk::AddScan(vtkImageData* image, const std::string& hash)
{
  ShelfScan scan;
  scan.image = image;
  scan.passport.hash = hash;
  scan.passport.hounsfield = true;
  scan.passport.minimum = image->GetScalarRange()[0];
  scan.passport.maximum = image->GetScalarRange()[1];
  this->scans.Put(scan);
  return this->Add(PlanVolume{ 0, "", hash });
}

void SceneDesk::Settle()
{
  constexpr int PatientMs = 120'000;
  if (!QTest::qWaitFor([this] { return this->jobs.IsIdle(); }, PatientMs))
    throw std::runtime_error("the jobs do not end");
  for (unsigned long long before = this->view.Frames() - 1; this->view.Frames() != before;)
  {
    before = this->view.Frames();
    QTest::qWait(40); // a frame's timer is 8 ms at most
  }
}

QImage SceneDesk::Picture(const char* name)
{
  this->view.DrawNow();
  const QImage picture = this->view.grabFramebuffer();
  QDir().mkpath(HASP_TEST_PICTURES);
  picture.save(QString(HASP_TEST_PICTURES) + "/" + name + ".png");
  return picture;
}

QPoint SceneDesk::PixelOf(const glm::dvec3& world) const
{
  vtkRenderer* renderer = this->view.Renderer();
  renderer->SetWorldPoint(world.x, world.y, world.z, 1.0);
  renderer->WorldToDisplay();
  const double* at = renderer->GetDisplayPoint();
  return { qRound(at[0]), qRound(at[1]) };
}

vtkActor* SceneDesk::ActorOf(PlanId object) const
{
  return vtkActor::SafeDownCast(this->scene.PropOf(object));
}

ResourceUse SceneDesk::UseOf(const std::string& resource) const
{
  ResourceList list;
  this->scene.ListResources(list);
  const auto found = std::find_if(
    list.begin(), list.end(), [&](const ResourceUse& use) { return use.resource == resource; });
  return found != list.end() ? *found : ResourceUse{ resource, 0, 0.0, "not listed" };
}

std::size_t SceneDesk::Props() const
{
  return std::size_t(this->view.Renderer()->GetViewProps()->GetNumberOfItems());
}

TwoBalls::TwoBalls()
{
  this->grid.dims = { 74, 46, 42 };
  this->grid.direction =
    glm::mat3_cast(glm::angleAxis(0.2, glm::normalize(glm::dvec3(1.0, -2.0, 3.0))));
  this->grid.origin = -(this->grid.IndexToWorldMatrix() * (0.5 * glm::dvec3(this->grid.dims - 1)));
  std::vector<std::int16_t> samples(this->grid.Size());
  std::size_t n = 0;
  for (int k = 0; k < this->grid.dims.z; ++k)
    for (int j = 0; j < this->grid.dims.y; ++j)
      for (int i = 0; i < this->grid.dims.x; ++i)
      {
        const double away = this->Distance(this->grid.IndexToWorld({ i, j, k }));
        samples[n++] = std::int16_t(std::lround(226.0 - BallValuePerMm * away));
      }
  this->image = MakeImage(this->grid, samples);
}

double TwoBalls::Distance(const glm::dvec3& p) const
{
  return std::min(glm::distance(p, this->left) - this->leftRadius,
    glm::distance(p, this->right) - this->rightRadius);
}

PlanFragment Component(const glm::dvec3& seed)
{
  PlanFragment fragment;
  fragment.source = ComponentSource{ 1, 226.0, seed, 1.0 };
  return fragment;
}

PlanFragment PieceOf(PlanId fragment, const glm::dvec3& seed)
{
  PlanFragment piece;
  piece.source = PieceSource{ fragment, seed };
  return piece;
}

PlanCut CutAt(double x, PlanId fragment)
{
  return { 0, "", { { x, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 60.0, 60.0, 1.0 }, { fragment }, 8.0 };
}

} // namespace hasp::testing
