// A window with one widget of each kind, and its layout file: LayoutSubject --layout FILE
#include "Window/LayoutFile.h"

#include <nlohmann/json.hpp>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <cstdio>

namespace
{

template <typename T, typename... Arguments>
T* Named(const char* name, Arguments... arguments)
{
  auto* made = new T(arguments...);
  made->setObjectName(name);
  return made;
}

class Subject : public QMainWindow
{
public:
  Subject()
  {
    this->setObjectName("window");
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    for (QWidget* widget : this->Widgets())
      column->addWidget(widget);
    this->setCentralWidget(inside);
    QMenu* menu = this->menuBar()->addMenu("&Count");
    menu->setObjectName("menu.count");
    QAction* once = menu->addAction(
      "&Once more", [this] { this->Add(1); }, QKeySequence("Ctrl+M"));
    once->setObjectName("count.once");
  }

  bool busy = false;

private:
  QList<QWidget*> Widgets()
  {
    this->Counted = Named<QLabel>("count", "0");
    auto* once = Named<QPushButton>("add", "&Add");
    connect(once, &QPushButton::clicked, [this] { this->Add(1); });
    auto* slow = Named<QPushButton>("slow", "Slow");
    connect(slow, &QPushButton::clicked, [this] { this->Work(); });
    auto* ask = Named<QPushButton>("ask", "Ask");
    connect(ask, &QPushButton::clicked, [this] { this->Ask(); });
    auto* number = Named<QDoubleSpinBox>("number");
    number->setRange(-100.0, 100.0);
    number->setSuffix(" mm");
    auto* combo = Named<QComboBox>("combo");
    combo->addItems({ "one", "two", "three" });
    auto* list = Named<QListWidget>("list");
    for (const int id : { 7, 12 })
    {
      auto* item = new QListWidgetItem("sherd", list);
      item->setData(Qt::UserRole, id);
    }
    auto* secret = Named<QLabel>("secret", "guide 8: Sherd, left");
    auto* key = Named<QLabel>("keys", "");
    auto* line = Named<QLineEdit>("line");
    connect(line, &QLineEdit::returnPressed, [key] { key->setText("returned"); });
    auto* file = Named<QLabel>("file", "");
    auto* open = Named<QPushButton>("open", "Open");
    connect(open, &QPushButton::clicked,
      [this, file]
      { file->setText(QFileInfo(QFileDialog::getOpenFileName(this, "Open")).fileName()); });
    auto* quit = Named<QPushButton>("quit", "Quit");
    connect(quit, &QPushButton::clicked, qApp, &QApplication::quit);
    auto* off = Named<QPushButton>("off", "Off");
    off->setEnabled(false);
    auto* group = Named<QGroupBox>("group", "Group");
    group->setCheckable(true);
    return { this->Counted, quit, open, file, off, group, once, slow, ask, number, combo, list,
      secret, key, line, Named<QCheckBox>("check", "Chec&k"), this->Tabs(), this->Below() };
  }

  static QWidget* Tabs()
  {
    auto* tabs = Named<QTabWidget>("tabs");
    tabs->addTab(Named<QLabel>("first", "first page"), "First");
    tabs->addTab(Named<QLabel>("second", "second page"), "Second");
    return tabs;
  }

  /// A button that must be scrolled to.
  QWidget* Below()
  {
    auto* area = Named<QScrollArea>("area");
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    for (int n = 0; n < 20; ++n)
      column->addWidget(new QLabel("line"));
    auto* last = Named<QPushButton>("below", "Below");
    connect(last, &QPushButton::clicked, [this] { this->Add(10); });
    column->addWidget(last);
    area->setWidget(inside);
    area->setFixedHeight(100);
    return area;
  }

  void Add(int many)
  {
    this->Counted->setText(QString::number(this->Counted->text().toInt() + many));
  }

  void Work()
  {
    this->busy = true;
    QTimer::singleShot(1000, this,
      [this]
      {
        this->busy = false;
        this->Add(100);
      });
  }

  void Ask()
  {
    QMessageBox box(QMessageBox::Question, "Sure?", "Add a thousand?",
      QMessageBox::Yes | QMessageBox::Cancel, this);
    box.setObjectName("sure");
    if (box.exec() == QMessageBox::Yes)
      this->Add(1000);
  }

  QLabel* Counted = nullptr;
};

} // namespace

int main(int argc, char* argv[])
{
  QApplication application(argc, argv);
  if (argc != 3)
    return 2;
  Subject subject;
  const hasp::LayoutFile layout(
    argv[2],
    [&] {
      return nlohmann::ordered_json{ { "busy", subject.busy } };
    },
    [] { return QStringList{ "sherd" }; });
  QObject::connect(&layout, &hasp::LayoutFile::Failed,
    [](const QString& text) { std::fprintf(stderr, "%s\n", qUtf8Printable(text)); });
  subject.show();
  return QApplication::exec();
}
