#include "contact_check.hpp"

#include <mpi.h>

#include <array>
#include <memory>

#include "contact/contact.hpp"
#include "linalg/profile.hpp"

namespace soft::cli {
namespace {

/// Broadcasts the event of rank 0; a text length of -1 encodes nullopt.
std::optional<solver::ContactEvent> from_first_rank(const std::optional<solver::ContactEvent>& found, MPI_Comm comm) {
    std::array<int, 3> head{-1, 0, 0};
    if (found)
        head = {static_cast<int>(found->text.size()), static_cast<int>(found->reason),
                static_cast<int>(found->is_driven)};
    MPI_Bcast(head.data(), 3, MPI_INT, 0, comm);
    if (head[0] < 0) return std::nullopt;
    solver::ContactEvent event{found ? found->text : "", static_cast<model::StopReason>(head[1]), head[2] != 0};
    event.text.resize(static_cast<std::size_t>(head[0]));
    MPI_Bcast(event.text.data(), head[0], MPI_CHAR, 0, comm);
    return event;
}

}  // namespace

solver::ContactCheck contact_check(fem::System& system) {
    if (system.input().path.contact == model::Contact::ignore) return {};
    int rank = 0;
    MPI_Comm_rank(system.comm(), &rank);
    // std::function copies its captures, and a ContactFinder cannot be copied: hence the shared_ptr.
    const auto finder = rank == 0 ? std::make_shared<const contact::ContactFinder>(system.input()) : nullptr;
    return [&system, finder](Vec x) {
        const auto displacement_m = system.fields().gather_displacements(x);
        const auto shifts = system.contact().shifts(x);
        std::optional<solver::ContactEvent> found;
        const linalg::ScopedTimer timed(linalg::Phase::contact);
        if (finder)
            if (auto contact = finder->find(displacement_m, shifts))
                found = {std::move(contact->text),
                         contact->is_inverted ? model::StopReason::inverted_element : model::StopReason::self_contact,
                         contact->is_driven};
        return from_first_rank(found, system.comm());
    };
}

}  // namespace soft::cli
