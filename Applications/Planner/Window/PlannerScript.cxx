#include "Window/PlannerScript.h"

#include "Explain.h"
#include "Output/PartExport.h"
#include "Output/PartMaking.h"
#include "Output/RedParts.h"
#include "Planning/DurableFile.h"
#include "View/SceneView.h"
#include "Window/PlannerMeasure.h"
#include "Window/PlannerWindow.h"
#include "Window/UsePanel.h"

#include <nlohmann/json.hpp>

#include <QApplication>

#include <algorithm>
#include <iostream>

namespace hasp
{
namespace
{
constexpr int LookMs = 20; // how often it is asked whether the window has come to rest
}

PlannerScript::PlannerScript(PlannerWindow& window, const PlannerOptions& options)
  : Window(window),
    Options(options)
{
  this->Look.setInterval(LookMs);
  connect(&this->Look, &QTimer::timeout, this, &PlannerScript::Next);
  if (options.IsScript()) // nobody reads the message bar
    connect(&window.Parts(), &Planner::Said, this,
      [this](const QString& text, bool fault)
      {
        if (fault)
          this->Fail(2, text);
      });
}

void PlannerScript::Fail(int code, const QString& text)
{
  std::cerr << "hasp-planner: " << text.toStdString() << "\n";
  this->Code = std::max(this->Code, code);
}

void PlannerScript::AddInputs()
{
  const auto open = [this](const std::string& path) {
    this->Waiting.push_back([this, path] { this->Window.OpenPath(QString::fromStdString(path)); });
  };
  if (!this->Options.plan.empty())
    open(this->Options.plan);
  for (const std::string& path : this->Options.volumes)
    open(path);
  for (const std::string& path : this->Options.inputs)
    open(path);
  if (this->Options.sample)
    this->Waiting.push_back([this] { this->Window.TrySample(Sample::Skull); });
  if (!this->Options.step.empty())
    this->Waiting.push_back(
      [this] { this->Window.ChooseStep(QString::fromStdString(this->Options.step)); });
}

void PlannerScript::AddOutputs()
{
  if (this->Options.make)
  {
    this->Waiting.push_back([this] { MakeAll(this->Window.Parts()); });
    this->Waiting.push_back([this] { this->LookForRed(); });
  }
  if (!this->Options.exportTo.empty())
    this->Waiting.push_back(
      [this]
      {
        const bool mayLeave = WhyNotAll(this->Window.Parts()).isEmpty();
        if (!ExportAll(this->Window.Parts(), this->Options.exportTo,
              QString::fromStdString(this->Options.format)) &&
            !mayLeave) // else it is the folder
          this->Code = std::max(this->Code, 3);
      });
  if (!this->Options.screenshot.empty())
    this->Waiting.push_back([this] { this->Shoot(); });
  if (this->Options.explain)
    this->Waiting.push_back([this] { this->Explain(); });
  if (!this->Options.measure.empty())
    this->Waiting.push_back([this] { this->Measure(); });
  if (this->Options.exit || !this->Options.measure.empty())
    this->Waiting.push_back(
      [this]
      {
        this->Look.stop();
        QApplication::exit(this->Code); // nothing is asked, and nothing saved
      });
}

void PlannerScript::Begin()
{
  this->AddInputs();
  this->AddOutputs();
  std::reverse(this->Waiting.begin(), this->Waiting.end());
  if (!this->Waiting.empty())
    this->Look.start();
}

void PlannerScript::Next()
{
  if (!this->Window.IsSettled())
    return;
  if (this->Waiting.empty())
    return this->Look.stop();
  const std::function<void()> act = std::move(this->Waiting.back());
  this->Waiting.pop_back();
  act();
}

/// A part that does not hold has been said, and is more than a fault.
void PlannerScript::LookForRed()
{
  Planner& parts = this->Window.Parts();
  for (const PlanId object : PartObjects(parts.plan.Now()))
    if (RedParts::Of(parts).Find(object))
      this->Code = std::max(this->Code, 3);
}

void PlannerScript::Shoot()
{
  this->Window.Parts().views.DrawAll();
  this->Window.Parts().views.Scene().DrawNow(); // with settled light
  QApplication::processEvents();
  const QImage picture = this->Window.grab().toImage();
  if (!picture.save(QString::fromStdString(this->Options.screenshot), "PNG"))
    this->Fail(1, tr("the screenshot cannot be written; choose a folder that can"));
}

void PlannerScript::Measure()
{
  this->Look.stop(); // it waits by itself
  try
  {
    const auto figures = MeasurePlanner(this->Window, this->Options.quick);
    WriteDurably(this->Options.measure, figures.dump(1) + "\n", "the file of figures");
  }
  catch (const std::exception& error)
  {
    this->Fail(2, QString::fromUtf8(error.what()));
    QApplication::exit(this->Code); // what it was in the middle of may never come to rest
    return;
  }
  this->Look.start();
}

void PlannerScript::Explain()
{
  std::cout << ExplainTable(UsePanel::Resources(this->Window.Parts()));
}

} // namespace hasp
