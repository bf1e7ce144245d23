#include "StepsDesk.h"

#include "Planning/PlanEdits.h"
#include "vtkHaspVolumeView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace hasp::testing
{

namespace
{
std::filesystem::path NewFolder()
{
  static int number = 0;
  const auto folder = std::filesystem::path(::testing::TempDir()) /
                      ("steps-" + std::to_string(getpid()) + "-" + std::to_string(number++));
  std::filesystem::create_directories(folder / "work");
  return folder;
}
} // namespace

StepsDesk::StepsDesk(vtkSmartPointer<vtkImageData> scan)
  : Folder(NewFolder()),
    planner({ this->Folder / "state", this->Folder }, this->Folder / "work", this->views.grid)
{
  QObject::connect(&this->planner, &Planner::Said, &this->planner,
    [this](const QString& text, bool fault)
    {
      if (fault)
        this->said = text;
    });
  QObject::connect(&this->planner.scene, &PlanScene::PropsChanged, [this] { this->ShowSlices(); });
  this->Add(scan);
  this->ShowSlices();
  this->planner.scene.SetIsovalue(226.0);
  this->Settle();
}

StepsDesk::~StepsDesk()
{
  this->planner.tools.Take(nullptr);
  this->planner.jobs.CancelAll();
  std::error_code ignored;
  std::filesystem::remove_all(this->Folder, ignored);
}

void StepsDesk::ShowSlices()
{
  vtkImageData* image = this->planner.scene.ShownImage();
  if (image != this->views.grid.Image())
    this->views.grid.SetImage(image, true);
}

PlanId StepsDesk::Add(vtkSmartPointer<vtkImageData> scan)
{
  const PlanId id = this->planner.plan.NewId();
  ShelfScan shelf;
  shelf.image = scan;
  shelf.passport.hash = std::string(63, 'a') + char('0' + id % 10);
  shelf.passport.geometry = ImageGeometry(scan);
  shelf.passport.hounsfield = true;
  const std::string hash = shelf.passport.hash;
  this->planner.scans.Put(std::move(shelf));
  EXPECT_TRUE(this->planner.plan.Do(AddObject<PlanVolume>{ { id, "", hash } }));
  return id;
}

void StepsDesk::Show(QWidget* panel)
{
  this->Panel = panel;
  panel->resize(330, 900);
  panel->move(700, 0);
  panel->show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(panel));
}

void StepsDesk::Settle()
{
  EXPECT_TRUE(this->views.Wait([this] { return this->planner.jobs.IsIdle(); }, 120'000));
  this->views.Settle();
}

QPoint StepsDesk::PixelOf(const glm::dvec3& place)
{
  const auto pixel = this->views.scene.PixelOf(place);
  EXPECT_TRUE(pixel);
  return pixel ? pixel->toPoint() : QPoint();
}

void StepsDesk::Touch(const glm::dvec3& place)
{
  this->views.Click(this->views.scene, this->PixelOf(place));
}

void StepsDesk::Drag(const glm::dvec3& from, const QPoint& by)
{
  const QPoint start = this->PixelOf(from);
  this->views.Drag(this->views.scene, start, start + by);
  this->Settle();
}

PlanId StepsDesk::CutBar(double x)
{
  if (this->Now().fragments.empty())
  {
    PlanFragment bone;
    bone.id = this->planner.plan.NewId();
    bone.source = ComponentSource{ 1, 226.0, { 0, 0, 0 }, 1.0 };
    EXPECT_TRUE(this->planner.plan.Do(AddObject<PlanFragment>{ bone }));
  }
  PlanCut cut;
  cut.id = this->planner.plan.NewId();
  cut.blade = { { x, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, 24, 20, 1 };
  cut.fragments = { this->Now().fragments[0].id };
  EXPECT_TRUE(this->planner.plan.Do(AddObject<PlanCut>{ cut }));
  this->Settle();
  return cut.id;
}

QWidget* StepsDesk::Find(const char* name)
{
  auto* found = this->Panel ? this->Panel->findChild<QWidget*>(QString::fromLatin1(name)) : nullptr;
  EXPECT_TRUE(found) << name;
  return found;
}

void StepsDesk::Press(const char* name)
{
  auto* button = qobject_cast<QAbstractButton*>(this->Find(name));
  ASSERT_TRUE(button && button->isEnabled()) << name;
  button->click();
}

void StepsDesk::Type(const char* name, const QString& text)
{
  QApplication::setActiveWindow(this->Panel->window());
  QWidget* widget = this->Find(name);
  ASSERT_TRUE(widget && widget->isEnabled()) << name;
  widget->setFocus();
  if (auto* box = qobject_cast<QDoubleSpinBox*>(widget))
    box->selectAll();
  else if (auto* line = qobject_cast<QLineEdit*>(widget))
    line->selectAll();
  QTest::keyClicks(widget, text);
  QTest::keyClick(widget, Qt::Key_Return);
}

void StepsDesk::TypePoints(const char* name, const std::vector<glm::dvec3>& points)
{
  auto* list = qobject_cast<QTableWidget*>(this->Find((std::string(name) + ".list").c_str()));
  ASSERT_TRUE(list);
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    if (list->rowCount() <= int(n))
      this->Press((std::string(name) + ".crosshair").c_str());
    ASSERT_GT(list->rowCount(), int(n)) << name;
    for (int axis = 0; axis < 3; ++axis)
      list->item(int(n), axis)->setText(QString::number(points[n][axis], 'g', 12));
  }
}

void StepsDesk::Choose(const char* name, int row)
{
  auto* box = qobject_cast<QComboBox*>(this->Find(name));
  ASSERT_TRUE(box && row < box->count()) << name;
  box->setCurrentIndex(row);
  Q_EMIT box->activated(row);
}

QString StepsDesk::TextOf(const char* name)
{
  const auto* label = qobject_cast<QLabel*>(this->Find(name));
  return label && !label->isHidden() ? label->text() : QString();
}

glm::dvec3 Front(double x, double z)
{
  return { x, -std::sqrt(36.0 - z * z), z };
}

double OffBar(const glm::dvec3& place)
{
  return std::abs(6.0 - glm::length(place - glm::dvec3(std::clamp(place.x, -24.0, 24.0), 0, 0)));
}

glm::dvec3 EyeOf(FrameView& view)
{
  double eye[3];
  view.Renderer()->GetActiveCamera()->GetPosition(eye);
  return { eye[0], eye[1], eye[2] };
}

vtkSmartPointer<vtkImageData> ScanOfBar()
{
  GridGeometry grid;
  grid.dims = { 81, 25, 25 };
  grid.origin = { -40.0, -12.0, -12.0 };
  std::vector<std::int16_t> samples;
  samples.reserve(grid.Size());
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
      {
        const glm::dvec3 at = grid.IndexToWorld({ i, j, k });
        const double inside =
          6.0 - glm::length(at - glm::dvec3(std::clamp(at.x, -24.0, 24.0), 0, 0));
        samples.push_back(
          std::int16_t(std::lround(std::clamp(226.0 + 1000.0 * inside, -1000.0, 3000.0))));
      }
  return MakeImage(grid, samples);
}

} // namespace hasp::testing
