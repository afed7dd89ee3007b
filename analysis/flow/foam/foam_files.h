// SPDX-License-Identifier: GPL-3.0-or-later
/// \file foam_files.h
/// Files of an OpenFOAM case as OpenFOAM itself reads them: the program powderlink-foam, which is
/// linked to OpenFOAM, answers. One process for all questions, some 30 ms.
/// An entry is what `foamDictionary -entry NAME -value` says: includes, macros, several entries on a
/// line, comments, quoted and regular keys, the last of several; FILE.gz where FILE is not there.
/// Directives that compile code (#calc, #codeStream) are never run; what comes of them is refused.
/// POWDERLINK_FOAM of the environment names the program, else it is beside this one.
/// Tests: tests/analysis/flow/foam_files_test.cpp
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace powderlink::analysis {

struct FoamQuestion {
  std::filesystem::path file;  ///< within the case, or absolute
  std::string entry;           ///< with slashes between dictionaries: solvers/p
};

struct FoamEntry {
  std::string text;              ///< as foamDictionary prints it
  std::optional<double> number;  ///< when it is one, with or without [dimensions]
};

/// Whether OpenFOAM would find the file, compressed or not.
bool foam_file_exists(const std::filesystem::path& file);

/// What a program wrote may have been cut off, what a user wrote is to be mended.
enum class UnreadableFile { refused, left_out };

/// One answer per question; empty where there is no such file or entry. Throws for what OpenFOAM
/// cannot read and for entries that come of code, unless they are to be left out.
std::vector<std::optional<FoamEntry>> read_foam_entries(
    const std::filesystem::path& case_folder, const std::vector<FoamQuestion>& questions,
    UnreadableFile unreadable = UnreadableFile::refused);

/// The same for one entry.
std::optional<FoamEntry> read_foam_entry(const std::filesystem::path& case_folder,
                                         const FoamQuestion& question);

/// The text of `question.file` with which OpenFOAM sees `value` in that top-level entry and no other
/// change; empty when it sees it already. Nothing is written. Throws when that cannot be.
std::optional<std::string> change_foam_entry(const std::filesystem::path& case_folder,
                                             const FoamQuestion& question,
                                             const std::string& value);

struct FoamExtent {
  std::array<double, 3> low_m{}, high_m{};
};

/// The box around the mesh, of processor folders too; empty when there is none that can be read.
std::optional<FoamExtent> foam_mesh_extent(const std::filesystem::path& case_folder);

}  // namespace powderlink::analysis
