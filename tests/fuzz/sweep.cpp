/// Fuzz target: sweeps (YAML) and the lines of solve --batch.
#include "sweep/sweep.hpp"

#include "core/text.hpp"
#include "sweep/plan.hpp"
#include "target.hpp"

void soft::fuzz::read(std::span<const std::byte> bytes) {
    const std::string_view text = text_of(bytes);
    if (const auto words = core::shell_words(text)) {
        std::string line;
        for (const std::string& word : *words) {
            line += "'";
            for (const char c : word) line += c == '\'' ? std::string{"'\\''"} : std::string{c};
            line += "' ";
        }
        require(core::shell_words(line) == words, "quoted words parse to the same words");
    }
    const sweep::Sweep sweep = sweep::read_sweep(text, "fuzz.yaml");
    require(!sweep.factors.empty() && !sweep.at.empty(), "a sweep has factors and requested values");
    if (sweep.method != sweep::Method::grid && sweep.samples > 100) return;
    for (const sweep::Factor& factor : sweep.factors) {
        require(!sweep::value_at(factor, 0.5).empty(), "a value is not empty");
        if (sweep.method != sweep::Method::grid) continue;
        for (int k = 0; k < sweep::level_count(factor) && k < 100; ++k)
            require(sweep::level(factor, k).find('\n') == std::string::npos, "a value is one line");
    }
}
