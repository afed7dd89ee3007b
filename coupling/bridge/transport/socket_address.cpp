// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupling/bridge/transport/socket_address.h"

#include <unistd.h>

#include <sys/un.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <future>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>

#include "coupling/bridge/bridge_error.h"

namespace powderlink::bridge {

namespace asio = boost::asio;

namespace {

constexpr const char* rendezvous_mark = "powderlink-bridge 1 ";
constexpr std::size_t longest_path = sizeof(sockaddr_un::sun_path) - 1;

BridgeError bad_address(const std::string& given, const std::string& allowed) {
  return {BridgeError::Kind::bad_input, "address of the socket", "'" + given + "'", allowed,
          "correct the address in the options of the coupling"};
}

}  // namespace

SocketAddress SocketAddress::parse(const std::string& text) {
  constexpr const char* forms = "unix:PATH, HOST:PORT, or [IPv6]:PORT";
  SocketAddress address;
  if (text.rfind("unix:", 0) == 0) {
    address.is_unix = true;
    address.path = text.substr(5);
    if (address.path.empty() || address.path.size() > longest_path) {
      throw bad_address(
          text, "unix:PATH with 1 to " + std::to_string(longest_path) + " characters of path");
    }
    return address;
  }
  const auto colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) throw bad_address(text, forms);
  address.host = text.substr(0, colon);
  address.port = text.substr(colon + 1);
  if (address.host.front() == '[' && address.host.back() == ']') {
    address.host = address.host.substr(1, address.host.size() - 2);
  }
  const bool digits = std::all_of(address.port.begin(), address.port.end(),
                                  [](char c) { return c >= '0' && c <= '9'; });
  constexpr int highest_port = 65535;
  if (!digits || address.port.empty() || address.port.size() > 5 ||
      std::stoi(address.port) > highest_port) {
    throw bad_address(text, std::string(forms) + " with a port of 0 to 65535");
  }
  return address;
}

std::string SocketAddress::text() const {
  if (is_unix) return "unix:" + path;
  return (host.find(':') == std::string::npos ? host : "[" + host + "]") + ":" + port;
}

ResolvedAddress resolve(const SocketAddress& address, const Deadline& deadline) {
  if (address.is_unix) return {asio::local::stream_protocol::endpoint(address.path), true};
  struct Answer {
    boost::system::error_code error;
    asio::ip::tcp::resolver::results_type found;
  };
  // The system's look-up has no limit of its own; one that is late is left to itself.
  std::promise<Answer> promise;
  std::future<Answer> future = promise.get_future();
  std::thread([host = address.host, port = address.port, promise = std::move(promise)]() mutable {
    Answer answer;
    asio::io_context io;
    answer.found = asio::ip::tcp::resolver(io).resolve(host, port, answer.error);
    promise.set_value(std::move(answer));
  }).detach();
  if (future.wait_for(std::chrono::duration<double>(deadline.remaining_s())) !=
      std::future_status::ready) {
    throw deadline.error("the look-up of host " + address.host);
  }
  const Answer answer = future.get();
  if (answer.error || answer.found.empty()) {
    throw bad_address(address.text(),
                      "a host that this machine can look up (" + answer.error.message() + ")");
  }
  const asio::ip::tcp::endpoint endpoint = *answer.found.begin();
  return {endpoint, endpoint.address().is_loopback()};
}

void write_rendezvous(const std::string& file, const SocketAddress& address) {
  const std::string beside = file + "." + std::to_string(getpid()) + ".new";
  {
    std::ofstream out(beside);
    out << rendezvous_mark << address.text() << "\n";
    out.flush();
    if (!out) {
      std::remove(beside.c_str());
      throw BridgeError(BridgeError::Kind::bad_input, "rendezvous file", file,
                        "a file in a folder that can be written",
                        "create the folder, or give another file");
    }
  }
  if (std::rename(beside.c_str(), file.c_str()) != 0) {
    std::remove(beside.c_str());
    throw BridgeError(BridgeError::Kind::bad_input, "rendezvous file", file,
                      "a name that is not that of a folder", "give another file");
  }
}

bool read_rendezvous(const std::string& file, SocketAddress& address) {
  std::ifstream in(file);
  if (!in) return false;
  std::string line;
  std::getline(in, line);
  if (line.rfind(rendezvous_mark, 0) != 0) {
    throw BridgeError(BridgeError::Kind::bad_input, "rendezvous file", file,
                      std::string("a file that begins with '") + rendezvous_mark + "'",
                      "give the file that the other program writes, of the same release");
  }
  address = SocketAddress::parse(line.substr(std::string(rendezvous_mark).size()));
  return true;
}

}  // namespace powderlink::bridge
