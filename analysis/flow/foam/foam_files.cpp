// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/flow/foam/foam_files.h"

#include <stdlib.h>
#include <unistd.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/files/file_text.h"
#include "base/files/write_file.h"
#include "base/invalid_input.h"
#include "base/process/child_process.h"

namespace powderlink::analysis {

namespace fs = std::filesystem;

namespace {

constexpr double kLimit_s = 60.0;

fs::path reader_program() {
  const char* given = std::getenv("POWDERLINK_FOAM");
  const fs::path program = given != nullptr && *given != '\0'
                               ? fs::absolute(given)
                               : fs::canonical("/proc/self/exe").parent_path() / "powderlink-foam";
  if (::access(program.c_str(), X_OK) != 0) {
    throw InvalidInput("reading OpenFOAM's files", program.string() + " is not there",
                       "the program powderlink-foam, which is built where OpenFOAM is installed",
                       "run scripts/setup.sh and build again, "
                       "or name it in the variable POWDERLINK_FOAM");
  }
  return program;
}

/// Of questions and answers; vanishes.
class Letters {
 public:
  Letters() {
    std::string name = (fs::temp_directory_path() / "powderlink-foam.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw InvalidInput("reading OpenFOAM's files", name, "a folder for temporary files",
                         "set TMPDIR to a folder that may be written");
    }
    path_ = name;
  }
  ~Letters() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Letters(const Letters&) = delete;
  Letters& operator=(const Letters&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

nlohmann::json ask(const fs::path& case_folder, const nlohmann::json& questions) {
  const fs::path program = reader_program();
  const Letters letters;
  const fs::path asked = letters.path() / "questions.json";
  const fs::path answered = letters.path() / "answers.json";
  write_file(asked, questions.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  const fs::path folder = fs::canonical(case_folder);
  std::vector<std::string> command{"env", "FOAM_CASE=" + folder.string(),
                                   "FOAM_CASENAME=" + folder.filename().string()};
#ifdef POWDERLINK_FOAM_PROJECT_DIR
  // OpenFOAM's libraries look for their own etc/controlDict.
  if (std::getenv("WM_PROJECT_DIR") == nullptr) {
    command.emplace_back("WM_PROJECT_DIR=" POWDERLINK_FOAM_PROJECT_DIR);
  }
#endif
  command.insert(command.end(), {program.string(), asked.string(), answered.string()});
  const ChildOutcome outcome = run_child(command, folder, letters.path() / "messages", kLimit_s);
  const auto answers = nlohmann::json::parse(file_text_or_empty(answered), nullptr, false);
  if (outcome.exit_status != 0 || outcome.over_time || answers.is_discarded()) {
    throw InvalidInput(
        "reading OpenFOAM's files of " + case_folder.string(),
        program.filename().string() + " ended with status " + std::to_string(outcome.exit_status),
        "dictionaries and a mesh that OpenFOAM reads",
        "look for a file that includes itself; `foamDictionary FILE` shows what OpenFOAM reads");
  }
  return answers;
}

fs::path in_case(const fs::path& case_folder, const fs::path& file) {
  return fs::absolute(case_folder / file).lexically_normal();
}

nlohmann::json question_of(const fs::path& case_folder, const FoamQuestion& question) {
  return {{"file", in_case(case_folder, question.file).string()}, {"entry", question.entry}};
}

/// Throws for what cannot be used.
std::string usable_state(const nlohmann::json& answer, const fs::path& file,
                         const std::string& entry) {
  std::string state = answer.at("state").get<std::string>();
  const std::string what = "entry " + entry + " of " + file.string();
  if (state == "error") {
    throw InvalidInput("reading " + file.string(), answer.at("text").get<std::string>(),
                       "a dictionary that OpenFOAM reads", "correct the file");
  }
  if (state == "code") {
    throw InvalidInput(what, "a value that comes of code (#calc, #codeStream), which is not run",
                       "a value, a macro or #eval",
                       "write the value, or give it as an option where there is one");
  }
  if (state == "impossible") {
    throw InvalidInput("changing " + what, "what OpenFOAM makes of the file does not follow",
                       "an entry that may be given at the end of the file",
                       "look for #inputMode and #remove, and write the entry yourself");
  }
  return state;
}

}  // namespace

bool foam_file_exists(const fs::path& file) {
  std::error_code absent;
  return fs::is_regular_file(file, absent) || fs::is_regular_file(file.string() + ".gz", absent);
}

std::vector<std::optional<FoamEntry>> read_foam_entries(const fs::path& case_folder,
                                                        const std::vector<FoamQuestion>& questions,
                                                        UnreadableFile unreadable) {
  std::vector<std::optional<FoamEntry>> found(questions.size());
  nlohmann::json reads = nlohmann::json::array();
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if (!foam_file_exists(in_case(case_folder, questions[i].file))) continue;
    reads.push_back(question_of(case_folder, questions[i]));
    asked.push_back(i);
  }
  if (asked.empty()) return found;
  const nlohmann::json answers = ask(case_folder, {{"reads", reads}});
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const FoamQuestion& question = questions[asked[k]];
    const nlohmann::json& answer = answers.at("reads").at(k);
    if (unreadable == UnreadableFile::left_out && answer.at("state") != "value") continue;
    if (usable_state(answer, case_folder / question.file, question.entry) != "value") continue;
    FoamEntry entry{answer.at("text").get<std::string>(), {}};
    if (answer.at("number").is_number()) entry.number = answer.at("number").get<double>();
    found[asked[k]] = std::move(entry);
  }
  return found;
}

std::optional<FoamEntry> read_foam_entry(const fs::path& case_folder,
                                         const FoamQuestion& question) {
  return read_foam_entries(case_folder, {question}).front();
}

std::optional<std::string> change_foam_entry(const fs::path& case_folder,
                                             const FoamQuestion& question,
                                             const std::string& value) {
  const fs::path file = case_folder / question.file;
  if (!fs::is_regular_file(file)) {
    throw InvalidInput("changing " + file.string(),
                       foam_file_exists(file) ? "a compressed file" : "no such file",
                       "a text file of the case",
                       foam_file_exists(file) ? "gunzip it" : "correct the path of the case");
  }
  nlohmann::json change = question_of(case_folder, question);
  change["value"] = value;
  const nlohmann::json answer = ask(case_folder, {{"change", change}}).at("change");
  if (usable_state(answer, file, question.entry) == "unchanged") return {};
  return answer.at("text").get<std::string>();
}

std::optional<FoamExtent> foam_mesh_extent(const fs::path& case_folder) {
  const auto has_mesh = [](const fs::path& root) {
    return foam_file_exists(root / "constant" / "polyMesh" / "points");
  };
  if (!has_mesh(case_folder) && !has_mesh(case_folder / "processor0")) return {};
  const nlohmann::json box =
      ask(case_folder, {{"extentOf", fs::canonical(case_folder).string()}}).at("extentOf");
  if (!box.contains("low")) return {};
  return FoamExtent{box.at("low").get<std::array<double, 3>>(),
                    box.at("high").get<std::array<double, 3>>()};
}

}  // namespace powderlink::analysis
