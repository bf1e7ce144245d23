#pragma once
#include <QCoreApplication>
#include <QString>

namespace hasp
{

struct MeshCheck;
struct Passport;
struct SurfacePassport;

/// What is known of a scan or of a surface, and what is wrong with it, as a page to be read: HTML
/// in the user's language. Passports hold no text of a patient, so neither do pages. Any thread.
class PassportPage
{
  Q_DECLARE_TR_FUNCTIONS(hasp::PassportPage)
public:
  static QString Of(const Passport& passport);
  static QString Of(const SurfacePassport& passport, const MeshCheck& mesh);
  /// Of a file that is refused for faults that are no data: its text.
  static QString OfFault(const QString& text);
  /// A fault's sentences without what they say to users of a command line.
  static QString FaultText(const std::string& text);
};

} // namespace hasp
