#pragma once
#include "Output/PartFacts.h"

#include <QDialog>

namespace hasp
{

/// The page of a part's certificate, to be read and saved: that of `hasp run --html`, without its
/// pictures, for the views show the part. Widgets: check.page.text, check.page.save.
/// Threads: RENDER.
class CertificateDialog : public QDialog
{
  Q_OBJECT
public:
  CertificateDialog(Planner& planner, const PartFacts& facts, QWidget* parent = nullptr);

private:
  void Save();

  Planner& Of;
  QString Called;
  std::string Html;
};

} // namespace hasp
