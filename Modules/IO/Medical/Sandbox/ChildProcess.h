#pragma once
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hasp
{

/// A program of ours that parses what others wrote, so that a bad file ends the child and not us.
struct ChildProgram
{
  std::string file;     ///< "hasp-dicom-decode"
  std::string variable; ///< of the environment, overrides where the program is
  std::string name;     ///< as errors call it: "the DICOM decoder"
};

/// The limits of a child, and what errors say of it.
struct ChildSettings
{
  ChildProgram program;
  std::size_t memoryBytes = 0;            ///< which the child was told to keep to
  std::function<double()> silenceSeconds; ///< ended after so long without a byte, asked each time
  double totalSeconds = 0.0;              ///< or after so long in all
  std::string remedy;                 ///< a sentence without its stop: "Export the series again"
  std::string memoryRemedy;           ///< what to do if it needs more, from the comma or colon on
  std::map<int, std::string> endings; ///< exit codes with a sentence of their own; 3 is "memory"
  std::function<std::string()> at;    ///< " at file 7": what it is busy with; may be empty
};

/// A child process that is started with a list on its standard input, read from as it answers on
/// its standard output, and ended with this object whatever happens. Its standard error goes
/// nowhere, and it inherits nothing else but the environment.
///
/// Every failure throws std::runtime_error that says what the child did (crashed, fell silent, ran
/// out of memory, tried what is forbidden, sent what is no answer), at what, and what to do. One
/// thread at a time.
class ChildProcess
{
public:
  /// Called at least twice a second while the child is waited for; may throw.
  using Beat = std::function<void()>;

  /// `words` are its arguments, the first being its own name; `input` is all it will read.
  ChildProcess(std::vector<std::string> words, std::string_view input, ChildSettings settings);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The next bytes; that there are fewer is an error.
  void Read(void* into, std::size_t size, const Beat& beat);
  /// After the last answer: nothing more may come, and the child is ended.
  void Finish(const Beat& beat);
  /// For the reader of an answer that is none.
  [[noreturn]] void ThrowGarbage(const std::string& what) const;

private:
  using Clock = std::chrono::steady_clock;
  std::size_t ReadSome(void* into, std::size_t size, const Beat& beat);
  [[noreturn]] void ThrowEnded();
  std::string At() const { return this->Settings.at ? this->Settings.at() : std::string(); }
  int Reap(); ///< wait status, once the child has closed its output

  const ChildSettings Settings;
  Clock::time_point Started;
  int Output = -1; ///< our end of the child's standard output
  int Child = -1;  ///< its process id; -1 once reaped
};

/// Where a program of ours is: its variable of the environment, else beside this library. Throws
/// std::runtime_error if it is nowhere.
std::filesystem::path FindProgram(const ChildProgram& program);

} // namespace hasp
