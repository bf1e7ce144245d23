#include "Window/MessageBar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace hasp
{

MessageBar::MessageBar(QWidget* parent) : QFrame(parent), Words(new QLabel)
{
  this->setFrameShape(QFrame::StyledPanel);
  this->Words->setObjectName("message.text");
  this->Words->setWordWrap(true);
  this->Words->setTextFormat(Qt::PlainText); // an error's text is no markup
  this->Words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* close = new QToolButton;
  close->setObjectName("message.close");
  close->setText(tr("Close"));
  this->connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(this->Words, 1);
  row->addWidget(close);
  this->hide();
}

void MessageBar::Say(const QString& text, bool fault)
{
  this->Last = text;
  this->Words->setText(fault ? tr("Fault: %1").arg(text) : text);
  this->setStyleSheet(fault ? "hasp--MessageBar { background: #7a1f1f; } QLabel { color: white; }"
                            : "hasp--MessageBar { background: #20435c; } QLabel { color: white; }");
  this->setVisible(!text.isEmpty());
}

} // namespace hasp
