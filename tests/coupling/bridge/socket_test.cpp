// SPDX-License-Identifier: GPL-3.0-or-later
// What only sockets can do wrong: addresses, tokens, second clients, and programs that are killed.
#include "coupling/bridge/transport/socket_transport.h"

#include <dlfcn.h>
#include <netdb.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <future>
#include <thread>

#include <gtest/gtest.h>
#include <boost/asio/io_context.hpp>

#include "coupling/bridge/transport/session.h"
#include "coupling/bridge/transport/socket_address.h"
#include "tests/coupling/bridge/fails.h"
#include "tests/coupling/bridge/sample_frames.h"
#include "tests/coupling/bridge/temporary_folder.h"

/// The system's look-up, slow for one host.
extern "C" int getaddrinfo(const char* host, const char* port, const addrinfo* hints,
                           addrinfo** found) {
  if (host != nullptr && std::string(host) == "slow.invalid") usleep(1500000);
  using Function = int (*)(const char*, const char*, const addrinfo*, addrinfo**);
  static const auto next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "getaddrinfo"));
  return next(host, port, hints, found);
}

namespace {

std::atomic<bool> flooding{false};
std::size_t flood_sent = 0;
powderlink::bridge::Bytes flood_frame;

}  // namespace

/// A socket that has nothing to read has more of the flood, while there is one.
extern "C" ssize_t recv(int socket, void* into, size_t room, int flags) {
  using Function = ssize_t (*)(int, void*, size_t, int);
  static const auto next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "recv"));
  const ssize_t got = next(socket, into, room, flags);
  if (got >= 0 || errno != EAGAIN || !flooding) return got;
  const std::size_t at = flood_sent % flood_frame.size();
  const std::size_t more = std::min(room, flood_frame.size() - at);
  std::memcpy(into, flood_frame.data() + at, more);
  flood_sent += more;
  return static_cast<ssize_t>(more);
}

namespace powderlink::test {
namespace {

using bridge::BridgeError;
using bridge::Bytes;
using bridge::connect_to_socket;
using bridge::Deadline;
using bridge::listen_on_socket;
using bridge::SocketOptions;
using Kind = BridgeError::Kind;
using TransportPtr = std::unique_ptr<bridge::Transport>;

double seconds(Deadline::Clock::time_point since) {
  return std::chrono::duration<double>(Deadline::Clock::now() - since).count();
}

class Sockets : public ::testing::TestWithParam<std::string> {
 protected:
  SocketOptions listener(double timeout_s = 5.0, const std::string& token = {}) const {
    return {GetParam() == "unix" ? "unix:" + folder_.path() + "/socket" : "127.0.0.1:0",
            folder_.path() + "/meet", token, timeout_s};
  }
  SocketOptions client(double timeout_s = 5.0, const std::string& token = {}) const {
    return {"", folder_.path() + "/meet", token, timeout_s};
  }
  std::pair<TransportPtr, TransportPtr> pair() const {
    auto listening =
        std::async(std::launch::async, [this] { return listen_on_socket(listener()); });
    auto connected = connect_to_socket(client());
    return {listening.get(), std::move(connected)};
  }

  TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Kinds, Sockets, ::testing::Values("unix", "tcp"),
                         [](const auto& info) { return info.param; });

TEST_P(Sockets, AMissingRendezvousFileEndsAtTheTimeout) {
  const auto start = Deadline::Clock::now();
  EXPECT_EQ("", failure_of([&] { connect_to_socket(client(0.5)); }, Kind::timeout,
                           "meet does not exist"));
  EXPECT_NEAR(seconds(start), 0.5, 0.1);
}

TEST_P(Sockets, AListenerWithoutClientEndsAtTheTimeoutAndCleansUp) {
  const auto start = Deadline::Clock::now();
  EXPECT_EQ("", failure_of([&] { listen_on_socket(listener(0.5)); }, Kind::timeout, "a client on"));
  EXPECT_NEAR(seconds(start), 0.5, 0.1);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_P(Sockets, ASecondClientIsTurnedAwayAndTheFirstGoesOn) {
  auto [listening, connected] = pair();
  for (int i = 0; i < 3; ++i) {
    const auto start = Deadline::Clock::now();
    EXPECT_EQ("",
              failure_of([&] { connect_to_socket(client()); }, Kind::refused, "a second client"));
    EXPECT_LT(seconds(start), 2.0);
  }
  Bytes frame = small_frame();
  connected->send(frame, Deadline(1.0));
  listening->receive(frame, Deadline(1.0));
  EXPECT_EQ(frame.size(), small_frame().size());
  listening->close();
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

/// Loops of coupled runs: the next pass is there before the solver of the last one has gone.
TEST_P(Sockets, AClientThatComesAsARunEndsGetsTheNextListener) {
  auto [listening, connected] = pair();
  auto early = std::async(std::launch::async, [this] { return connect_to_socket(client()); });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  listening->close();
  const TransportPtr next = listen_on_socket(listener());
  EXPECT_NO_THROW(early.get());
}

TEST_P(Sockets, AWrongTokenIsRefusedAndTheRightOneStillServed) {
  auto listening =
      std::async(std::launch::async, [this] { return listen_on_socket(listener(5.0, "right")); });
  for (const char* token : {"", "wrong", "righ", "rightt"}) {
    EXPECT_EQ("", failure_of([&] { connect_to_socket(client(5.0, token)); }, Kind::refused,
                             "token of the socket"));
  }
  EXPECT_NO_THROW(connect_to_socket(client(5.0, "right")));
  EXPECT_NO_THROW(listening.get());
}

TEST_P(Sockets, TheListenerTellsWhomItSentAway) {
  std::string failure;
  std::thread listening([&] {
    failure = failure_of([&] { listen_on_socket(listener(1.0, "right")); }, Kind::timeout,
                         "sent away: a client with another token");
  });
  EXPECT_EQ("", failure_of([&] { connect_to_socket(client(5.0, "wrong")); }, Kind::refused,
                           "token of the socket"));
  listening.join();
  EXPECT_EQ("", failure);
}

TEST_P(Sockets, AFileLeftByAKilledRunDoesNoHarm) {
  const pid_t child = fork();
  if (child == 0) {
    listen_on_socket(listener());
    _exit(0);
  }
  while (!std::filesystem::exists(folder_.path() + "/meet")) usleep(1000);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(std::filesystem::exists(folder_.path() + "/meet"));
  EXPECT_EQ("", failure_of([&] { connect_to_socket(client(0.3)); }, Kind::timeout, "refused"));
  EXPECT_NO_THROW(pair());
}

TEST_P(Sockets, AKilledPeerIsNoticedAtOnce) {
  const pid_t child = fork();
  if (child == 0) {
    const auto transport = connect_to_socket(client());
    Bytes frame = small_frame();
    transport->send(frame, Deadline(1.0));
    while (true) pause();
  }
  const auto transport = listen_on_socket(listener());
  Bytes frame;
  transport->receive(frame, Deadline(5.0));
  std::thread killer([child] {
    usleep(200000);
    kill(child, SIGKILL);
  });
  const auto start = Deadline::Clock::now();
  EXPECT_EQ("", failure_of([&] { transport->receive(frame, Deadline(30.0)); }, Kind::peer_lost,
                           "connection to"));
  EXPECT_LT(seconds(start), 1.0);
  killer.join();
  waitpid(child, nullptr, 0);
}

TEST_P(Sockets, AStoppedReaderEndsTheWriterAtTheTimeout) {
  const auto ends = pair();
  Bytes frame;
  bridge::Field large({"large", "1", bridge::scalar, bridge::ElementType::float64});
  large.resize(2000000);
  encode(frame, {large});
  const auto start = Deadline::Clock::now();
  EXPECT_EQ("", failure_of([&] { ends.first->send(frame, Deadline(0.5)); }, Kind::timeout,
                           "room to send"));
  EXPECT_NEAR(seconds(start), 0.5, 0.1);
}

TEST_P(Sockets, AnotherVersionIsToldToBothSides) {
  std::string failure;
  std::thread listening([&] {
    failure = failure_of([&] { listen_on_socket(listener()); }, Kind::wrong_version,
                         "given: 9; allowed: 1");
  });
  // A client of version 9, made by hand.
  bridge::SocketAddress address;
  while (!bridge::read_rendezvous(folder_.path() + "/meet", address)) usleep(1000);
  boost::asio::io_context io;
  boost::asio::generic::stream_protocol::socket socket(io);
  socket.connect(bridge::resolve(address, Deadline(5.0)).endpoint);
  Bytes frame;
  bridge::encode_text(frame, bridge::MessageKind::greeting, "");
  frame[12] = std::byte{9};
  boost::system::error_code error;
  socket.write_some(boost::asio::buffer(frame.data(), frame.size()), error);
  Bytes answer;
  bridge::resize(answer, 4096);
  const std::size_t got =
      socket.read_some(boost::asio::buffer(answer.data(), answer.size()), error);
  bridge::resize(answer, got);
  socket.close();
  listening.join();
  EXPECT_EQ("", failure);
  bridge::FrameView view;
  bridge::decode(answer, view);
  EXPECT_EQ(view.kind, bridge::MessageKind::error);
  EXPECT_NE(view.text.find("given: 9; allowed: 1"), std::string_view::npos);
}

TEST_P(Sockets, NoiseAtTheDoorDoesNotEndTheWait) {
  auto listening = std::async(std::launch::async, [this] { return listen_on_socket(listener()); });
  bridge::SocketAddress address;
  while (!bridge::read_rendezvous(folder_.path() + "/meet", address)) usleep(1000);
  {
    boost::asio::io_context io;
    boost::asio::generic::stream_protocol::socket socket(io);
    socket.connect(bridge::resolve(address, Deadline(5.0)).endpoint);
    const std::string noise(1000, 'x');
    boost::system::error_code error;
    socket.write_some(boost::asio::buffer(noise), error);
  }
  EXPECT_NO_THROW(connect_to_socket(client()));
  EXPECT_NO_THROW(listening.get());
}

/// A client that has always sent one more frame of the same.
class Flood {
 public:
  Flood(const std::string& meet, bool small_frames) : socket_(io_) {
    if (small_frames) {
      bridge::encode_text(flood_frame, bridge::MessageKind::greeting, "wrong");
    } else {
      bridge::Field large({"large", "1", bridge::scalar, bridge::ElementType::float64});
      large.resize(1000000);
      encode(flood_frame, {large});
    }
    bridge::SocketAddress address;
    while (!bridge::read_rendezvous(meet, address)) usleep(1000);
    socket_.connect(bridge::resolve(address, Deadline(5.0)).endpoint);
    flood_sent = 0;
    flooding = true;
  }
  ~Flood() { flooding = false; }

 private:
  boost::asio::io_context io_;
  boost::asio::generic::stream_protocol::socket socket_;
};

TEST_P(Sockets, AFloodOfFramesDoesNotHoldTheListenerBeyondItsTimeout) {
  for (const bool small_frames : {true, false}) {
    auto listening = std::async(std::launch::async, [this] {
      return failure_of([&] { listen_on_socket(listener(1.0)); }, Kind::timeout, "sent away");
    });
    const Flood flood(folder_.path() + "/meet", small_frames);
    // Its timeout, and the patience with a client that is sent away.
    EXPECT_EQ(listening.wait_for(std::chrono::milliseconds(2500)), std::future_status::ready);
    flooding = false;
    EXPECT_EQ("", listening.get());
  }
}

TEST_P(Sockets, AFloodOfFramesDoesNotHoldTheDoorOfARunThatEnds) {
  for (const bool small_frames : {true, false}) {
    auto [listening, connected] = pair();
    const Flood flood(folder_.path() + "/meet", small_frames);
    usleep(200000);
    auto closing = std::async(std::launch::async, [&ends = listening] { ends->close(); });
    EXPECT_EQ(closing.wait_for(std::chrono::milliseconds(1500)), std::future_status::ready);
    flooding = false;
  }
}

TEST(SocketAddresses, ASlowLookUpEndsAtTheTimeout) {
  const auto start = Deadline::Clock::now();
  for (const bool listens : {true, false}) {
    EXPECT_EQ("", failure_of(
                      [&] {
                        const SocketOptions options{"slow.invalid:80", "", "token", 0.3};
                        listens ? listen_on_socket(options) : connect_to_socket(options);
                      },
                      Kind::timeout, "the look-up of host slow.invalid"));
  }
  EXPECT_LT(seconds(start), 1.2);
}

TEST(SocketAddresses, AreReadAndWritten) {
  for (const char* text : {"unix:/tmp/x", "localhost:80", "127.0.0.1:0", "[::1]:65535"}) {
    EXPECT_EQ(bridge::SocketAddress::parse(text).text(), text);
  }
  for (const char* text :
       {"", "host", ":80", "host:", "host:x", "host:65536", "host:123456", "unix:", "host:-1"}) {
    EXPECT_EQ("", failure_of([&] { bridge::SocketAddress::parse(text); }, Kind::bad_input,
                             "address of the socket"))
        << text;
  }
  const std::string path = "unix:/" + std::string(200, 'x');
  EXPECT_EQ("", failure_of([&] { bridge::SocketAddress::parse(path); }, Kind::bad_input, "107"));
}

TEST(SocketAddresses, OnlyLoopbackNeedsNoToken) {
  const auto listen = [](const std::string& address, const std::string& token) {
    listen_on_socket({address, "", token, 0.05});
  };
  EXPECT_EQ("", failure_of([&] { listen("0.0.0.0:0", ""); }, Kind::bad_input, "token"));
  EXPECT_EQ("", failure_of([&] { listen("0.0.0.0:0", "secret"); }, Kind::timeout, "a client on"));
  EXPECT_EQ("", failure_of([&] { listen("127.0.0.1:0", ""); }, Kind::timeout, "a client on"));
  EXPECT_EQ("", failure_of(
                    [&] {
                      connect_to_socket({"192.0.2.1:9", "", "", 0.1});
                    },
                    Kind::bad_input, "token"));
}

TEST(SocketAddresses, FilesThatAreNoneOfOursStay) {
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/notes";
  std::ofstream(file) << "mine\n";
  EXPECT_EQ("", failure_of(
                    [&] {
                      listen_on_socket({"unix:" + file, "", "", 0.1});
                    },
                    Kind::bad_input, "no socket"));
  EXPECT_EQ("", failure_of(
                    [&] {
                      connect_to_socket({"", file, "", 0.1});
                    },
                    Kind::bad_input, "rendezvous file"));
  EXPECT_EQ("", failure_of(
                    [&] {
                      listen_on_socket({"", folder.path() + "/no/meet", "", 0.1});
                    },
                    Kind::bad_input, "rendezvous file"));
  EXPECT_EQ("", failure_of(
                    [&] {
                      connect_to_socket({"", "", "", 0.1});
                    },
                    Kind::bad_input, "neither address nor file"));
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST(SocketAddresses, AUnixSocketBelongsToTheUserAndOneListener) {
  const TemporaryFolder folder;
  const std::string path = folder.path() + "/socket";
  auto listening = std::async(std::launch::async, [&] {
    return listen_on_socket({"unix:" + path, "", "", 5.0});
  });
  const auto connected = connect_to_socket({"unix:" + path, "", "", 5.0});
  const auto transport = listening.get();
  struct stat status {};
  ASSERT_EQ(0, stat(path.c_str(), &status));
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  EXPECT_EQ("", failure_of(
                    [&] {
                      listen_on_socket({"unix:" + path, "", "", 0.1});
                    },
                    Kind::bad_input, "somebody listens there already"));
}

}  // namespace
}  // namespace powderlink::test
