#include "Window/LayoutWidgets.h"

#include "Window/LayoutNames.h"
#include "Window/LayoutRects.h"

#include <nlohmann/json.hpp>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QSpinBox>
#include <QTabBar>
#include <QTextEdit>

#include <map>
#include <vector>

namespace hasp
{
namespace
{

using Json = nlohmann::ordered_json;

constexpr int MostRows = 500; // of a list that are looked at

Json JsonOf(const QRect& rect)
{
  return { rect.x(), rect.y(), rect.width(), rect.height() };
}

class Describer
{
public:
  explicit Describer(const QStringList& words) : Texts(words) {}

  /// What labels stand before, which are to be told before these are added.
  void Know(const QWidget& widget)
  {
    if (const auto* label = qobject_cast<const QLabel*>(&widget); label && label->buddy())
      this->LabelsOf[label->buddy()] = label->text();
  }

  void Add(const QWidget& widget)
  {
    const QString name = LayoutName(widget);
    if (!name.isEmpty())
    {
      Json entry = this->Entry(name, widget.metaObject()->className(), widget, widget.rect());
      entry["enabled"] = widget.isEnabled();
      if (const QRect hit = HitOf(widget); !hit.isEmpty())
        entry["hit"] = JsonOf(OnScreen(widget, hit));
      this->AddValue(widget, entry);
      if (const auto label = this->LabelsOf.find(&widget); label != this->LabelsOf.end())
        AddMnemonic(label->second, entry);
      this->AddRows(widget, entry);
      this->All.push_back(std::move(entry));
    }
    if (const auto* menu = qobject_cast<const QMenu*>(&widget))
      this->AddActions(*menu, [menu](QAction* of) { return menu->actionGeometry(of); });
    if (const auto* bar = qobject_cast<const QMenuBar*>(&widget))
      this->AddActions(*bar, [bar](QAction* of) { return bar->actionGeometry(of); });
  }

  Json All = Json::array();

private:
  Json Entry(const QString& name, const char* kind, const QWidget& of, const QRect& rect) const
  {
    const QRect all = OnScreen(of, rect), shown = Shown(of, rect), area = ShownOfArea(of);
    Json entry{ { "name", name.toStdString() }, { "class", kind }, { "rect", JsonOf(all) },
      { "shown", JsonOf(shown) } };
    if (shown != all && !area.isEmpty())
      entry["area"] = JsonOf(area);
    return entry;
  }

  void AddText(QString text, const QWidget& of, Json& entry) const
  {
    AddMnemonic(text, entry);
    if (!this->Texts.Hide(text, of))
      entry["text"] = text.remove('&').toStdString();
  }

  static void AddMnemonic(const QString& text, Json& entry)
  {
    if (const QKeySequence key = QKeySequence::mnemonic(text); !key.isEmpty())
      entry["mnemonic"] = key.toString().section('+', -1).toStdString();
  }

  void AddValue(const QWidget& widget, Json& entry) const
  {
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget))
    {
      this->AddText(button->text(), widget, entry);
      if (button->isCheckable())
        entry["checked"] = button->isChecked();
    }
    else if (const auto* group = qobject_cast<const QGroupBox*>(&widget))
    {
      this->AddText(group->title(), widget, entry);
      if (group->isCheckable())
        entry["checked"] = group->isChecked();
    }
    else if (const auto* label = qobject_cast<const QLabel*>(&widget))
      this->AddText(label->text(), widget, entry);
    else if (const auto* combo = qobject_cast<const QComboBox*>(&widget))
      entry.update(Json{ { "index", combo->currentIndex() }, { "count", combo->count() } });
    else if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
      entry["length"] = line->text().size();
    else if (const auto* text = qobject_cast<const QTextEdit*>(&widget))
      entry["length"] = text->document()->characterCount() - 1;
    else if (const auto* plain = qobject_cast<const QPlainTextEdit*>(&widget))
      entry["length"] = plain->document()->characterCount() - 1;
    else
      this->AddNumber(widget, entry);
  }

