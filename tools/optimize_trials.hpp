#pragma once
/// The trials of an optimization in a file, one line (JSON) each, so that a search can be continued and its starts can run side by side. The search
/// is deterministic: one that finds all its trials in the file gives the same result as the one that computed them.
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "optimize/search.hpp"

namespace soft {

class TrialFile {
public:
    /// `goal`: a text that identifies the goal and its designs. Throws Error: usage if the file has trials but `resumes` is false;
    /// bad_input if they belong to another goal.
    TrialFile(const std::filesystem::path& folder, const std::string& goal, bool resumes);

    /// Reads the trials in the file; a line that was cut off is left out.
    void read();
    [[nodiscard]] std::size_t size() const noexcept { return trials_.size(); }
    /// The trial in the file, or the one that `evaluate` computes, which is added to the file.
    optimize::Trial at(const std::vector<double>& values, const optimize::Evaluate& evaluate);

private:
    void append(const std::string& line) const;

    std::filesystem::path file_;
    std::string head_;
    std::map<std::vector<double>, optimize::Trial> trials_;
};

/// Runs work(0) ... work(count - 1), each in a forked copy of this process, and waits for them. A copy that fails leaves its work to the caller.
void run_side_by_side(int count, const std::function<void(int)>& work);

}  // namespace soft
