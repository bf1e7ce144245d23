#include "XML/XMLProcess.h"
#include "Files/FileError.h"

#include <cmath>
#include <system_error>

namespace hasp
{
namespace
{

/// What a sound file may honestly take between two signs of life: VTK parses text, its slowest
/// form, twelve times as fast on one core.
double WorkSeconds(const std::filesystem::path& file)
{
  constexpr double slowestBytesPerSecond = 8 << 20;
  std::error_code error;
  const auto bytes = std::filesystem::file_size(file, error);
  return error ? 0.0 : double(bytes) / slowestBytesPerSecond;
}

} // namespace

const ChildProgram XMLProcess::Vtk = { "hasp-xml-decode", "HASP_XML_DECODER",
  "the reader of VTK's XML files" };
const ChildProgram XMLProcess::ThreeMf = { "hasp-3mf-decode", "HASP_3MF_DECODER",
  "the reader of 3MF files" };

XMLProcess::XMLProcess(const ChildProgram& program, const char* mode,
  const std::filesystem::path& file, const Limits& limits, const ProgressFunction& progress)
  : Progress(progress),
    Child({ program.file, mode, std::to_string(limits.memoryBytes),
            std::to_string(static_cast<long>(std::ceil(limits.totalSeconds)) + 1) },
      file.native() + '\0',
      { .program = program,
        .memoryBytes = limits.memoryBytes,
        .silenceSeconds = [most = limits.silenceSeconds + WorkSeconds(file)] { return most; },
        .totalSeconds = limits.totalSeconds,
        .remedy = "The file is damaged; write it again",
        .memoryRemedy = limits.memoryRemedy,
        .endings = {},
        .at = [file] { return " at " + FileLabel(file); } })
{
}

void XMLProcess::AwaitAnswer()
{
  for (;;)
  {
    XMLFrame frame{};
    this->Read(&frame, sizeof(frame));
    if (frame.magic != XMLFrame::Magic || frame.kind > XMLFrame::Answer ||
        !(frame.share >= 0.0 && frame.share <= 1.0))
      this->ThrowGarbage("frame");
    this->Share = frame.share;
    if (frame.kind == XMLFrame::Answer)
      return;
  }
}

void XMLProcess::Read(void* into, std::size_t size)
{
  this->Child.Read(into, size, [this] { this->Beat(); });
}

void XMLProcess::Finish()
{
  this->Child.Finish([this] { this->Beat(); });
}

} // namespace hasp
