// What is written over the views: the cube, letters, rulers.
#include "View/OrientationCube.h"
#include "View/SliceMarks.h"
#include "View/ViewMarks.h"

#include <QImage>
#include <QPainter>

#include <gtest/gtest.h>

#include <set>

#include <glm/geometric.hpp>

namespace
{

using namespace hasp;

QRect Painted(const QImage& image)
{
  QRect box;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (qAlpha(image.pixel(x, y)) > 0)
        box |= QRect(x, y, 1, 1);
  return box;
}

QImage Paper(int width, int height)
{
  QImage paper(width, height, QImage::Format_ARGB32_Premultiplied);
  paper.fill(Qt::transparent);
  return paper;
}

TEST(OrientationCube, ShowsTheSidesThatFaceTheViewer)
{
  const auto letters = [](const ViewAxes& axes)
  {
    std::set<QString> seen;
    for (const CubeSide& side : VisibleSides(axes, { 0, 0 }, 10.0))
      seen.insert(side.letter);
    return seen;
  };
  // From the front: the patient's left is at the right.
  const ViewAxes front{ { 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 } };
  EXPECT_EQ(letters(front), std::set<QString>{ "A" });
  const glm::dvec3 towards = glm::normalize(glm::dvec3(-0.5, -0.7, 0.4)); // from the right, above
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), towards));
  const ViewAxes oblique{ right, glm::cross(towards, right), towards };
  EXPECT_EQ(letters(oblique), (std::set<QString>{ "A", "R", "S" }));
  // Letters are upright: what is up in the letter is up on the screen.
  const CubeSide side = VisibleSides(front, { 100, 100 }, 10.0).front();
  EXPECT_EQ(side.lettering.map(QPointF(0, -1)), QPointF(100, 90));
  EXPECT_EQ(side.lettering.map(QPointF(1, 0)), QPointF(110, 100));
}

TEST(ViewMarks, RulersHaveRoundLengthsThatFit)
{
  EXPECT_DOUBLE_EQ(RulerLength(1.0, 99.0), 50.0);
  EXPECT_DOUBLE_EQ(RulerLength(1.0, 100.0), 100.0);
  EXPECT_DOUBLE_EQ(RulerLength(0.5, 99.0), 20.0);
  EXPECT_DOUBLE_EQ(RulerLength(0.001, 150.0), 0.1);
}

TEST(ViewMarks, ARulerIsAsLongAsItSays)
{
  QImage paper = Paper(300, 200);
  QPainter painter(&paper);
  PaintRuler(painter, paper.rect(), 0.7); // 50 mm are 71.4 pixels
  painter.end();
  // A line's dark edge is 1 pixel to each side.
  EXPECT_NEAR(Painted(paper).width(), 50.0 / 0.7 + 3.0, 2.0);
  QImage none = Paper(300, 200);
  QPainter nothing(&none);
  PaintRuler(nothing, none.rect(), 0.0);
  nothing.end();
  EXPECT_TRUE(Painted(none).isEmpty());
}

TEST(SliceMarks, EachLetterIsAtItsEdge)
{
  const auto where = [](QString SliceMarks::*letter)
  {
    QImage paper = Paper(200, 100);
    SliceMarks marks;
    marks.area = paper.rect();
    marks.frame = Qt::transparent;
    marks.*letter = "A";
    QPainter painter(&paper);
    PaintSliceMarks(painter, marks);
    painter.end();
    return Painted(paper).center();
  };
  EXPECT_LT(where(&SliceMarks::left).x(), 30);
  EXPECT_NEAR(where(&SliceMarks::left).y(), 50, 8);
  EXPECT_GT(where(&SliceMarks::right).x(), 170);
  EXPECT_LT(where(&SliceMarks::top).y(), 25);
  EXPECT_NEAR(where(&SliceMarks::top).x(), 100, 8);
  EXPECT_GT(where(&SliceMarks::bottom).y(), 75);
}

} // namespace
