// SPDX-License-Identifier: GPL-3.0-or-later
/// \file study_text.h
/// A study as TOML, with an effect added: what `powderlink add` writes.
/// Tests: tests/analysis/program/evidence_commands_test.cpp
#pragma once

#include <filesystem>
#include <string>

#include "analysis/evidence/candidate.h"

namespace powderlink::analysis {

/// The study of `candidate`, which adds to the effects of `study`: fitted values of effects are fixed,
/// Gamma keeps its bounds. \param file  where it will stand: paths become relative to it
std::string study_text(const Study& study, const Candidate& candidate,
                       const std::filesystem::path& file);

}  // namespace powderlink::analysis
