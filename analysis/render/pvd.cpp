// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/render/pvd.h"

#include <sstream>

namespace powderlink::render {

std::string pvd_text(const std::vector<PvdEntry>& entries) {
  std::ostringstream text;
  text.precision(12);
  text << "<?xml version=\"1.0\"?>\n"
          "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
          "  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    text << "    <DataSet timestep=\"" << entry.time_s << "\" group=\"\" part=\"0\" file=\""
         << entry.file << "\"/>\n";
  }
  text << "  </Collection>\n</VTKFile>\n";
  return text.str();
}

}  // namespace powderlink::render
