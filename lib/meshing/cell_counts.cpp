#include "meshing/cell_counts.hpp"

#include <cstddef>
#include <utility>

namespace soft::meshing {

namespace {

struct Counts {
    std::vector<int>* recorded = nullptr;
    const std::vector<int>* repeated = nullptr;
    std::size_t next = 0;
};
thread_local Counts counts;

/// Returns how many numbers were repeated.
std::size_t run_with(Counts other, const std::function<void()>& generate) {
    struct Restored {
        Counts before;
        ~Restored() { counts = before; }
    } const restored{std::exchange(counts, other)};
    generate();
    return counts.next;
}

}  // namespace

int cell_count(const std::function<int()>& decide) {
    if (counts.repeated != nullptr) {
        const std::size_t place = counts.next++;
        return place < counts.repeated->size() ? (*counts.repeated)[place] : decide();
    }
    std::vector<int>* const recorded = std::exchange(counts.recorded, nullptr);  // a decision may ask for others
    const int decided = decide();
    counts.recorded = recorded;
    if (recorded != nullptr) recorded->push_back(decided);
    return decided;
}

std::vector<int> record_counts(const std::function<void()>& generate) {
    std::vector<int> recorded;
    static_cast<void>(run_with({&recorded, nullptr, 0}, generate));
    return recorded;
}

bool repeat_counts(const std::vector<int>& repeated, const std::function<void()>& generate) {
    return run_with({nullptr, &repeated, 0}, generate) == repeated.size();
}

}  // namespace soft::meshing
