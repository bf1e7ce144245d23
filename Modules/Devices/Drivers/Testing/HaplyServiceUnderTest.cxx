#include "HaplyServiceUnderTest.h"

#include <nlohmann/json.hpp>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;
using End = HaplyScript::End;
using Stream = beast::websocket::stream<tcp::socket&>;

std::string InverseMessage(const glm::dvec3& p, const std::string& more)
{
  const nlohmann::json json = { { "session_id", 7 },
    { "inverse3",
      { { { "device_id", "049D" },
        { "state", { { "cursor_position", { { "x", p.x }, { "y", p.y }, { "z", p.z } } },
                     { "control_mode", "idle" } } },
        { "status", { { "calibrated", true }, { "ready", true } } } } } },
    { "wireless_verse_grip",
      { { { "device_id", "61548" },
        { "state", { { "orientation", { { "w", 0.0 }, { "x", 0.0 }, { "y", 0.6 }, { "z", 0.8 } } },
                     { "buttons", { { "a", false }, { "b", true } } } } } } } } };
  std::string text = json.dump();
  if (!more.empty())
    text.insert(1, more + ",");
  return text;
}

class HaplyServiceUnderTest::Impl
{
public:
  explicit Impl(const HaplyScript& script)
    : Acceptor(this->Context, { asio::ip::address_v4::loopback(), 0 }),
      Script(script),
      Thread([this] { this->Serve(); })
  {
  }
  ~Impl()
  {
    {
      const std::lock_guard lock(this->Mutex);
      this->Stopping = true;
      if (this->Current >= 0)
        shutdown(this->Current, SHUT_RDWR); // wakes whoever reads or writes there
    }
    this->Changed.notify_all();
    tcp::socket wake(this->Context); // whoever accepts
    beast::error_code ignored;
    wake.connect(this->Acceptor.local_endpoint(), ignored);
    this->Thread.join();
  }

  void Serve()
  {
    for (;;)
    {
      tcp::socket socket(this->Context);
      beast::error_code error;
      this->Acceptor.accept(socket, error);
      HaplyScript script;
      {
        const std::lock_guard lock(this->Mutex);
        if (this->Stopping)
          return;
        this->Current = error ? -1 : socket.native_handle();
        script = this->Script;
      }
      try
      {
        this->Talk(socket, script);
      }
      catch (const beast::system_error& end)
      {
        const std::lock_guard lock(this->Mutex);
        this->GoodbyeCount += end.code() == beast::websocket::error::closed;
      }
      if (script.reset)
        socket.set_option(asio::socket_base::linger(true, 0), error);
      const std::lock_guard lock(this->Mutex);
      this->Current = -1;
      socket.close(error);
      ++this->Ends;
      this->Changed.notify_all();
    }
  }

  void Talk(tcp::socket& socket, const HaplyScript& script)
  {
    if (script.end == End::AtOnce)
      return;
    if (script.end == End::Silent)
      return this->UntilTheyLeave(socket);
    const std::string raw = RawAnswer(script.end);
    if (!raw.empty())
      return this->AnswerRaw(socket, script, raw);
    Stream stream(socket);
    stream.accept();
    stream.text(true);
    if (script.end == End::BeforeAll)
      return;
    for (int n = 0;; ++n)
    {
      for (int repeat = 0; repeat < script.repeats; ++repeat)
        if (const auto text = script.message(n))
          if (!this->Say(stream, script, n, *text))
            return;
      this->Hear(stream);
    }
  }

  /// False: it ends here.
  bool Say(Stream& stream, const HaplyScript& script, int n, const std::string& text)
  {
    const bool here = n == script.last;
    if (!here || (script.end != End::InMessage && script.end != End::HalfHeld))
    {
      stream.write(asio::buffer(text));
      return !(here && script.end == End::AfterMessage);
    }
    // A frame by hand, RFC 6455 5.2: final, text, not masked, its length in 7 or in 16 bits.
    std::string frame{ char(0x81) };
    if (text.size() < 126)
      frame += char(text.size());
    else
      frame += { char(126), char(text.size() >> 8 & 255), char(text.size() & 255) };
    frame += text;
    const std::size_t half = frame.size() / 2;
    asio::write(stream.next_layer(), asio::buffer(frame.data(), half));
    if (script.end == End::InMessage)
      return false;
    this->Hear(stream);
    asio::write(stream.next_layer(), asio::buffer(frame.data() + half, frame.size() - half));
    return true;
  }

