#pragma once
#include "Devices/Drivers/Testing/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace hasp::test
{

/// The daemon's side of its socket, in a temporary folder that goes with it.
class FakeSpacenavd
{
public:
  using Event = std::array<std::int32_t, 8>;

  FakeSpacenavd() { EXPECT_EQ(chmod(this->Folder.Path.c_str(), 0755), 0); }
  ~FakeSpacenavd() { this->End(); }
  FakeSpacenavd(const FakeSpacenavd&) = delete;
  FakeSpacenavd& operator=(const FakeSpacenavd&) = delete;

  std::string Path() const { return (this->Folder.Path / "spnav.sock").string(); }

  void Begin(int backlog = 8)
  {
    unlink(this->Path().c_str()); // as the daemon does
    this->Listening = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un where{};
    where.sun_family = AF_UNIX;
    ASSERT_LT(this->Path().size(), sizeof where.sun_path);
    std::strcpy(where.sun_path, this->Path().c_str());
    ASSERT_EQ(bind(this->Listening, reinterpret_cast<sockaddr*>(&where), sizeof where), 0);
    ASSERT_EQ(listen(this->Listening, backlog), 0);
  }
  /// The one program that has connected.
  void Accept()
  {
    this->HangUp();
    this->Client = accept4(this->Listening, nullptr, nullptr, SOCK_CLOEXEC);
    ASSERT_GE(this->Client, 0);
  }
  void SendBytes(const void* bytes, std::size_t size) const
  {
    ASSERT_EQ(send(this->Client, bytes, size, MSG_NOSIGNAL), static_cast<ssize_t>(size));
  }
  void Send(const Event& event) const { this->SendBytes(event.data(), sizeof event); }
  void Motion(std::span<const std::int32_t, 6> axes) const
  {
    this->Send({ 0, axes[0], axes[1], axes[2], axes[3], axes[4], axes[5], 16 });
  }
  void HangUp()
  {
    if (this->Client >= 0)
      close(this->Client);
    this->Client = -1;
  }
  /// Killed: the socket's file stays.
  void End()
  {
    this->HangUp();
    if (this->Listening >= 0)
      close(this->Listening);
    this->Listening = -1;
  }

private:
  const TemporaryFolder Folder;
  int Listening = -1, Client = -1;
};

} // namespace hasp::test
