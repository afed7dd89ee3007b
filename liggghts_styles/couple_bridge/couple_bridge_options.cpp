// SPDX-License-Identifier: GPL-3.0-or-later
#include "liggghts_styles/couple_bridge/couple_bridge_options.h"

#include <set>

#include "liggghts_styles/host/argument_words.h"

namespace powderlink::host {

namespace {

const char* const kKeywords =
    "every, transport, address, rendezvous, token, connect, listen, timeout, case, checkpoint, "
    "sizes";

}  // namespace

CoupleBridgeOptions CoupleBridgeOptions::parse(int narg, const char* const* arg,
                                               const std::string& folder) {
  CoupleBridgeOptions o;
  o.case_name = folder;
  Words words(narg, arg);
  std::set<std::string> given;
  while (words.more()) {
    const std::string key = words.next("keyword", kKeywords);
    const bool side = key == "connect" || key == "listen";
    if (!given.insert(side ? "connect or listen" : key).second) {
      throw InvalidInput("keyword " + key, "twice", "every keyword once", "remove one of them");
    }
    if (key == "every") {
      o.every = words.count("every", 1);
    } else if (key == "transport") {
      const std::string way = words.next("transport", "mpi | socket");
      if (way != "mpi" && way != "socket") {
        throw InvalidInput("transport", way, "mpi | socket", "name one of them");
      }
      o.socket = way == "socket";
    } else if (key == "address") {
      o.address = words.next("address", "unix:PATH | HOST:PORT");
    } else if (key == "rendezvous") {
      o.rendezvous_file = words.next("rendezvous", "a file name");
    } else if (key == "token") {
      o.token = words.next("token", "one word, the same on both sides");
    } else if (side) {
      o.listens = key == "listen";
    } else if (key == "timeout") {
      o.timeout_s = words.number("timeout", 0.01, 1e6, "0.01 to 1e6 s");
    } else if (key == "case") {
      o.case_name = words.next("case", "a name, the same on both sides");
    } else if (key == "checkpoint") {
      o.checkpoint_prefix = words.next("checkpoint", "beginning of a file name");
      if (o.checkpoint_prefix.find_first_of("*%") != std::string::npos) {
        throw InvalidInput("checkpoint", o.checkpoint_prefix, "a name without * and %",
                           "give the beginning of the name; the step is added to it");
      }
    } else if (key == "sizes") {
      const std::string sizes = words.next("sizes", "like | any");
      if (sizes != "like" && sizes != "any") {
        throw InvalidInput("sizes", sizes, "like | any", "name one of them");
      }
      o.any_size = sizes == "any";
    } else {
      throw InvalidInput("keyword of fix couple/bridge", key, kKeywords, "correct the spelling");
    }
  }
  if (o.every == 0) {
    throw InvalidInput("fix couple/bridge", "a line without every", "every N [...]",
                       "give the number of DEM steps between two exchanges");
  }
  if (!o.socket) {
    for (const char* key : {"address", "rendezvous", "token", "connect or listen"}) {
      if (given.count(key) == 0) continue;
      throw InvalidInput(std::string("keyword ") + key, "with transport mpi",
                         "with transport socket only", "remove it, or add: transport socket");
    }
  }
  if (o.socket && o.address.empty() && o.rendezvous_file.empty()) {
    o.rendezvous_file = "bridge.address";
  }
  return o;
}

}  // namespace powderlink::host
