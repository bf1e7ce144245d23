#include "Devices/Drivers/Haply/WebSocketClient.h"

#include "Grid/Progress.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/websocket.hpp>

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

namespace hasp
{

namespace
{
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;
using Clock = std::chrono::steady_clock;
using ErrorCode = beast::error_code;

constexpr WebSocketClient::Milliseconds AskEach{ 20 };
constexpr int MostDrained = 1000; // handlers in one go: some 200 messages. More is no device

[[noreturn]] void RefuseAddress(const char* why)
{
  throw std::invalid_argument(
    std::string("WebSocket address: ") + why + "; it is written as ws://localhost:10001");
}

std::vector<tcp::endpoint> Endpoints(const WebSocketAddress& address)
{
  if (address.host == "localhost") // as RFC 6761 has it, whatever the system's tables say
    return { { asio::ip::address_v4::loopback(), address.port },
      { asio::ip::address_v6::loopback(), address.port } };
  ErrorCode error;
  const auto digits = asio::ip::make_address(address.host, error);
  if (error)
    throw WebSocketError("the host is no address in digits");
  return { { digits, address.port } };
}

/// Whether it came from something that speaks, and not as a WebSocket service does.
bool IsAnswer(const ErrorCode& error)
{
  namespace http = beast::http;
  if (error == http::error::end_of_stream || error == http::error::partial_message)
    return false;
  return error.category() == make_error_code(websocket::error::closed).category() ||
         error.category() == make_error_code(http::error::end_of_stream).category();
}
} // namespace

WebSocketAddress ParseWebSocketAddress(const std::string& text)
{
  constexpr std::string_view Scheme = "ws://";
  if (!text.starts_with(Scheme))
    RefuseAddress("it must begin with ws://");
  WebSocketAddress address;
  address.port = 80;
  std::string rest = text.substr(Scheme.size());
  if (const auto slash = rest.find('/'); slash != std::string::npos)
  {
    address.path = rest.substr(slash);
    rest.resize(slash);
  }
  const bool legal = std::all_of(
    address.path.begin(), address.path.end(), [](char c) { return c > ' ' && c <= '~'; });
  if (!legal)
    RefuseAddress("the path must be printable ASCII without spaces");
  const auto colon = rest.rfind(':');
  if (colon != std::string::npos && rest.find(']', colon) == std::string::npos)
  {
    const char *first = rest.data() + colon + 1, *last = rest.data() + rest.size();
    const auto [end, error] = std::from_chars(first, last, address.port);
    if (first == last || end != last || error != std::errc() || address.port == 0)
      RefuseAddress("the port must be a number in [1, 65535]");
    rest.resize(colon);
  }
  const bool brackets = rest.size() > 2 && rest.front() == '[' && rest.back() == ']';
  address.host = brackets ? rest.substr(1, rest.size() - 2) : rest;
  if (address.host == "localhost" && !brackets)
    return address;
  ErrorCode error;
  const auto digits = asio::ip::make_address(address.host, error);
  if (error || digits.is_v6() != brackets)
    RefuseAddress("the host must be localhost, an IPv4 address in digits, or an IPv6 one in [ ]");
  address.loopback = digits.is_loopback();
  return address;
}

/// Beast's stream. A read is always under way, and goes on where it was when time runs out: to cut
/// it short would be to lose the place in the stream. Handlers run only inside Run and Drain, so
/// they may hold what lives on the caller's stack; who leaves before they ran destroys this first.
class WebSocketClient::Connection
{
public:
  Connection() : Stream(this->Context) { this->Stream.read_message_max(MostBytes); }

  /// Until `done`, or that time; what is ready by then still counts, however late this thread is.
  template <typename Done>
  bool Run(Clock::time_point end, const Done& done)
  {
    this->Context.restart();
    while (!done() && this->Context.run_one_until(end) > 0)
    {
    }
    for (int n = 0; n < MostDrained && !done() && this->Context.poll_one() > 0; ++n)
    {
    }
    return done();
  }

  /// What is there already, without waiting.
  void Drain()
  {
    this->Run(Clock::time_point::min(), [] { return false; });
  }

  void Read()
  {
    this->Stream.async_read(this->Incoming,
      [this](const ErrorCode& error, std::size_t)
      {
        if (error)
        {
          this->ReadError = error;
          return;
        }
        this->Newest = beast::buffers_to_string(this->Incoming.data());
        this->Incoming.clear();
        this->Read();
      });
  }

