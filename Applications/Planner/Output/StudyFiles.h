#pragma once
#include "Output/StepTimes.h"
#include "Planning/PlanFile.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// What trial this is: --study FOLDER --operator A --trial 3.
struct StudySettings
{
  /// Of one case: its trials lie side by side in it. Made if it is not there; its parent must be.
  std::filesystem::path folder;
  std::string operatorName; ///< a pseudonym: letters, digits, "_", "." and "-", at most 40
  int trial = 1;            ///< [1, 9999]
  double pauseS = 10.0;     ///< no longer pause counts as active time, (0, 600]
};

/// The files of a trial (StudyLog.h). Functions throw std::runtime_error where the disk refuses,
/// with what to do and without a path. Threads: RENDER.
class StudyFiles
{
public:
  /// Throws std::invalid_argument on settings that are none, std::runtime_error if the trial is
  /// there already.
  explicit StudyFiles(const StudySettings& of);
  ~StudyFiles();
  StudyFiles(const StudyFiles&) = delete;
  void operator=(const StudyFiles&) = delete;

  /// The log was there: a program has ended within the trial.
  bool IsAgain() const { return !this->Earlier.empty(); }
  /// What it kept of visits of steps. A line that a crash cut off is passed over.
  std::vector<StepTime> TimesInLog() const;

  /// A line more, which stays whatever becomes of this program.
  void Append(const nlohmann::ordered_json& line);
  /// The table, instead of an earlier one.
  void WriteTimes(const std::vector<StepTime>& times) const;
  /// The plan and its blobs, which are in `blobs`: all of it or nothing.
  void SavePlanOf(const PlanDocument& document, const std::filesystem::path& blobs) const;

private:
  std::filesystem::path Named(const std::string& ending) const;

  std::filesystem::path Folder;
  std::string Stem;    ///< "A-3"
  std::string Earlier; ///< the log as it was found
  bool IsCut = false;  ///< the log's last line has no end: a crash, or a full disk
  int Log = -1;        ///< descriptor
};

} // namespace hasp
