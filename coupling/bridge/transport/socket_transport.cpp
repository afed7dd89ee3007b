// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/socket_transport.h"

#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <thread>
#include <vector>

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>

#include "coupling/bridge/transport/socket_address.h"
#include "coupling/bridge/transport/socket_stream.h"

namespace powderlink::bridge {

namespace asio = boost::asio;

namespace {

using Kind = BridgeError::Kind;
using ErrorCode = boost::system::error_code;

void demand_token(const SocketAddress& address, bool within_machine, const std::string& token) {
  if (within_machine || !token.empty()) return;
  throw BridgeError(Kind::bad_input, "token of the socket", "none, for " + address.text(),
                    "none only on unix: and loopback addresses",
                    "give both programs the same token, or an address of this machine");
}

/// In a time that does not depend on where the two differ.
bool same_token(std::string_view one, std::string_view other) {
  unsigned char difference = one.size() == other.size() ? 0 : 1;
  for (std::size_t i = 0; i < other.size(); ++i) {
    const char a = i < one.size() ? one[i] : '\0';
    difference = static_cast<unsigned char>(difference | (a ^ other[i]));
  }
  return difference == 0;
}

void no_delay(Socket& socket, const SocketAddress& address) {
  ErrorCode ignored;
  if (!address.is_unix) socket.set_option(asio::ip::tcp::no_delay(true), ignored);
}

/// An open, listening socket. Removes its Unix path and rendezvous file at its end.
class Listener {
 public:
  Listener(asio::io_context& io, const SocketOptions& options)
      : address_(SocketAddress::parse(options.address.empty() ? "127.0.0.1:0" : options.address)),
        rendezvous_file_(options.rendezvous_file),
        io_(io),
        acceptor_(io) {
    const ResolvedAddress resolved = resolve(address_, Deadline(options.timeout_s));
    demand_token(address_, resolved.within_machine, options.token);
    if (address_.is_unix) remove_stale_path(resolved.endpoint);
    try {
      open(resolved.endpoint);
      if (!rendezvous_file_.empty()) write_rendezvous(rendezvous_file_, address_);
    } catch (...) {
      if (bound_ && address_.is_unix) unlink(address_.path.c_str());
      throw;
    }
  }
  ~Listener() {
    if (address_.is_unix) unlink(address_.path.c_str());
    SocketAddress now;
    try {
      // Another run may have put its own file there since.
      if (!rendezvous_file_.empty() && read_rendezvous(rendezvous_file_, now) &&
          now.text() == address_.text()) {
        std::remove(rendezvous_file_.c_str());
      }
    } catch (const std::exception&) {  // not our file any more
    }
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// Nothing when nobody comes before the deadline.
  std::optional<Socket> accept(const Deadline& deadline) {
    while (wait_for(acceptor_.native_handle(), POLLIN, deadline)) {
      Socket socket(io_);
      ErrorCode error;
      acceptor_.accept(socket, error);
      if (!error) {
        no_delay(socket, address_);
        return socket;
      }
      if (deadline.expired()) break;
    }
    return std::nullopt;
  }

  int descriptor() { return acceptor_.native_handle(); }
  std::string text() const { return address_.text(); }

 private:
  void open(const Endpoint& endpoint) {
    try {
      acceptor_.open(endpoint.protocol());
      if (!address_.is_unix) acceptor_.set_option(Acceptor::reuse_address(true));
      // The socket file must never be open to others, not even for a moment.
      const mode_t mask = umask(0177);
      ErrorCode error;
      acceptor_.bind(endpoint, error);
      umask(mask);
      if (error) throw boost::system::system_error(error);
      bound_ = true;
      acceptor_.listen();
      acceptor_.non_blocking(true);
      if (!address_.is_unix) {
        const Endpoint local = acceptor_.local_endpoint();
        asio::ip::tcp::endpoint tcp;
        std::memcpy(tcp.data(), local.data(), local.size());
        tcp.resize(local.size());
        address_.port = std::to_string(tcp.port());
      }
    } catch (const boost::system::system_error& e) {
      throw BridgeError(Kind::bad_input, "listening on " + address_.text(), e.code().message(),
                        "a free address of this machine",
                        "give another address, or end the program that uses this one");
    }
  }

  /// A run that was killed leaves its path behind.
  void remove_stale_path(const Endpoint& endpoint) {
    struct stat status {};
    if (lstat(address_.path.c_str(), &status) != 0) return;
    const bool is_socket = S_ISSOCK(status.st_mode);
    ErrorCode error;
    if (is_socket) {
      Socket probe(io_);
      probe.connect(endpoint, error);
    }
    if (!is_socket || !error) {
      throw BridgeError(Kind::bad_input, "listening on " + address_.text(),
                        is_socket ? "somebody listens there already" : "a file that is no socket",
                        "a path that is free, or left by a run that has ended",
                        "give another path, or end the other run");
    }
    unlink(address_.path.c_str());
  }

  using Acceptor = asio::basic_socket_acceptor<asio::generic::stream_protocol>;

  SocketAddress address_;
  std::string rendezvous_file_;
  asio::io_context& io_;
  Acceptor acceptor_;
  bool bound_ = false;
};

constexpr double greeting_patience_s = 1.0;
// The next pass of a script's loop comes while the solver of the last one is about to end.
constexpr int end_patience_ms = 200;

/// Of a client that has not been let in: a greeting with its token.
FrameLimits limits_of_strangers() {
  FrameLimits limits;
  limits.frame_bytes = std::uint64_t{1} << 16;
  return limits;
}

/// Tells a client why it is sent away, and lets it read that before the line is cut.
void send_away(SocketStream& stream, const std::string& why) noexcept {
  try {
    const Deadline deadline(greeting_patience_s);
    Bytes frame;
    encode_text(frame, MessageKind::error, why);
    stream.send(frame, deadline);
    while (!deadline.expired()) stream.receive(frame, deadline);  // until it hangs up
  } catch (const std::exception&) {  // it has hung up, or is no client of ours
  }
  stream.close();
}

/// While a session runs: answers further clients. One thread, asleep in poll().
class Doorman {
 public:
  explicit Doorman(std::unique_ptr<Listener> listener) : listener_(std::move(listener)) {
    if (pipe(wake_) != 0) throw std::runtime_error("pipe() failed");
    // Signals are for the threads of the host program.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    try {
      thread_ = std::thread([this] { run(); });
    } catch (...) {
      pthread_sigmask(SIG_SETMASK, &before, nullptr);
      throw;
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  ~Doorman() {
    ::close(wake_[1]);
    thread_.join();
    ::close(wake_[0]);
  }
  Doorman(const Doorman&) = delete;
  Doorman& operator=(const Doorman&) = delete;

 private:
  void run() noexcept {
    while (true) {
      pollfd entries[2] = {{wake_[0], POLLIN, 0}, {listener_->descriptor(), POLLIN, 0}};
      if (poll(entries, 2, -1) < 0) continue;
      if (entries[0].revents != 0) return;
      try {
        if (auto socket = listener_->accept(Deadline(0.0))) {
          SocketStream stream(std::move(*socket), "a second client");
          if (poll(entries, 1, end_patience_ms) > 0) return;  // it will look for the next listener
          stream.set_limits(limits_of_strangers());
          send_away(stream,
                    "connection to " + listener_->text() +
                        "; given: a second client; allowed: one client per run; "
                        "to do: end the other client, or give this run an address of its own");
        }
      } catch (const std::exception&) {  // that client is gone; the next one may come
      }
    }
  }

  std::unique_ptr<Listener> listener_;
  int wake_[2] = {-1, -1};
  std::thread thread_;
};

/// The socket refers to its io_context, so both live together.
class SocketTransport : public Transport {
 public:
  SocketTransport(std::unique_ptr<asio::io_context> io, SocketStream stream)
      : io_(std::move(io)), stream_(std::move(stream)) {}
  ~SocketTransport() override { SocketTransport::close(); }

