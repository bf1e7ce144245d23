#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hasp
{

/// Where a WebSocket service listens.
struct WebSocketAddress
{
  std::string host = "localhost"; ///< or an IPv4 or IPv6 address in digits (without brackets)
  std::uint16_t port = 10001;
  std::string path = "/";
  bool loopback = true; ///< this machine: localhost, 127.x.x.x, ::1
};

/// "ws://localhost:10001", "ws://[::1]:10001/path"; without a port 80. Throws std::invalid_argument
/// if it is anything else: no wss, no names of machines, for they are looked up by the system in
/// its own time, which nothing here could cut short.
WebSocketAddress ParseWebSocketAddress(const std::string& text);

/// The connection is gone, or was never there.
struct WebSocketError : std::runtime_error
{
  using std::runtime_error::runtime_error;
  bool answered = false; ///< something listens there, and is no WebSocket service
};

/// One WebSocket connection (RFC 6455, on Boost.Beast), for one thread, where every wait has an
/// end.
///
/// Text goes out; text or binary comes in, whole messages of at most MostBytes. Pings and closings
/// are answered while anything here runs. Plain TCP: whoever is on the way reads and writes it.
/// Threads: one at a time. Nothing runs between the calls; what comes waits in the system's
/// buffers. Cost: some 20 us a message each way over loopback.
class WebSocketClient
{
public:
  static constexpr std::size_t MostBytes = 1 << 20;
  using Milliseconds = std::chrono::milliseconds;

  WebSocketClient();
  ~WebSocketClient(); ///< the connection is cut, at once
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;

  /// Connects and shakes hands; an earlier connection is cut first. Asks `cancelled` every 20 ms.
  /// localhost is 127.0.0.1, and ::1 where that refuses.
  /// Throws WebSocketError if it cannot or did not within that time, Cancelled if it was asked to
  /// leave.
  void Connect(
    const WebSocketAddress& address, Milliseconds within,
    const std::function<bool()>& cancelled = [] { return false; });

  /// Whether there is a connection, as far as is known.
  bool IsOpen() const noexcept { return this->Open != nullptr; }

  /// Throws WebSocketError if the system did not take it all within that time, or the connection is
  /// gone: then it is cut, for half a message may be out.
  void Send(std::string_view text, Milliseconds within);

  /// The newest message that has come; those before it are dropped. Waits until there is one, at
  /// most that long; 0 looks alone. Nothing: none came whole; what came in part is kept.
  /// Throws WebSocketError if the connection is gone (once what came before it was given) or a
  /// message is larger than MostBytes: then it is cut.
  std::optional<std::string> Receive(Milliseconds within);

  /// Says goodbye and waits that long for the answer; then it is cut. Nothing if it is not open.
  void Close(Milliseconds within) noexcept;

private:
  class Connection; // keeps Beast, which compiles for half a minute, out of this header
  [[noreturn]] void Cut(const std::string& why);
  std::unique_ptr<Connection> Open;
};

} // namespace hasp