  void AddNumber(const QWidget& widget, Json& entry) const
  {
    if (const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget))
      this->AddText(box->text(), widget, entry);
    if (const auto* whole = qobject_cast<const QSpinBox*>(&widget))
      entry["value"] = whole->value();
    else if (const auto* real = qobject_cast<const QDoubleSpinBox*>(&widget))
      entry["value"] = real->value();
    else if (const auto* slider = qobject_cast<const QAbstractSlider*>(&widget))
      entry["value"] = slider->value();
    else if (const auto* bar = qobject_cast<const QProgressBar*>(&widget))
      entry["value"] = bar->value();
  }

  void AddRows(const QWidget& widget, Json& entry) const
  {
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget))
    {
      entry["rows"] = Json::array();
      int left = MostRows;
      if (view->model())
        AddIndices(*view, view->rootIndex(), left, entry["rows"]);
    }
    const auto* tabs = widget.findChild<QTabBar*>(QString(), Qt::FindDirectChildrenOnly);
    if (const auto* bar = qobject_cast<const QTabBar*>(&widget); bar || tabs)
      this->AddTabs(bar ? *bar : *tabs, entry);
  }

  static void AddIndices(
    const QAbstractItemView& view, const QModelIndex& parent, int& left, Json& rows)
  {
    const QAbstractItemModel& model = *view.model();
    for (int row = 0; row < model.rowCount(parent) && left > 0; ++row, --left)
    {
      for (int column = 0; column < model.columnCount(parent); ++column)
        AddIndex(view, model.index(row, column, parent), model.index(row, 0, parent), rows);
      AddIndices(view, model.index(row, 0, parent), left, rows);
    }
  }

  static void AddIndex(
    const QAbstractItemView& view, const QModelIndex& index, const QModelIndex& first, Json& rows)
  {
    const QRect rect = view.visualRect(index) & view.viewport()->rect();
    if (rect.isEmpty())
      return;
    Json row{ { "row", index.row() }, { "column", index.column() },
      { "rect", JsonOf(Shown(*view.viewport(), rect)) },
      { "selected", view.selectionModel() && view.selectionModel()->isSelected(index) } };
    const QVariant id = first.data(Qt::UserRole), checked = index.data(Qt::CheckStateRole);
    if (id.userType() == QMetaType::Int || id.userType() == QMetaType::UInt)
      row["id"] = id.toLongLong();
    if (checked.isValid())
      row["checked"] = checked.toInt() == Qt::Checked;
    rows.push_back(std::move(row));
  }

  void AddTabs(const QTabBar& tabs, Json& entry) const
  {
    entry["rows"] = Json::array();
    for (int n = 0; n < tabs.count(); ++n)
    {
      Json row{ { "row", n }, { "rect", JsonOf(Shown(tabs, tabs.tabRect(n))) },
        { "selected", n == tabs.currentIndex() } };
      this->AddText(tabs.tabText(n), tabs, row);
      entry["rows"].push_back(std::move(row));
    }
  }

  template <typename Geometry>
  void AddActions(const QWidget& of, const Geometry& geometry)
  {
    for (QAction* action : of.actions())
      if (const QString name = ActionName(*action); !name.isEmpty() && action->isVisible())
      {
        Json entry = this->Entry(name, "QAction", of, geometry(action));
        entry["enabled"] = action->isEnabled();
        this->AddText(action->text(), of, entry);
        if (action->isCheckable())
          entry["checked"] = action->isChecked();
        this->All.push_back(std::move(entry));
      }
  }

  LayoutTexts Texts;
  std::map<const QWidget*, QString> LabelsOf;
};

} // namespace

nlohmann::ordered_json DescribeWidgets(const QStringList& words)
{
  Describer describer(words);
  for (const QWidget* window : QApplication::topLevelWidgets())
    if (window->isVisible())
    {
      std::vector<const QWidget*> shown{ window };
      for (const QWidget* widget : window->findChildren<QWidget*>())
        if (widget->isVisible() && widget->window() == window)
          shown.push_back(widget);
      for (const QWidget* widget : shown)
        describer.Know(*widget);
      for (const QWidget* widget : shown)
        describer.Add(*widget);
    }
  return std::move(describer.All);
}

} // namespace hasp
