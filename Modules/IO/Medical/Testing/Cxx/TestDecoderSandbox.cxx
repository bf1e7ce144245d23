#include "DicomFixture.h"

#include "vtkHaspFileNames.h"

#include <cstdlib>

namespace
{

/// A decoder in the real one's place that tries each forbidden thing (SandboxProbe.cxx), and what
/// the parent makes of its end.
class DecoderSandbox : public DicomFixture
{
protected:
  DecoderSandbox() { setenv("HASP_DICOM_DECODER", HASP_SANDBOX_PROBE, 1); }
  ~DecoderSandbox() override
  {
    unsetenv("HASP_DICOM_DECODER");
    unsetenv("HASP_PROBE_NO_FILTER");
  }
  void SetUp() override
  {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "AddressSanitizer itself makes the calls that the sandbox forbids";
#endif
  }
  /// The error that opening a folder with the file `<act>.dcm` ends in.
  std::string Try(const std::string& act) const
  {
    const auto folder = this->Folder / "acts";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    WriteBytes(folder / (act + ".dcm"), "untouched");
    std::string says;
    try
    {
      hasp::OpenVolume(folder.string());
    }
    catch (const std::runtime_error& error)
    {
      says = error.what();
    }
    // Whatever was tried, the folder is as it was.
    const auto files = std::filesystem::directory_iterator(folder);
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << act;
    EXPECT_EQ(ReadBytes(folder / (act + ".dcm")), "untouched") << act;
    return says;
  }
  void ExpectKilled(const std::string& act) const
  {
    const std::string says = this->Try(act);
    EXPECT_NE(says.find("tried what it may not do at " + act + ".dcm"), says.npos) << says;
  }
  void ExpectCode(const std::string& act, const char* code) const
  {
    const std::string says = this->Try(act);
    EXPECT_NE(says.find(std::string("code ") + code + " at"), says.npos) << act << ": " << says;
  }
  bool FiltersHere() const
  {
    return this->Try("state").find("code 70") != std::string::npos;
  }
};

TEST_F(DecoderSandbox, ForbiddenCallsEndTheChildAndAreNamed)
{
  if (!this->FiltersHere())
    GTEST_SKIP() << "this kernel or container takes no filter of system calls";
  for (const char* act : { "exec", "fork", "thread", "socket", "local socket", "write", "append",
         "both", "create", "touch", "truncate", "cut", "unlink", "rename", "link", "mkdir", "chmod",
         "ptrace", "kill", "code", "prctl" })
    this->ExpectKilled(act);
}

TEST_F(DecoderSandbox, LimitsHoldWithAndWithoutAFilter)
{
  for (const bool filtered : { true, false })
  {
    SCOPED_TRACE(filtered ? "as the kernel likes" : "filters refused");
    if (!filtered)
      setenv("HASP_PROBE_NO_FILTER", "1", 1);
    this->ExpectCode("read", "70"); // the probe can tell done from refused
    this->ExpectCode("memory", "71");
    this->ExpectCode("many files", "71");
    this->ExpectCode("descriptor", "71");
  }
}

TEST_F(DecoderSandbox, GoesOnWhereTheKernelRefusesFilters)
{
  setenv("HASP_PROBE_NO_FILTER", "1", 1);
  this->ExpectCode("state", "71");
  // What a limit alone stops: no file grows by a byte.
  const std::string says = this->Try("grow");
  EXPECT_NE(says.find("File size limit exceeded"), says.npos) << says;
}

TEST_F(DecoderSandbox, OfSeveralFilesTheRightOneIsNamed)
{
  if (!this->FiltersHere())
    GTEST_SKIP() << "this kernel or container takes no filter of system calls";
  hasp::ShowFileNames(false);
  const std::string says = this->Try("fork");
  hasp::ShowFileNames(true);
  EXPECT_NE(says.find("at file 1"), says.npos) << says;
  EXPECT_EQ(says.find("fork"), says.npos) << says;
}

} // namespace
