// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report/typeset.h"

#include <cctype>
#include <regex>

namespace powderlink::analysis {

std::string typeset(std::string text) {
  static const std::pair<std::regex, const char*> signs[] = {
      // A value follows, with its unit: the name need not tell it once more.
      {std::regex(R"(\badhesive_energy_J_m2( = | stopped))"), "Γ$1"},
      {std::regex(R"(\b([A-Za-z]\w*?)_(kg_m3|[JC]_m2|N_m|m_s|Pa|um|us|s|m|N) = )"), "$1 = "},
      {std::regex(R"(\bGamma\b)"), "Γ"},
      {std::regex(R"(\b(scatter|curve|rank|runs) over impact_velocity_m_s)"),
       "$1 over impact velocity"},
      {std::regex(R"(\b(curve|rank|runs) over diameter_um)"), "$1 over diameter"},
      {std::regex(R"(\b(rank|runs) over contact_time_us)"), "$1 over contact time"},
      {std::regex(R"(\b(rank|runs) over adhesive_energy_J_m2)"), "$1 over Γ"},
      {std::regex(R"(\bchi\^2)"), "χ²"},
      {std::regex(R"(\bdelta BIC)"), "ΔBIC"},
      {std::regex(R"(\^2\b)"), "²"},
      {std::regex(R"(\^3\b)"), "³"},
      {std::regex(R"(\bum\b)"), "µm"},
      {std::regex(R"(\bus\b)"), "µs"},
      {std::regex(R"(([0-9]) %)"), "$1\u00a0%"}};
  for (const auto& [pattern, sign] : signs) text = std::regex_replace(text, pattern, sign);
  return text;
}

std::string sentence(const std::string& text) {
  std::string s = typeset(text);
  if (s.empty()) return s;
  const std::string first = s.substr(0, s.find_first_of(" :,"));
  if (first.find('_') == std::string::npos)
    s[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(s[0])));
  if (std::string(".!?").find(s.back()) == std::string::npos) s += '.';
  return s;
}

std::vector<std::string> parts(const std::string& text) {
  std::vector<std::string> list;
  std::size_t from = 0;
  for (std::size_t to = 0; (to = text.find("; ", from)) != std::string::npos; from = to + 2)
    list.push_back(text.substr(from, to - from));
  list.push_back(text.substr(from));
  return list;
}

}  // namespace powderlink::analysis
