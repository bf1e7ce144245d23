#pragma once
#include "Output/ReportContents.h"

#include <QByteArray>

#include <functional>

namespace hasp
{

/// "Research use only, not a medical device. Not for clinical use."
QString IntendedUse();

/// The address of picture n in a page.
using PictureSource = std::function<QString(std::size_t)>;

/// The report as an HTML page that is well-formed XML, too, and that Qt's rich text understands.
/// No script, no address but the pictures'. Internal to CaseReport. Any thread.
QString ReportHtml(const ReportContents& contents, const PictureSource& source);

/// The page with its pictures in itself. UTF-8.
QByteArray ReportPage(const ReportContents& contents);

/// The same as a PDF, A4; at the foot of each page what it may be used for and its number. It holds
/// no date, so that equal contents are equal bytes on one machine. Needs QApplication. RENDER.
QByteArray ReportPdf(const ReportContents& contents);

} // namespace hasp
