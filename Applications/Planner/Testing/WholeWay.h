#pragma once
#include "PlannerDesk.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>

/// A desk at which cases are planned from the import to the export; what each of them does alike.
class WholeWay : public PlannerDesk
{
protected:
  using Json = nlohmann::json;

  static constexpr double LongS = 600.0; ///< for a job on a machine that has others to do

  std::string Path(const std::string& name) const { return (this->folder / name).string(); }
  /// The program in a large view, with patience for what takes long.
  std::unique_ptr<PlannerProcess> Begin(std::vector<std::string> words = {});

  ///@{
  /// In the step that it is done in, by its dialogue.
  static void Import(PlannerProcess& planner, const std::string& path);
  static void ImportFolder(PlannerProcess& planner, const std::string& path);
  static void ExportAll(PlannerProcess& planner, const std::string& folder);
  static void WriteReport(PlannerProcess& planner, const std::string& html);
  ///@}
  /// For the first time: it is asked where.
  static void SaveAs(PlannerProcess& planner, const std::string& folder);
  /// By its button. Expects that nothing is asked, nothing failed and nothing was written on its
  /// streams; prints what the user did and waited for.
  static void Close(PlannerProcess& planner, const std::string& called);
  /// Made in the step Check: all parts. What the message bar says then.
  static std::string MakeAll(PlannerProcess& planner);

  /// Expects that the folder is what bin/hasp makes anew of the plan that was saved, to the byte,
  /// and that certificates of all its parts hold.
  void ExpectSameAsRun(const std::string& plan, const std::string& scan, const std::string& parts);
  /// For a look: into the build folder.
  static void Picture(const PlannerProcess& planner, const std::string& name);
};

/// Names below a folder, and the bytes of the files.
std::map<std::string, std::string> FilesBelow(const std::filesystem::path& folder);
