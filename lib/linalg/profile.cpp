#include "linalg/profile.hpp"

#include <algorithm>
#include <array>

#include "linalg/petsc.hpp"

namespace soft::linalg {

namespace {

constexpr std::array<const char*, 5> phase_events{"Residual", "Tangent", "Measures", "Contact", "Writing"};

PetscLogEvent event_of(Phase phase) {
    // PETSc numbers events once a process; a name that is known keeps its number.
    static const std::array<PetscLogEvent, phase_events.size()> events = [] {
        std::array<PetscLogEvent, phase_events.size()> ids{};
        for (std::size_t i = 0; i < ids.size(); ++i) SOFT_PETSC(PetscLogEventRegister(phase_events[i], KSP_CLASSID, &ids[i]));
        return ids;
    }();
    return events[static_cast<std::size_t>(phase)];
}

PetscEventPerfInfo logged(const char* event) {
    PetscLogEvent id = -1;
    PetscEventPerfInfo info{};
    SOFT_PETSC(PetscLogEventGetId(event, &id));
    if (id >= 0) SOFT_PETSC(PetscLogEventGetPerfInfo(0, id, &info));
    return info;
}

ProfileRow row(const char* what, std::initializer_list<const char*> events) {
    ProfileRow result{what, 0, 0};
    for (const char* event : events) {
        const PetscEventPerfInfo info = logged(event);
        result.calls += info.count;
        result.seconds += info.time;
    }
    return result;
}

}  // namespace

Timed::Timed(Phase phase) : event_(event_of(phase)) { (void)PetscLogEventBegin(event_, nullptr, nullptr, nullptr, nullptr); }

Timed::~Timed() { (void)PetscLogEventEnd(event_, nullptr, nullptr, nullptr, nullptr); }

void start_profile() {
    SOFT_PETSC(PetscLogDefaultBegin());
    for (std::size_t i = 0; i < phase_events.size(); ++i) (void)event_of(static_cast<Phase>(i));
}

std::vector<ProfileRow> profile_rows() {
    const ProfileRow triangular = row("", {"MatSolve"});
    ProfileRow krylov = row("iterations of the linear solver, without its solves by factors", {"KSPSolve"});
    krylov.seconds -= triangular.seconds;
    std::vector<ProfileRow> rows{
        row("residuals: cells, facets, loads", {phase_events[0]}),
        row("tangents: cells, facets, their sums", {phase_events[1]}),
        row("volumes, outputs, stretches", {phase_events[2]}),
        row("ordering of the unknowns", {"MatLUFactorSym", "MatCholFctrSym"}),
        row("factorisations", {"MatLUFactorNum", "MatCholFctrNum"}),
        row("solves by factors", {"MatSolve"}),
        krylov,
        row("search for walls that touch", {phase_events[3]}),
        row("rows of the result", {phase_events[4]}),
    };
    std::erase_if(rows, [](const ProfileRow& r) { return r.calls == 0; });
    return rows;
}

}  // namespace soft::linalg
