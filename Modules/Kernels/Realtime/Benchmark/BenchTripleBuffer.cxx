// Nanoseconds of handing 248 bytes over, alone and with the other thread at it all the time, beside
// the same with a mutex. The least and the worst mean of 50 batches. Where other programs hold the
// cores, the two threads take turns and "the other" is not there most of the time.
#include "Realtime/TripleBuffer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <thread>
#include <utility>

namespace
{

using Payload = std::array<std::uint64_t, 31>;

/// The rival: what one would write first.
class Locked
{
public:
  void Write(const Payload& value)
  {
    const std::scoped_lock lock(this->Mutex);
    this->Value = value;
    this->New = true;
  }
  bool Read(Payload& value)
  {
    const std::scoped_lock lock(this->Mutex);
    value = this->Value;
    return std::exchange(this->New, false);
  }

private:
  std::mutex Mutex;
  Payload Value{};
  bool New = false;
};

class Swapped
{
public:
  void Write(const Payload& value) { this->Buffer.Write(value); }
  bool Read(Payload& value)
  {
    const bool fresh = this->Buffer.Update();
    if (const Payload* latest = this->Buffer.Latest())
      value = *latest;
    return fresh;
  }

private:
  hasp::TripleBuffer<Payload> Buffer;
};

template <class Body>
void Print(const char* who, const char* what, const Body& body)
{
  constexpr int Batches = 50, Calls = 400'000; // some milliseconds each
  double least = 1e300, most = 0;
  for (int batch = 0; batch < Batches; ++batch)
  {
    const auto start = std::chrono::steady_clock::now();
    for (int call = 0; call < Calls; ++call)
      body(call);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    least = std::min(least, spent.count() / Calls);
    most = std::max(most, spent.count() / Calls);
  }
  std::printf("%-14s %-32s %8.1f %8.1f\n", who, what, least, most);
}

/// Says so once, and costs a look afterwards.
void Started(std::atomic<bool>& running)
{
  if (!running.load(std::memory_order_relaxed))
  {
    running = true;
    running.notify_one();
  }
}

template <class Exchange>
void Measure(const char* who)
{
  Exchange exchange;
  Payload in{}, out{};
  std::uint64_t sum = 0;
  Print(who, "write, nobody reads",
    [&](int call)
    {
      in[0] = call;
      exchange.Write(in);
    });
  Print(who, "read, nobody writes",
    [&](int)
    {
      exchange.Read(out);
      sum += out[0];
    });
  {
    std::atomic<bool> running{ false };
    std::jthread reader(
      [&](const std::stop_token& stop)
      {
        for (Payload mine{}; !stop.stop_requested();)
        {
          exchange.Read(mine);
          Started(running);
        }
      });
    running.wait(false);
    Print(who, "write, the other reads always",
      [&](int call)
      {
        in[0] = call;
        exchange.Write(in);
      });
  }
  std::atomic<bool> running{ false };
  std::jthread writer(
    [&](const std::stop_token& stop)
    {
      for (Payload mine{}; !stop.stop_requested(); ++mine[0])
      {
        exchange.Write(mine);
        Started(running);
      }
    });
  running.wait(false);
  Print(who, "read, the other writes always",
    [&](int)
    {
      exchange.Read(out);
      sum += out[0];
    });
  if (sum == 1) // keeps what was read
    std::printf("\n");
}

} // namespace

int main()
{
  std::printf("%-14s %-32s %8s %8s\n", "248 bytes", "ns a call", "least", "worst");
  Measure<Swapped>("TripleBuffer");
  Measure<Locked>("std::mutex");
}