  asio::io_context Context{ 1 };
  websocket::stream<tcp::socket> Stream;
  beast::flat_buffer Incoming;
  std::optional<std::string> Newest;
  ErrorCode ReadError;
  std::string Outgoing;
};

namespace
{
/// Begins one asynchronous operation and runs until it has ended. Throws Cancelled, or
/// WebSocketError when time is up: then the operation is still under way.
template <typename Connection, typename Begin>
ErrorCode Await(Connection& connection, Clock::time_point end,
  const std::function<bool()>& cancelled, const Begin& begin)
{
  std::optional<ErrorCode> result;
  begin([&result](const ErrorCode& error, auto&&...) { result = error; });
  const auto done = [&result] { return result.has_value(); };
  while (!connection.Run(std::min(end, Clock::now() + AskEach), done))
  {
    if (cancelled())
      throw Cancelled();
    if (Clock::now() >= end)
      throw WebSocketError("no answer in time");
  }
  return *result;
}

std::string Reason(const ErrorCode& error)
{
  if (error == websocket::error::message_too_big || error == websocket::error::buffer_overflow)
    return "a message is larger than 1 MiB";
  return "the connection is gone: " + error.message();
}

bool Never()
{
  return false;
}
} // namespace

WebSocketClient::WebSocketClient() = default;
WebSocketClient::~WebSocketClient() = default;

void WebSocketClient::Connect(
  const WebSocketAddress& address, Milliseconds within, const std::function<bool()>& cancelled)
{
  this->Open.reset();
  const auto end = Clock::now() + within;
  ErrorCode error;
  for (const tcp::endpoint& endpoint : Endpoints(address))
  {
    if (cancelled())
      throw Cancelled();
    auto connection = std::make_unique<Connection>();
    auto& socket = connection->Stream.next_layer();
    error = Await(
      *connection, end, cancelled, [&](auto handler) { socket.async_connect(endpoint, handler); });
    if (error)
      continue;
    ErrorCode ignored; // a force that waits for the next is late, not wrong
    socket.set_option(tcp::no_delay(true), ignored);
    const std::string host =
      (endpoint.address().is_v6() ? "[" + address.host + "]" : address.host) + ":" +
      std::to_string(address.port);
    error = Await(*connection, end, cancelled,
      [&](auto handler) { connection->Stream.async_handshake(host, address.path, handler); });
    if (error)
    {
      WebSocketError refusal("what listens there does not shake hands: " + error.message());
      refusal.answered = IsAnswer(error);
      throw refusal;
    }
    connection->Read();
    this->Open = std::move(connection);
    return;
  }
  throw WebSocketError("nothing listens there: " + error.message());
}

void WebSocketClient::Send(std::string_view text, Milliseconds within)
{
  if (!this->Open)
    throw WebSocketError("there is no connection");
  Connection& open = *this->Open;
  open.Outgoing = text;
  const auto end = Clock::now() + within;
  ErrorCode error;
  try
  {
    error = Await(open, end, Never,
      [&open](auto handler) { open.Stream.async_write(asio::buffer(open.Outgoing), handler); });
  }
  catch (const WebSocketError&)
  {
    this->Open.reset();
    throw WebSocketError("what is said is not taken");
  }
  if (!error)
    return;
  // The read under way ends too, and knows better why.
  open.Run(end, [&open] { return bool(open.ReadError); });
  this->Cut(open.ReadError ? Reason(open.ReadError) : Reason(error));
}

void WebSocketClient::Cut(const std::string& why)
{
  this->Open.reset();
  throw WebSocketError(why);
}

std::optional<std::string> WebSocketClient::Receive(Milliseconds within)
{
  if (!this->Open)
    throw WebSocketError("there is no connection");
  Connection& open = *this->Open;
  open.Drain();
  open.Run(Clock::now() + within, [&open] { return open.Newest || open.ReadError; });
  open.Drain();
  if (open.Newest)
    return std::exchange(open.Newest, std::nullopt);
  if (!open.ReadError)
    return std::nullopt;
  this->Cut(Reason(open.ReadError));
}

void WebSocketClient::Close(Milliseconds within) noexcept
{
  if (!this->Open)
    return;
  try
  {
    Connection& open = *this->Open;
    Await(open, Clock::now() + within, Never,
      [&open](auto handler) { open.Stream.async_close(websocket::close_code::normal, handler); });
  }
  catch (...) // time is up, or memory: it is cut all the same
  {
  }
  this->Open.reset();
}

} // namespace hasp
