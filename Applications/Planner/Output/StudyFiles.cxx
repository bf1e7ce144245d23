#include "Output/StudyFiles.h"

#include "Planning/DurableFile.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace hasp
{
namespace
{

namespace fs = std::filesystem;

constexpr std::size_t MostLog = std::size_t{ 256 } << 20;

void CheckSettings(const StudySettings& of)
{
  static const std::regex name("[A-Za-z0-9_][A-Za-z0-9_.-]{0,39}");
  if (!std::regex_match(of.operatorName, name))
    throw std::invalid_argument(
      "--operator must be 1 to 40 letters, digits, \"_\", \".\" or \"-\": "
      "a pseudonym, such as A");
  if (of.trial < 1 || of.trial > 9999)
    throw std::invalid_argument(
      "--trial is " + std::to_string(of.trial) + ", must be in [1, 9999]");
  if (!(of.pauseS > 0.0 && of.pauseS <= 600.0))
    throw std::invalid_argument("the longest active pause must be in (0, 600] s");
}

} // namespace

StudyFiles::StudyFiles(const StudySettings& of)
  : Folder(fs::absolute(of.folder / "").parent_path()) // "study" and "study/" alike
{
  CheckSettings(of);
  this->Stem = of.operatorName + "-" + std::to_string(of.trial);
  MakeFolderDurably(this->Folder, "the study's folder");
  std::error_code error;
  if (fs::exists(this->Named(".hasp"), error))
    throw std::runtime_error("trial " + std::to_string(of.trial) +
                             " of this operator has been done already: give --trial its next "
                             "number, or take the old one out of the study's folder");
  const fs::path log = this->Named(".jsonl");
  if (fs::exists(log, error))
    this->Earlier = ReadWhole(log, MostLog, "the trial's log");
  this->IsCut = !this->Earlier.empty() && this->Earlier.back() != '\n';
  this->Log = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (this->Log < 0)
    throw std::runtime_error(
      "the trial's log cannot be written: give --study a folder that can be, or free its disk");
}

StudyFiles::~StudyFiles()
{
  if (this->Log >= 0)
    close(this->Log);
}

fs::path StudyFiles::Named(const std::string& ending) const
{
  return this->Folder / (this->Stem + ending);
}

std::vector<StepTime> StudyFiles::TimesInLog() const
{
  std::vector<StepTime> times;
  std::istringstream lines(this->Earlier);
  for (std::string line; std::getline(lines, line);)
  {
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (json.is_object() && json.value("what", "") == "left")
      times.push_back({ json.value("step", ""), 1, json.value("active_s", 0.0), //
        json.value("wall_s", 0.0) });
  }
  return times;
}

void StudyFiles::Append(const nlohmann::ordered_json& line)
{
  // A line that was cut off is no part of this one.
  const std::string text = (this->IsCut ? "\n" : "") + line.dump() + "\n";
  const ssize_t written = write(this->Log, text.data(), text.size());
  this->IsCut = written > 0 ? text[std::size_t(written) - 1] != '\n' : this->IsCut;
  if (written != static_cast<ssize_t>(text.size()))
    throw std::runtime_error("the trial's log cannot be written");
  this->Earlier.clear();
}

void StudyFiles::WriteTimes(const std::vector<StepTime>& times) const
{
  std::string table = "step,visits,active_s,wall_s\n";
  for (const StepTime& time : times)
  {
    char line[120];
    std::snprintf(line, sizeof line, ",%d,%.3f,%.3f\n", time.visits, time.activeS, time.wallS);
    table += time.step + line;
  }
  WriteDurably(this->Named(".csv"), table, "the trial's table");
}

void StudyFiles::SavePlanOf(const PlanDocument& document, const fs::path& blobs) const
{
  fsync(this->Log); // before a plan says that the trial is done
  const fs::path aside = this->Folder / ("." + this->Stem + ".part");
  std::error_code error;
  fs::remove_all(aside, error);
  MakeFolderDurably(aside, "the trial's plan");
  try
  {
    for (const std::string& hash : BlobsOf(document))
      WriteBlob(aside, ReadBlob(blobs, hash));
    SavePlan(aside, document);
    fs::rename(aside, this->Named(".hasp"));
  }
  catch (const fs::filesystem_error&) // its text holds paths
  {
    fs::remove_all(aside, error);
    throw std::runtime_error("the trial's plan cannot be put in place");
  }
  catch (...)
  {
    fs::remove_all(aside, error);
    throw;
  }
}

} // namespace hasp
