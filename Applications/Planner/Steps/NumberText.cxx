#include "Steps/NumberText.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

namespace hasp
{

bool ReadNumbers(const QString& text, glm::dvec3& numbers)
{
  QString plain = text;
  plain.replace(QChar(0x2212), '-');
  const QStringList words =
    plain.split(QRegularExpression(QStringLiteral("[\\s;]+")), Qt::SkipEmptyParts);
  glm::dvec3 read(0.0);
  bool good = words.size() == 3;
  for (int n = 0; good && n < 3; ++n)
  {
    QString word = words[n];
    while (word.endsWith(',')) // "1, 2, 3"
      word.chop(1);
    read[n] = QLocale::c().toDouble(word, &good);
  }
  if (good)
    numbers = read;
  return good;
}

QString WriteNumbers(const glm::dvec3& numbers, int decimals)
{
  QStringList words;
  for (int n = 0; n < 3; ++n)
  {
    QString word = QString::number(numbers[n], 'f', decimals);
    if (word.toDouble() == 0.0 && word.startsWith('-'))
      word.remove(0, 1);
    words << word;
  }
  return words.join(' ');
}

} // namespace hasp