  void keep_door(std::unique_ptr<Listener> listener) {
    doorman_ = std::make_unique<Doorman>(std::move(listener));
  }
  void send(Bytes& frame, const Deadline& deadline) override { stream_.send(frame, deadline); }
  void receive(Bytes& frame, const Deadline& deadline) override {
    stream_.receive(frame, deadline);
  }
  const std::string& peer() const override { return stream_.peer(); }
  void close() noexcept override {
    doorman_.reset();
    stream_.close();
  }

 private:
  std::unique_ptr<asio::io_context> io_;
  SocketStream stream_;
  std::unique_ptr<Doorman> doorman_;
};

/// True when the client may stay; otherwise `why` says why not.
bool greet_client(SocketStream& stream, const std::string& token, const Deadline& overall,
                  std::string& why) {
  const Deadline deadline(std::min(greeting_patience_s, overall.remaining_s()));
  Bytes frame;
  FrameView view;
  try {
    stream.set_limits(limits_of_strangers());
    stream.receive(frame, deadline);
    decode(frame, view);
    if (view.kind != MessageKind::greeting) {
      why = "a client that sent no greeting";
    } else if (!same_token(view.text, token)) {
      why = "a client with another token";
      send_away(stream,
                "token of the socket; given: another one; allowed: that of the listening program; "
                "to do: give both programs the same token");
    } else {
      encode_text(frame, MessageKind::accepted, {});
      stream.send(frame, deadline);
      stream.set_limits({});
      return true;
    }
  } catch (const BridgeError& e) {
    if (e.kind() == Kind::wrong_version) {
      send_away(stream, e.what());
      throw;
    }
    why = std::string("a client whose greeting failed (") + e.what() + ")";
  }
  stream.close();
  return false;
}

void greet_server(SocketStream& stream, const std::string& token, const Deadline& deadline) {
  Bytes frame;
  FrameView view;
  encode_text(frame, MessageKind::greeting, token);
  try {
    stream.send(frame, deadline);
  } catch (const BridgeError& e) {
    if (e.kind() != Kind::peer_lost) throw;  // else: its reason may still be there to read
  }
  stream.receive(frame, deadline);
  decode(frame, view);
  if (view.kind == MessageKind::error) throw BridgeError(Kind::refused, std::string(view.text));
  if (view.kind != MessageKind::accepted) {
    throw BridgeError(Kind::bad_frame, "greeting of " + stream.peer(), "neither yes nor no",
                      "accepted, or an error", "use programs of the same release");
  }
}

/// One attempt. False with a reason when it makes sense to try again.
bool try_connect(Socket& socket, const Endpoint& endpoint, const Deadline& deadline,
                 std::string& why) {
  ErrorCode error;
  socket.open(endpoint.protocol(), error);
  if (!error) socket.non_blocking(true, error);
  if (!error) {
    // Asio's connect() would wait without end; this one is nonblocking.
    if (::connect(socket.native_handle(), endpoint.data(), endpoint.size()) != 0) {
      error.assign(errno, boost::system::system_category());
      if (errno == EINPROGRESS && wait_for(socket.native_handle(), POLLOUT, deadline)) {
        int outcome = 0;
        socklen_t size = sizeof outcome;
        getsockopt(socket.native_handle(), SOL_SOCKET, SO_ERROR, &outcome, &size);
        error.assign(outcome, boost::system::system_category());
      }
    }
  }
  if (!error) return true;
  why = error.message();
  return false;
}

}  // namespace

std::unique_ptr<Transport> listen_on_socket(const SocketOptions& options) {
  const Deadline deadline(options.timeout_s);
  auto io = std::make_unique<asio::io_context>();
  auto listener = std::make_unique<Listener>(*io, options);
  std::string sent_away;
  while (auto socket = listener->accept(deadline)) {
    SocketStream stream(std::move(*socket), "the client of " + listener->text());
    std::string why;
    if (greet_client(stream, options.token, deadline, why)) {
      auto transport = std::make_unique<SocketTransport>(std::move(io), std::move(stream));
      transport->keep_door(std::move(listener));
      return transport;
    }
    sent_away += (sent_away.empty() ? "" : ", ") + why;
    if (sent_away.size() > 500) sent_away = "many clients, the last one " + why;
    if (deadline.expired()) break;  // however many more are at the door
  }
  throw deadline.error("a client on " + listener->text() +
                       (sent_away.empty() ? "" : " (sent away: " + sent_away + ")"));
}

std::unique_ptr<Transport> connect_to_socket(const SocketOptions& options) {
  const Deadline deadline(options.timeout_s);
  if (options.address.empty() && options.rendezvous_file.empty()) {
    throw BridgeError(Kind::bad_input, "address of the socket", "neither address nor file",
                      "unix:PATH, HOST:PORT, or the rendezvous file of the listening program",
                      "give one of them");
  }
  auto io = std::make_unique<asio::io_context>();
  std::string why;
  do {
    SocketAddress address;
    if (!options.address.empty()) {
      address = SocketAddress::parse(options.address);
    } else if (!read_rendezvous(options.rendezvous_file, address)) {
      why = "rendezvous file " + options.rendezvous_file + " does not exist";
    }
    if (address.is_unix || !address.host.empty()) {
      const ResolvedAddress resolved = resolve(address, deadline);
      demand_token(address, resolved.within_machine, options.token);
      Socket socket(*io);
      if (try_connect(socket, resolved.endpoint, deadline, why)) {
        no_delay(socket, address);
        SocketStream stream(std::move(socket), address.text());
        try {
          greet_server(stream, options.token, deadline);
          return std::make_unique<SocketTransport>(std::move(io), std::move(stream));
        } catch (const BridgeError& e) {
          if (e.kind() != Kind::peer_lost) throw;
          why = e.what();  // a listener that ends: the next one may come
        }
      } else {
        why = address.text() + ": " + why;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  } while (!deadline.expired());
  throw deadline.error("the listening program (" + why + ")");
}

}  // namespace powderlink::bridge
