// A Falcon's model at the end of a serial line, for QEMU's FTDI chip: a pseudo-terminal, whose name
// is the first thing printed. QEMU sets its speed to that which the guest asked the chip for. Runs
// until its input ends.
//
// Its grip hangs on a spring of 0.2 N/mm, and the hand that homes it does so as soon as it is told
// to.
#include "FalconModel.h"

#include "Devices/Drivers/Falcon/FtdiLine.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace hasp;

namespace
{
constexpr double SpringNPerMm = 0.2, CountsPerNm = 5'000.0;

/// A terminal's speeds are few: QEMU takes the one that it finds nearest, so 143 kbaud is 230400.
std::uint16_t DivisorOf(speed_t speed)
{
  switch (speed)
  {
    case B9600:
      return FtdiBaud9600;
    case B230400:
      return FtdiBaud143k;
    case B1500000:
      return FtdiBaud1500k;
    default:
      return 0;
  }
}

class Line
{
public:
  Line() : Ours(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))
  {
    if (this->Ours < 0 || grantpt(this->Ours) != 0 || unlockpt(this->Ours) != 0)
      return;
    // Held open, so that it is a line before QEMU comes, too; and nothing is echoed meanwhile.
    this->Theirs = open(ptsname(this->Ours), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios is{};
    tcgetattr(this->Theirs, &is);
    cfmakeraw(&is);
    tcsetattr(this->Theirs, TCSANOW, &is);
  }
  ~Line()
  {
    close(this->Theirs);
    close(this->Ours);
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  bool Works() const { return this->Theirs >= 0; }
  int Handle() const { return this->Ours; }
  const char* Name() const { return ptsname(this->Ours); }
  speed_t Speed() const
  {
    termios is{};
    return tcgetattr(this->Ours, &is) == 0 ? cfgetospeed(&is) : B0;
  }

private:
  int Ours, Theirs = -1;
};

/// The speed is as QEMU's chip has it. Modem lines are none of a pseudo-terminal's, and follow from
/// it: for each beginning the driver lowers and raises DTR at 9600 baud, and lowers it for the fast
/// ones.
void SetSpeed(FalconModel& model, std::uint16_t divisor)
{
  model.Control(FtdiModemLines, FtdiDtrLow);
  if (divisor == FtdiBaud9600)
    model.Control(FtdiModemLines, FtdiDtrHigh);
  model.Control(FtdiBaudRate, divisor);
}

void Follow(FalconModel& model)
{
  model.PullOutAndPushIn();
  if (model.Told().motors != std::array<int, 3>{})
    model.MoveTo(model.ForceN(CountsPerNm) / SpringNPerMm);
}

/// What waits for the host, without the status bytes: those are QEMU's to add.
bool Answer(FalconModel& model, int line)
{
  std::array<std::uint8_t, 64> packet;
  while (model.HasAnswer())
  {
    const auto payload = std::span(packet).first(model.Send(packet)).subspan(2);
    if (write(line, payload.data(), payload.size()) != static_cast<ssize_t>(payload.size()))
      return false;
  }
  return true;
}
} // namespace

int main()
{
  const Line line;
  if (!line.Works())
  {
    std::perror("a pseudo-terminal");
    return 1;
  }
  std::puts(line.Name());
  std::fflush(stdout);

  FalconModel model(InventedFirmware());
  speed_t speed = B0;
  for (;;)
  {
    std::array<pollfd, 2> waits{ { { STDIN_FILENO, POLLIN, 0 }, { line.Handle(), POLLIN, 0 } } };
    // An answer that is not yet due is looked for again.
    poll(waits.data(), waits.size(), 1);
    if (waits[0].revents)
      break;
    model.nowNs =
      std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
    if (waits[1].revents & POLLIN)
    {
      std::array<std::uint8_t, 512> bytes;
      const ssize_t size = read(line.Handle(), bytes.data(), bytes.size());
      // The driver changes the speed only after an answer at the one before, or for a new
      // beginning.
      if (line.Speed() != speed)
        SetSpeed(model, DivisorOf(speed = line.Speed()));
      if (size > 0)
        model.Receive(std::span(bytes).first(static_cast<std::size_t>(size)));
      Follow(model);
    }
    if (!Answer(model, line.Handle()))
      break;
  }
  std::fprintf(stderr, "the model: %llu packets, %s\n",
    static_cast<unsigned long long>(model.Packets()),
    model.PushesNobody() ? "at rest" : "pushing still");
}