  void Hear(Stream& stream)
  {
    beast::flat_buffer heard;
    stream.read(heard);
    const auto json = nlohmann::json::parse(beast::buffers_to_string(heard.data()), nullptr, false);
    const std::lock_guard lock(this->Mutex);
    try
    {
      const auto& device = json.at("inverse3").at(0);
      const auto& f = device.at("commands").at("set_cursor_force").at("values");
      this->Heard.push_back(
        { f.at("x").get<double>(), f.at("y").get<double>(), f.at("z").get<double>() });
      this->For.push_back(device.at("device_id").get<std::string>());
    }
    catch (const nlohmann::json::exception&)
    {
      ++this->StrangeCount;
    }
  }

  static std::string RawAnswer(End end)
  {
    switch (end)
    {
      case End::InHandshake:
        return "HTTP/1.1 101 Switching Proto";
      case End::Drip:
        return "HTTP/1.1 101 Switching Protocols\r\nServer: " + std::string(4000, 'a');
      case End::EndlessHeader:
        return "HTTP/1.1 101 Switching Protocols\r\nServer: " + std::string(1 << 20, 'a');
      case End::NotFound:
        return "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n";
      case End::NotSpeaking:
        return "220 mail at your service\r\n";
      default:
        return {};
    }
  }

  void AnswerRaw(tcp::socket& socket, const HaplyScript& script, const std::string& raw)
  {
    std::array<char, 4096> request;
    socket.read_some(asio::buffer(request));
    if (script.end != End::Drip)
    {
      asio::write(socket, asio::buffer(raw));
      if (script.end != End::InHandshake)
        this->UntilTheyLeave(socket);
      return;
    }
    for (const char byte : raw)
    {
      asio::write(socket, asio::buffer(&byte, 1)); // throws once they have left
      std::unique_lock lock(this->Mutex);
      if (this->Changed.wait_for(
            lock, std::chrono::milliseconds(5), [this] { return this->Stopping; }))
        return;
    }
  }

  void UntilTheyLeave(tcp::socket& socket)
  {
    std::array<char, 4096> heard;
    for (;;)
      socket.read_some(asio::buffer(heard)); // throws then
  }

  asio::io_context Context;
  tcp::acceptor Acceptor;
  mutable std::mutex Mutex;
  mutable std::condition_variable Changed;
  HaplyScript Script;
  std::vector<glm::dvec3> Heard;
  std::vector<std::string> For;
  int Ends = 0, GoodbyeCount = 0, StrangeCount = 0;
  int Current = -1;
  bool Stopping = false;
  std::thread Thread;
};

HaplyServiceUnderTest::HaplyServiceUnderTest(const HaplyScript& script)
  : Self(std::make_unique<Impl>(script))
{
}
HaplyServiceUnderTest::~HaplyServiceUnderTest() = default;

std::uint16_t HaplyServiceUnderTest::Port() const
{
  return this->Self->Acceptor.local_endpoint().port();
}
void HaplyServiceUnderTest::Play(const HaplyScript& script)
{
  const std::lock_guard lock(this->Self->Mutex);
  this->Self->Script = script;
}
void HaplyServiceUnderTest::AwaitEnds(int connections) const
{
  std::unique_lock lock(this->Self->Mutex);
  this->Self->Changed.wait(lock, [&] { return this->Self->Ends >= connections; });
}
std::vector<glm::dvec3> HaplyServiceUnderTest::Forces() const
{
  const std::lock_guard lock(this->Self->Mutex);
  return this->Self->Heard;
}
std::vector<std::string> HaplyServiceUnderTest::Ids() const
{
  const std::lock_guard lock(this->Self->Mutex);
  return this->Self->For;
}
int HaplyServiceUnderTest::Goodbyes() const
{
  const std::lock_guard lock(this->Self->Mutex);
  return this->Self->GoodbyeCount;
}
int HaplyServiceUnderTest::Strange() const
{
  const std::lock_guard lock(this->Self->Mutex);
  return this->Self->StrangeCount;
}

DeafPort::DeafPort() : Handle(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
{
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof where;
  if (bind(this->Handle, reinterpret_cast<const sockaddr*>(&where), size) == 0 &&
      getsockname(this->Handle, reinterpret_cast<sockaddr*>(&where), &size) == 0)
    this->Port = ntohs(where.sin_port);
}
DeafPort::~DeafPort()
{
  close(this->Handle);
}
