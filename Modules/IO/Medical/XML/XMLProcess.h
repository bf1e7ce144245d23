#pragma once
#include "Grid/Progress.h"
#include "Sandbox/ChildProcess.h"
#include "XML/XMLWire.h"

#include <type_traits>

namespace hasp
{

/// The child process that parses XML files, VTK's own or 3MF, which can crash their readers:
/// started for one file, read from as it answers, ended with this object. Errors as ChildProcess;
/// progress is reported and may cancel. One thread.
class XMLProcess
{
public:
  struct Limits
  {
    std::size_t memoryBytes; ///< of the child, all in all
    double silenceSeconds, totalSeconds;
    const char* memoryRemedy;
  };
  /// For the parser, a line of text, a block: beside the data and what the child holds at its
  /// start.
  static constexpr std::size_t RoomBytes = std::size_t(64) << 20;

  static const ChildProgram Vtk;     ///< hasp-xml-decode
  static const ChildProgram ThreeMf; ///< hasp-3mf-decode

  XMLProcess(const ChildProgram& program, const char* mode, const std::filesystem::path& file,
    const Limits& limits, const ProgressFunction& progress);

  /// Waits for the answer; its status is one that XMLWire.h names.
  template <typename Record>
  Record Answer()
  {
    static_assert(std::is_trivially_copyable_v<Record>);
    Record record{};
    this->AwaitAnswer();
    this->Read(&record, sizeof(record));
    if (record.status > static_cast<std::uint32_t>(XMLStatus::Last) || record.reserved != 0)
      this->ThrowGarbage("status");
    return record;
  }
  void Read(void* into, std::size_t size);
  void Finish();
  [[noreturn]] void ThrowGarbage(const std::string& what) const { Child.ThrowGarbage(what); }

private:
  void AwaitAnswer();
  void Beat() const { ReportProgress(this->Progress, this->Share); }

  const ProgressFunction Progress;
  double Share = 0.0;
  ChildProcess Child;
};

} // namespace hasp
