#include "optimize_trials.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include "cli.hpp"
#include "core/hash.hpp"

namespace soft {
namespace {

nlohmann::json json_of(const optimize::Trial::Value& value) { return {value.value_SI, value.gradient}; }
optimize::Trial::Value value_of(const nlohmann::json& json) {
    return {json.at(0).get<double>(), json.at(1).get<std::vector<double>>()};
}

nlohmann::json json_of(const std::vector<double>& values, const optimize::Trial& trial) {
    nlohmann::json json{{"values", values}};
    if (!trial.failure.empty()) {
        json["failure"] = trial.failure;
        return json;
    }
    json["conditions"] = nlohmann::json::array();
    for (const auto& condition : trial.conditions) json["conditions"].push_back(json_of(condition));
    json["objective"] = json_of(trial.objective);
    json["objective_text"] = trial.objective_text;
    json["stable"] = trial.is_stable;
    return json;
}

optimize::Trial trial_of(const nlohmann::json& json) {
    optimize::Trial trial;
    if (json.contains("failure")) {
        trial.failure = json.at("failure").get<std::string>();
        return trial;
    }
    for (const auto& condition : json.at("conditions")) trial.conditions.push_back(value_of(condition));
    trial.objective = value_of(json.at("objective"));
    trial.objective_text = json.at("objective_text").get<std::string>();
    trial.is_stable = json.at("stable").get<bool>();
    return trial;
}

}  // namespace

TrialFile::TrialFile(const std::filesystem::path& folder, const std::string& goal, bool resumes)
    : file_(folder / "trials.jsonl"), head_("{\"goal\":\"" + core::sha256_hex(goal) + "\"}") {
    std::error_code unknown;
    const bool has_trials = std::filesystem::file_size(file_, unknown) > 0 && !unknown;
    if (!has_trials) {
        append(head_);
        return;
    }
    if (!resumes)
        throw Error(ExitCode::usage, file_.string(), "contains the trials of an earlier search",
                    "continue it with --resume, or name another --folder");
    read();
    std::ifstream in(file_);
    in.seekg(-1, std::ios::end);
    if (in.get() != '\n') append("");  // the last line was cut off
}

void TrialFile::read() {
    std::ifstream in(file_);
    std::string line;
    if (!in || !std::getline(in, line)) throw Error(ExitCode::cannot_open, file_.string(), std::strerror(errno));
    if (line != head_)
        throw Error(ExitCode::bad_input, file_.string(), "contains the trials of another goal or version",
                    "name another --folder");
    while (std::getline(in, line)) try {
            const nlohmann::json json = nlohmann::json::parse(line);
            trials_.insert_or_assign(json.at("values").get<std::vector<double>>(), trial_of(json));
        } catch (const nlohmann::json::exception&) {  // cut off, or not finite
        }
}

void TrialFile::append(const std::string& line) const {
    const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0) throw Error(ExitCode::cannot_create, file_.string(), std::strerror(errno));
    const std::string text = line + "\n";  // one write, so that lines of several processes do not mix
    const ssize_t written = ::write(file, text.data(), text.size());
    const int reason = written < 0 ? errno : ENOSPC;
    ::close(file);
    if (written != static_cast<ssize_t>(text.size()))
        throw Error(ExitCode::io_error, file_.string(), std::strerror(reason));
}

optimize::Trial TrialFile::at(const std::vector<double>& values, const optimize::Evaluate& evaluate) {
    const auto known = trials_.find(values);
    if (known != trials_.end()) return known->second;
    optimize::Trial trial = evaluate(values);
    append(json_of(values, trial).dump());
    return trials_.emplace(values, std::move(trial)).first->second;
}

void run_side_by_side(int count, const std::function<void(int)>& work) {
    std::vector<pid_t> children;
    for (int index = 0; index < count; ++index) {
        const pid_t child = ::fork();
        if (child < 0)
            throw Error(ExitCode::internal, "fork", std::string{"cannot create a process: "} + std::strerror(errno));
        if (child > 0) {
            children.push_back(child);
            continue;
        }
        for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);  // the parent prints the notice
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        try {
            work(index);
        } catch (const std::exception&) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    for (const pid_t child : children)
        while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) {}
}

}  // namespace soft
