#include "OffscreenQt.h"
#include "Output/SusForm.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QLabel>
#include <QTest>

#include <memory>
#include <set>
#include <stdexcept>

using namespace hasp;

namespace
{

class SusFormTest : public testing::Test
{
protected:
  SusFormTest()
  {
    UseOffscreenQt();
    this->form = std::make_unique<SusForm>();
    this->form->show();
    EXPECT_TRUE(QTest::qWaitForWindowActive(this->form.get()));
  }
  QAbstractButton* Button(const QString& name) const
  {
    auto* button = this->form->findChild<QAbstractButton*>(name);
    EXPECT_NE(button, nullptr) << name.toStdString();
    return button;
  }
  void Press(int key) const { QTest::keyClick(this->form->focusWidget(), Qt::Key(key)); }

  std::unique_ptr<SusForm> form;
};

TEST(SusScore, RefusesAnswersThatAreNone)
{
  EXPECT_THROW(SusScore({}), std::invalid_argument);
  EXPECT_THROW(SusScore({ 3, 3, 3, 3, 3, 3, 3, 3, 3, 6 }), std::invalid_argument);
}

TEST(SusScore, IsThatOfThePaper)
{
  EXPECT_EQ(SusScore({ 5, 4, 2, 1, 2, 3, 2, 4, 5, 2 }), 55.0); // Brooke 1996, its example
  EXPECT_EQ(SusScore({ 5, 1, 5, 1, 5, 1, 5, 1, 5, 1 }), 100.0);
  EXPECT_EQ(SusScore({ 1, 5, 1, 5, 1, 5, 1, 5, 1, 5 }), 0.0);
  EXPECT_EQ(SusScore({ 3, 3, 3, 3, 3, 3, 3, 3, 3, 3 }), 50.0);
}

TEST_F(SusFormTest, IsHandedInWhenAllIsAnswered)
{
  for (int n = 1; n <= 10; ++n)
  {
    EXPECT_FALSE(this->form->Answers());
    EXPECT_FALSE(this->Button("sus.save")->isEnabled());
    QTest::mouseClick(this->Button(QString("sus.%1.%2").arg(n).arg(1 + n % 5)), Qt::LeftButton, {},
      QPoint(8, 8)); // a radio button's left end
  }
  EXPECT_EQ(this->form->Answers(), (SusAnswers{ 2, 3, 4, 5, 1, 2, 3, 4, 5, 1 }));
  QTest::mouseClick(this->Button("sus.save"), Qt::LeftButton);
  EXPECT_EQ(this->form->result(), QDialog::Accepted);
}

TEST_F(SusFormTest, IsFilledInByTheKeyboardAlone)
{
  for (const int answer : { 4, 2, 5, 1, 4, 2, 5, 1, 4, 2 })
    this->Press(Qt::Key_0 + answer);
  QTest::keyClick(this->form->focusWidget(), Qt::Key_Tab, Qt::ShiftModifier); // back to the last
  this->Press(Qt::Key_3);
  EXPECT_EQ(this->form->Answers(), (SusAnswers{ 4, 2, 5, 1, 4, 2, 5, 1, 4, 3 }));
  EXPECT_EQ(this->form->focusWidget(), this->Button("sus.save"));
  this->Press(Qt::Key_Space);
  EXPECT_EQ(this->form->result(), QDialog::Accepted);
}

TEST_F(SusFormTest, UpAndDownGoFromStatementToStatement)
{
  this->Press(Qt::Key_Down);
  this->Press(Qt::Key_Down);
  this->Press(Qt::Key_Up);
  this->Press(Qt::Key_5);
  EXPECT_TRUE(this->Button("sus.2.5")->isChecked());
  EXPECT_FALSE(this->Button("sus.1.1")->isChecked());
}

TEST_F(SusFormTest, HasTheTenStatementsOnceEach)
{
  std::set<QString> texts;
  for (const QLabel* label : this->form->findChildren<QLabel*>())
    if (label->text().at(0).isDigit())
      texts.insert(label->text());
  EXPECT_EQ(texts.size(), SusItems);
}

} // namespace
