#include "Window/KeysPage.h"

#include "Version.h"
#include "Window/PlannerWindow.h"

#include "vtkVersion.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace hasp
{
namespace
{
using Row = std::pair<QString, QString>;

QString Table(const QString& title, const std::vector<Row>& rows)
{
  QString html = "<h3>" + title.toHtmlEscaped() + "</h3><table cellpadding='3'>";
  for (const auto& [keys, does] : rows)
    html +=
      "<tr><td><b>" + keys.toHtmlEscaped() + "</b></td><td>" + does.toHtmlEscaped() + "</td></tr>";
  return html + "</table>";
}

void AddRows(const QMenu& menu, std::vector<Row>& rows)
{
  for (const QAction* action : menu.actions())
  {
    if (action->menu())
      AddRows(*action->menu(), rows);
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts())
      keys += key.toString(QKeySequence::NativeText);
    if (!keys.isEmpty())
      rows.emplace_back(keys.join(", "), action->text().remove('&'));
  }
}

QString MouseTables()
{
  return Table(PlannerWindow::tr("3D view"),
           { { PlannerWindow::tr("left drag"), PlannerWindow::tr("turns") },
             { PlannerWindow::tr("middle drag, Shift+left drag"), PlannerWindow::tr("moves") },
             { PlannerWindow::tr("right drag, wheel"), PlannerWindow::tr("zooms") },
             { PlannerWindow::tr("Ctrl+left drag"), PlannerWindow::tr("rolls") },
             { "r, f", PlannerWindow::tr("all in sight; turn about what is under the pointer") },
             { "5, w, s", PlannerWindow::tr("parallel projection; wireframe, surface of meshes") },
             { "3", PlannerWindow::tr("stereo on and off") },
             { PlannerWindow::tr("double click"), PlannerWindow::tr("one view or four") } }) +
         Table(PlannerWindow::tr("Slices"),
           { { PlannerWindow::tr("wheel, arrow keys, b, f"), PlannerWindow::tr("next slice") },
             { PlannerWindow::tr("left drag"),
               PlannerWindow::tr("window (sideways) and level (up, down)") },
             { PlannerWindow::tr("left click, Shift+move"),
               PlannerWindow::tr("crosshair, in all views") },
             { PlannerWindow::tr("right drag"), PlannerWindow::tr("zooms") },
             { PlannerWindow::tr("middle drag, Shift+left drag"), PlannerWindow::tr("moves") },
             { "r, v", PlannerWindow::tr("all in sight; show the slice in the 3D view") } }) +
         Table(PlannerWindow::tr("Tools"),
           { { "Esc", PlannerWindow::tr("puts the tool away") },
             { PlannerWindow::tr("paint: left drag"),
               PlannerWindow::tr("paints on bone; beside it turns the view") },
             { PlannerWindow::tr("paint: Shift+wheel, +, -"),
               PlannerWindow::tr("brush larger, smaller") },
             { PlannerWindow::tr("grab: left drag"), PlannerWindow::tr("takes a fragment along") },
             { PlannerWindow::tr("grab: wheel, middle drag"),
               PlannerWindow::tr("nearer and farther; turns it") },
             { PlannerWindow::tr("grab: Shift"),
               PlannerWindow::tr("the mouse moves and the fragment stays") },
             { PlannerWindow::tr("landmarks: click, drag"),
               PlannerWindow::tr("touches bone; moves a landmark") },
             { "Ins, Del",
               PlannerWindow::tr("landmark at the crosshair; removes the chosen one") } });
}

void Show(PlannerWindow& window, const QString& name, const QString& title, const QString& html)
{
  if (auto* open = window.findChild<QDialog*>(name))
    return open->raise();
  auto* page = new QDialog(&window);
  page->setAttribute(Qt::WA_DeleteOnClose);
  page->setObjectName(name);
  page->setWindowTitle(title);
  auto* text = new QTextBrowser;
  text->setObjectName(name + ".text");
  text->setHtml(html);
  auto* close = new QDialogButtonBox(QDialogButtonBox::Close);
  close->button(QDialogButtonBox::Close)->setObjectName(name + ".close");
  QObject::connect(close, &QDialogButtonBox::rejected, page, &QDialog::reject);
  auto* column = new QVBoxLayout(page);
  column->addWidget(text);
  column->addWidget(close);
  page->resize(560, 620);
  page->show();
}
} // namespace

void ShowKeysPage(PlannerWindow& window)
{
  std::vector<Row> rows;
  for (const QAction* action : window.menuBar()->actions())
    if (action->menu())
      AddRows(*action->menu(), rows);
  rows.emplace_back("Ctrl+1 … Ctrl+8", PlannerWindow::tr("the steps, from Import to Export"));
  rows.emplace_back("Ctrl+.", PlannerWindow::tr("gives up what is worked out"));
  Show(window, "page.keys", PlannerWindow::tr("Keys and mouse"),
    MouseTables() + Table(PlannerWindow::tr("Everywhere"), rows));
}

void ShowAboutPage(PlannerWindow& window)
{
  const QString html =
    "<h2>Hasp planner</h2><p><b>" +
    PlannerWindow::tr("Research use only, not a medical device. Not for clinical use.")
      .toHtmlEscaped() +
    "</b></p><p>" +
    PlannerWindow::tr("Version %1, commit %2; VTK %3, Qt %4.")
      .arg(Version(), Commit(), vtkVersion::GetVTKVersion(), qVersion())
      .toHtmlEscaped() +
    "</p><p>" +
    PlannerWindow::tr(
      "After F. Nysjö, Haptic Rendering and Interactive Surgery Planning, Uppsala University "
      "2020. BSD 3-Clause; with CGAL's mesh check the program is under the GPL.")
      .toHtmlEscaped() +
    "</p><p>" +
    PlannerWindow::tr(
      "Nothing leaves this machine: no network is used, and what is kept here names no patient.")
      .toHtmlEscaped() +
    "</p>";
  Show(window, "page.about", PlannerWindow::tr("About"), html);
}

} // namespace hasp
