#pragma once
#include "HaspProcess.h"
#include "TestScreen.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <csignal>

using Words = std::vector<std::string>;

/// bin/hasp view on a phantom.
class HaspView : public HaspTest
{
protected:
  Words View(const Words& more) const
  {
    Words words{ "view", this->Path("head.mha"), "--resolution", "200,150" };
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// Width and height out of the PNG's header.
  std::pair<int, int> Size(const std::string& name) const
  {
    const std::string png = ReadBytes(this->Path(name));
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto number = [&](std::size_t at)
    {
      return 256 * static_cast<unsigned char>(png.at(at + 2)) +
             static_cast<unsigned char>(png.at(at + 3));
    };
    return { number(16), number(20) };
  }
};

/// bin/hasp view, running.
class OpenView
{
public:
  OpenView(const Words& words, const std::string& display)
    : Null(open("/dev/null", O_WRONLY | O_CLOEXEC)),
      Child(StartHasp(words, this->Null, display))
  {
  }
  ~OpenView()
  {
    close(this->Null);
    if (this->Child > 0)
    {
      kill(this->Child, SIGKILL);
      waitpid(this->Child, nullptr, 0);
    }
  }
  int ExitCode()
  {
    int status = 0;
    waitpid(this->Child, &status, 0);
    this->Child = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  /// Milliseconds that its threads compute in the next half second.
  double Computes() const
  {
    clockid_t clock = 0;
    clock_getcpuclockid(this->Child, &clock);
    const auto now = [clock]
    {
      timespec time{};
      clock_gettime(clock, &time);
      return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
    };
    const double before = now();
    const timespec span{ 0, 500'000'000 };
    nanosleep(&span, nullptr);
    return now() - before;
  }

private:
  int Null;
  pid_t Child;
};

#define REQUIRE_SCREEN(screen)                                                                     \
  if (screen.Display().empty())                                                                    \
  GTEST_SKIP() << "no Xvfb (Debian: xvfb)"
