#pragma once
#include "Planning/PlanFile.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hasp
{

class PlanJournal;

/// The plan that is worked on: every action of the window is an edit here, is undone here, and is
/// in a journal before the next one. A plan is worked on in a folder of the planner's own (blobs
/// and journal; WorkFolder.h) and goes to the user's folder, whole or not at all, when it is saved.
///
/// Threads: RENDER. Errors are told by Refused (an action: nothing has changed) and Warned (it has,
/// but something is not as it should be: a full disk under the journal); never by exceptions. Texts
/// name objects by kind and id, no path, no text of the plan.
class PlanSession : public QObject
{
  Q_OBJECT
public:
  /// `work`: the folder it works in, made already.
  explicit PlanSession(const std::filesystem::path& work, QObject* parent = nullptr);
  ~PlanSession() override;

  const Plan& Now() const { return this->Kept->history.Current(); }
  const PlanDocument& Document() const { return *this->Kept; }
  PlanId NewId() const { return this->Kept->history.NewId(); }
  /// For vtkHaspReductionSession, which makes steps of its own: call Took after each.
  std::shared_ptr<PlanHistory> History() const;
  /// Where blobs are: for ReadBlob and StoreLabels.
  const std::filesystem::path& Folder() const { return this->Work; }

  ///@{
  /// One step. False after Refused.
  bool Do(std::vector<PlanEdit> edits, const QString& label = {});
  bool Do(PlanEdit edit, const QString& label = {});
  void Undo();
  void Redo();
  /// Steps have been made in History(), by somebody else.
  void Took();
  ///@}
  /// Keeps a part that was made; in the journal, no step of the history.
  void KeepMade(DerivedPart part);
  /// Puts bytes beside the plan. Empty after Refused.
  std::string StoreBlob(std::string_view bytes);

  ///@{
  /// Another plan. False after Refused, and the old one stays. What was not saved is the caller's
  /// to ask about.
  void BeginNew();
  bool Open(const std::filesystem::path& folder);
  /// What a journal gave back; blobs are taken from its folder. `place`: where it had been saved;
  /// empty: nowhere, or that is not known.
  bool Recover(const std::filesystem::path& crashedWork, const std::filesystem::path& place = {});
  ///@}
  ///@{
  /// Saves. Refused where the plan on disk is another than the one that was opened or saved last:
  /// somebody else has changed it.
  bool Save();
  bool SaveAs(const std::filesystem::path& folder);
  ///@}
  bool HasPlace() const { return !this->Place.empty(); }
  const std::filesystem::path& SavedIn() const { return this->Place; } ///< never shown
  bool IsModified() const; ///< since it was opened or saved
  /// All of it is in the journal. False after Warned: a crash would take it.
  bool IsJournalled() const { return this->Journal && !this->JournalFails; }

  /// "guide 8 is out of date: cut 6 has changed", "guide 8 has not been made"; empty: it is in
  /// date.
  QString WhyNot(PlanId object) const;

Q_SIGNALS:
  void Changed();      ///< the plan is another: a step, an undo, a redo, another plan
  void PartsChanged(); ///< what was made of it
  void Replaced();     ///< by BeginNew, Open, Recover; before Changed
  void SavedChanged(); ///< IsModified, SavedIn
  void Refused(const QString& text);
  void Warned(const QString& text);

private:
  void Write(bool isSaved = false); ///< into the journal; isSaved: it begins with Saved
  void Put(PlanDocument document, std::filesystem::path place, PlanDocument saved);
  /// Bytes that the document names; those that are there already stay as they are.
  static void CopyBlobs(const std::filesystem::path& from, const std::filesystem::path& to,
    const PlanDocument& document);
  void SaveIn(const std::filesystem::path& folder);
  void CheckPlace(const std::filesystem::path& folder) const; ///< throws if it is another's
  void RemoveUnused();

  std::filesystem::path Work, Place, TriedIn;
  std::shared_ptr<PlanDocument> Kept;
  PlanDocument Saved; ///< as on disk; of a plan without a place: as it began
  PlanDocument Tried; ///< to save in TriedIn, whether that went well or not
  std::unique_ptr<PlanJournal> Journal;
  bool JournalFails = false; ///< it has been said
};

} // namespace hasp
