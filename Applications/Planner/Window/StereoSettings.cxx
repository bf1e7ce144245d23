#include "Window/StereoSettings.h"

#include "StereoView.h"
#include "Window/PlannerWindow.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace hasp
{
namespace
{
/// Names as StereoChoices has them, and what the user reads.
struct Choice
{
  const char* name;
  const char* text;
};
constexpr Choice Layouts[] = {
  { "anaglyph", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Anaglyph (red and cyan glasses)") },
  { "side-by-side", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Side by side") },
  { "top-bottom", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Top and bottom") },
  { "interlaced", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Interlaced rows") },
  { "checkerboard", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Checkerboard") },
  { "mono", QT_TRANSLATE_NOOP("hasp::StereoSettings", "One eye") },
};
constexpr Choice Resolutions[] = {
  { "full", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Full: an eye has its own pixels") },
  { "half", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Half: both share the window's") },
};
constexpr Choice Mirrors[] = {
  { "none", QT_TRANSLATE_NOOP("hasp::StereoSettings", "No mirror") },
  { "horizontal", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Left and right changed over") },
  { "vertical", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Upside down (a mirror above hands)") },
  { "both", QT_TRANSLATE_NOOP("hasp::StereoSettings", "Both") },
};
constexpr Choice Heads[] = {
  { "", QT_TRANSLATE_NOOP("hasp::StereoSettings", "The head keeps still") },
  { "mouse", QT_TRANSLATE_NOOP("hasp::StereoSettings", "The mouse moves the head") },
  { "opentrack", QT_TRANSLATE_NOOP("hasp::StereoSettings", "opentrack (listens on a port)") },
  { "other", QT_TRANSLATE_NOOP("hasp::StereoSettings", "A recording or a plugin:") },
};

template <std::size_t N>
QComboBox* Combo(const Choice (&choices)[N], const char* name)
{
  auto* combo = new QComboBox;
  combo->setObjectName(name);
  for (const Choice& one : choices)
    combo->addItem(StereoSettings::tr(one.text), QString(one.name));
  return combo;
}

QDoubleSpinBox* Box(const char* name, double low, double high, const QString& unit, double value)
{
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(low, high);
  box->setDecimals(1);
  box->setSuffix(" " + unit);
  box->setValue(value);
  return box;
}

void Select(QComboBox* combo, const std::string& name)
{
  combo->setCurrentIndex(std::max(0, combo->findData(QString::fromStdString(name))));
}

std::string Selected(const QComboBox* combo)
{
  return combo->currentData().toString().toStdString();
}

std::optional<ContentBox> Content(const PlanScene& scene)
{
  const vtkBoundingBox box = scene.Bounds();
  if (!box.IsValid())
    return std::nullopt;
  ContentBox content;
  box.GetBounds(content.bounds.data());
  return content;
}
} // namespace

StereoSettings::StereoSettings(PlannerWindow& window, const PlannerStereo& before)
  : QDialog(&window),
    Window(window),
    Layout(Combo(Layouts, "stereo.layout")),
    Resolution(Combo(Resolutions, "stereo.resolution")),
    Mirror(Combo(Mirrors, "stereo.mirror")),
    Head(Combo(Heads, "stereo.head")),
    HeadMore(new QLineEdit),
    Swap(new QCheckBox(tr("Change the eyes &over"))),
    LifeSize(new QCheckBox(tr("&Life size"))),
    FullScreen(new QCheckBox(tr("&Full screen"))),
    Known(new QCheckBox(tr("The &screen's size is known"))),
    Width(Box("stereo.width", 10.0, 1e5, tr("mm"), 520.0)),
    Height(Box("stereo.height", 10.0, 1e5, tr("mm"), 320.0)),
    Distance(Box("stereo.distance", 100.0, 1e4, tr("mm"), 600.0)),
    Eyes(Box("stereo.eyes", 20.0, 100.0, tr("mm"), 63.0)),
    Angle(Box("stereo.angle", 0.0, 20.0, tr("°"), 2.0)),
    Drawing(new QLabel),
    Fault(new QLabel)
{
  this->setWindowTitle(tr("Stereo settings"));
  this->setObjectName("stereo.settings");
  this->Build();
  this->Show(before);
  this->Sketch();
}

void StereoSettings::Build()
{
  this->HeadMore->setObjectName("stereo.head.more");
  this->Swap->setObjectName("stereo.swap");
  this->LifeSize->setObjectName("stereo.life");
  this->FullScreen->setObjectName("stereo.full");
  this->Known->setObjectName("stereo.known");
  this->Drawing->setObjectName("stereo.sketch");
  this->Drawing->setMinimumSize(420, 420);
  this->Fault->setObjectName("stereo.fault");
  this->Fault->setWordWrap(true);
  auto* form = new QFormLayout;
  form->addRow(tr("&Picture"), this->Layout);
  form->addRow(tr("&Resolution"), this->Resolution);
  form->addRow(tr("&Mirror"), this->Mirror);
  for (QCheckBox* box : { this->Swap, this->FullScreen, this->Known })
    form->addRow(box);
  form->addRow(tr("Screen's &width"), this->Width);
  form->addRow(tr("Screen's heigh&t"), this->Height);
  form->addRow(tr("Head to screen, &distance"), this->Distance);
  form->addRow(tr("&Eyes apart"), this->Eyes);
  form->addRow(this->LifeSize);
  form->addRow(tr("&Angle between the eyes, where no size is known"), this->Angle);
  form->addRow(tr("&Head"), this->Head);
  form->addRow(tr("File, or FILE.so:SETTINGS"), this->HeadMore);
  form->addRow(this->Fault);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  buttons->button(QDialogButtonBox::Ok)->setObjectName("stereo.ok");
  buttons->button(QDialogButtonBox::Cancel)->setObjectName("stereo.cancel");
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form->addRow(buttons);
  auto* row = new QHBoxLayout(this);
  row->addLayout(form);
  row->addWidget(this->Drawing, 1);
  for (QComboBox* combo : { this->Layout, this->Resolution, this->Mirror, this->Head })
    connect(combo, qOverload<int>(&QComboBox::activated), this, &StereoSettings::Sketch);
  for (QCheckBox* box : { this->Swap, this->LifeSize, this->Known })
    connect(box, &QCheckBox::toggled, this, &StereoSettings::Sketch);
  for (QDoubleSpinBox* box : { this->Width, this->Height, this->Distance, this->Eyes, this->Angle })
    connect(box, &QDoubleSpinBox::editingFinished, this, &StereoSettings::Sketch);
}

void StereoSettings::Show(const PlannerStereo& before)
{
  const StereoChoices& stereo = before.stereo;
  Select(this->Layout, stereo.layout);
  Select(this->Resolution, stereo.resolution);
  Select(this->Mirror, stereo.mirror);
  this->Swap->setChecked(stereo.swapEyes);
  this->LifeSize->setChecked(stereo.lifeSize);
  this->FullScreen->setChecked(before.fullScreen);
  this->Known->setChecked(!stereo.screen.empty());
  if (!stereo.screen.empty())
  {
    const std::array<double, 2> size = ScreenSize(stereo.screen);
    this->Width->setValue(size[0]);
    this->Height->setValue(size[1]);
  }
  this->Distance->setValue(stereo.headMm ? (*stereo.headMm)[2] : 600.0);
  this->Eyes->setValue(stereo.eyeSeparationMm.value_or(63.0));
  this->Angle->setValue(stereo.eyeAngle.value_or(2.0));
  const std::string& head = before.head.source;
  const bool listed = this->Head->findData(QString::fromStdString(head)) >= 0;
  Select(this->Head, listed ? head : "other");
  this->HeadMore->setText(listed ? QString() : QString::fromStdString(head));
}

PlannerStereo StereoSettings::Choices() const
{
  PlannerStereo choices;
  StereoChoices& stereo = choices.stereo;
  stereo.layout = Selected(this->Layout);
  stereo.resolution = Selected(this->Resolution);
  stereo.mirror = Selected(this->Mirror);
  stereo.swapEyes = this->Swap->isChecked();
  choices.fullScreen = this->FullScreen->isChecked();
  if (this->Known->isChecked())
  {
    stereo.screen =
      QString("%1x%2").arg(this->Width->value()).arg(this->Height->value()).toStdString();
    stereo.headMm = { 0.0, 0.0, this->Distance->value() };
    stereo.eyeSeparationMm = this->Eyes->value();
    stereo.lifeSize = this->LifeSize->isChecked();
  }
  else
    stereo.eyeAngle = this->Angle->value();
  choices.head.source = Selected(this->Head);
  if (choices.head.source == "other")
    choices.head.source = this->HeadMore->text().toStdString();
  return choices;
}

void StereoSettings::Sketch()
{
  const bool known = this->Known->isChecked();
  for (QWidget* widget : std::initializer_list<QWidget*>{
         this->Width, this->Height, this->Distance, this->Eyes, this->LifeSize })
    widget->setEnabled(known);
  this->Angle->setEnabled(!known);
  this->HeadMore->setEnabled(Selected(this->Head) == "other");
  this->Drawing->setText(known ? QString() : tr("With the screen's size, a drawing of the desk."));
  this->Fault->clear();
  if (!known)
    return;
  try
  {
    SceneView& scene = this->Window.Parts().views.Scene();
    const vtkNew<vtkRenderer> stand; // for life size moves its camera
    stand->GetActiveCamera()->DeepCopy(scene.Renderer()->GetActiveCamera());
    const StereoView eyes(stand, scene.renderWindow(), this->Choices().stereo);
    const std::string png = eyes.SketchPng(Content(this->Window.Parts().scene));
    QPixmap picture;
    picture.loadFromData(reinterpret_cast<const uchar*>(png.data()), uint(png.size()), "PNG");
    this->Drawing->setPixmap(
      picture.scaled(this->Drawing->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation));
  }
  catch (const std::exception& error)
  {
    this->Fault->setText(QString::fromUtf8(error.what()));
  }
}

} // namespace hasp
