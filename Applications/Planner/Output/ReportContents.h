#pragma once
#include <QByteArray>
#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <vector>

/// What a case report says, before it is laid out. Texts are plain: whoever lays them out escapes
/// them. Internal to CaseReport.
namespace hasp
{

/// tr() of all that makes a report.
struct ReportText
{
  Q_DECLARE_TR_FUNCTIONS(CaseReport)
};

struct ReportTable
{
  QString title;
  QString note; ///< below the title; may be empty
  QStringList columns;
  std::vector<QStringList> rows; ///< each as long as `columns`
};

struct ReportPicture
{
  QString caption;
  QByteArray png;
};

struct ReportContents
{
  QString title;    ///< with the case label
  QStringList lead; ///< sentences that sum it up
  std::vector<ReportTable> tables;
  std::vector<ReportPicture> pictures;
  QStringList missing; ///< what pictures do not show, and why; sentences
};

/// "12.30": as many digits on every machine and in every language; never "-0.00".
QString Decimal(double value, int digits);

} // namespace hasp
