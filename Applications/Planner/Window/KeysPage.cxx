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

QString MouseTables(const PlannerWindow& window)
{
  return Table(window.tr("3D view"),
           { { window.tr("left drag"), window.tr("turns") },
             { window.tr("middle drag, Shift+left drag"), window.tr("moves") },
             { window.tr("right drag, wheel"), window.tr("zooms") },
             { window.tr("Ctrl+left drag"), window.tr("rolls") },
             { "r, f", window.tr("all in sight; turn about what is under the pointer") },
             { "5, w, s", window.tr("parallel projection; wireframe, surface of meshes") },
             { "3", window.tr("stereo on and off") },
             { window.tr("double click"), window.tr("one view or four") } }) +
         Table(window.tr("Slices"),
           { { window.tr("wheel, arrow keys, b, f"), window.tr("next slice") },
             { window.tr("left drag"), window.tr("window (sideways) and level (up, down)") },
             { window.tr("left click, Shift+move"), window.tr("crosshair, in all views") },
             { window.tr("right drag"), window.tr("zooms") },
             { window.tr("middle drag, Shift+left drag"), window.tr("moves") },
             { "r, v", window.tr("all in sight; show the slice in the 3D view") } }) +
         Table(window.tr("Tools"),
           { { "Esc", window.tr("puts the tool away") },
             { window.tr("paint: left drag"),
               window.tr("paints on bone; beside it turns the view") },
             { window.tr("paint: Shift+wheel, +, -"), window.tr("brush larger, smaller") },
             { window.tr("grab: left drag"), window.tr("takes a fragment along") },
             { window.tr("grab: wheel, middle drag"), window.tr("nearer and farther; turns it") },
             { window.tr("grab: Shift"), window.tr("the mouse moves and the fragment stays") },
             { window.tr("landmarks: click, drag"), window.tr("touches bone; moves a landmark") },
             { "Ins, Del", window.tr("landmark at the crosshair; removes the chosen one") } });
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
  rows.emplace_back("Ctrl+1 … Ctrl+8", window.tr("the steps, from Import to Export"));
  rows.emplace_back("Ctrl+.", window.tr("gives up what is worked out"));
  Show(window, "page.keys", window.tr("Keys and mouse"),
    MouseTables(window) + Table(window.tr("Everywhere"), rows));
}

void ShowAboutPage(PlannerWindow& window)
{
  const QString html =
    "<h2>Hasp planner</h2><p><b>" +
    window.tr("Research use only, not a medical device. Not for clinical use.").toHtmlEscaped() +
    "</b></p><p>" +
    window.tr("Version %1, commit %2; VTK %3, Qt %4.")
      .arg(Version(), Commit(), vtkVersion::GetVTKVersion(), qVersion())
      .toHtmlEscaped() +
    "</p><p>" +
    window
      .tr("After F. Nysjö, Haptic Rendering and Interactive Surgery Planning, Uppsala University "
          "2020. BSD 3-Clause; with CGAL's mesh check the program is under the GPL.")
      .toHtmlEscaped() +
    "</p><p>" +
    window
      .tr(
        "Nothing leaves this machine: no network is used, and what is kept here names no patient.")
      .toHtmlEscaped() +
    "</p>";
  Show(window, "page.about", window.tr("About"), html);
}

} // namespace hasp
