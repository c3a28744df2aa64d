#include "linalg/multifrontal.hpp"

#include <cholmod.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "linalg/dense_factor.hpp"
#include "linalg/elimination_order.hpp"
#include "linalg/front.hpp"
#include "linalg/matrix_rows.hpp"
#include "linalg/supernodes.hpp"
#include "math/threads.hpp"

namespace soft::linalg {

namespace {

static_assert(sizeof(PetscInt) == sizeof(int), "CHOLMOD's int interface is used");

constexpr double min_diagonal = 1e-6;

/// Bound of the eigenvalues of F^-1 A (contraction_of). Below 1 no F + t A with t from 0 to 1 is singular, so that det K has the sign that the
/// inertia of F gives.
constexpr double largest_contraction = 0.9;
constexpr int power_iterations = 12;
/// A front with more columns is not factorised twice.
constexpr std::size_t most_unsymmetric = 2000;
/// Matrices with fewer flops are factorised by one thread.
constexpr double flops_of_threads = 5e7;

/// Flops that eliminate `columns` of `rows`.
double flops_of(double rows, double columns) {
    const double rest = rows - columns;
    return columns * columns * columns / 3 + columns * columns * rest + columns * rest * rest;
}

/// A node of the assembly tree.
struct Node {
    std::size_t columns = 0;    ///< eliminated here
    std::vector<int> rows{};    ///< positions in the elimination order, ascending, beginning with the eliminated ones
    std::vector<int> places{};  ///< of the other rows among those of the parent
    std::vector<int> children{};
    double flops_below = 0;  ///< of the subtree
    Front front{};
    std::optional<DenseFactor> unsymmetric{};  ///< of a root with unknowns that are eliminated last
    std::vector<double> part{};                ///< of the vector in solve(), by rows
};

/// Work on a child is a task if its subtree has more flops (for solves: flops of the factorisation) than this.
constexpr double flops_of_a_task = 5e6;

/// Storage of updates. Memory that the system provides again for each front costs as much time as a third of the factorisation.
class Storage {
public:
    /// The smallest vector with this capacity, or a new one.
    [[nodiscard]] std::vector<double> take(std::size_t entries) {
        const std::lock_guard lock(mutex_);
        const auto found = free_.lower_bound(entries);
        if (found == free_.end()) return {};
        return std::move(free_.extract(found).mapped());
    }
    void give(std::vector<double> vector) {
        const std::lock_guard lock(mutex_);
        free_.emplace(vector.capacity(), std::move(vector));
    }

private:
    std::mutex mutex_;
    std::multimap<std::size_t, std::vector<double>> free_;  // by capacity
};

/// Estimate of the largest |eigenvalue| of F^-1 A by the power method, from an arbitrary start; F is a front that is eliminated as a whole,
/// and A antisymmetric: the eigenvalues are pairs of opposite signs, so that only every second ratio of lengths converges.
double contraction_of(const Front& front, const std::vector<double>& A, std::size_t n) {
    std::vector<double> x(n), y(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = std::sin(static_cast<double>(1 + i * i));
    double ratio = 0, before = 0, size = std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
    for (int i = 0; i < power_iterations; ++i) {
        std::ranges::fill(y, 0.0);
        for (std::size_t c = 0; c < n; ++c)
            for (std::size_t r = 0; r < n; ++r) y[r] += A[c * n + r] * x[c];
        front.forward(y);
        front.backward(y);
        before = std::exchange(ratio, std::sqrt(std::inner_product(y.begin(), y.end(), y.begin(), 0.0)) / size);
        if (!(ratio > 0.0)) return ratio;
        for (std::size_t r = 0; r < n; ++r) x[r] = y[r] / (ratio * size);
        size = 1.0;
    }
    return std::sqrt(before * ratio);
}

std::vector<double> bounded_diagonal(const MatrixRows& rows) {
    std::vector<double> own(static_cast<std::size_t>(rows.count), 0.0);
    for (PetscInt row = 0; row < rows.count; ++row) {
        const auto columns = columns_of(rows, row);
        const auto found = std::ranges::lower_bound(columns, row);
        if (found != columns.end() && *found == row)
            own[static_cast<std::size_t>(row)] = rows.values[rows.begin[row] + (found - columns.begin())];
    }
    std::vector<double> bounded = own;
    for (PetscInt row = 0; row < rows.count; ++row) {
        double& diagonal = bounded[static_cast<std::size_t>(row)];
        if (diagonal > 0.0) continue;
        double schur = 0;
        for (PetscInt k = rows.begin[row]; k < rows.begin[row + 1]; ++k) {
            const double other = own[static_cast<std::size_t>(rows.columns[k])];
            if (other > 0.0) schur += rows.values[k] * rows.values[k] / other;
        }
        diagonal = std::min(diagonal, -min_diagonal * schur);
    }
    return bounded;
}

}  // namespace

struct Multifrontal::Parts {
    int threads = 1;
    std::vector<PetscInt> unknown, position;  ///< [position] and [unknown]
    std::vector<Node> nodes;                  ///< children before their parents
    std::vector<int> roots;
    std::vector<PetscInt> last;  ///< unknowns with unsymmetric entries among each other
    bool transposed = false;
    double flops = 0;
    std::vector<double> diagonal;  ///< [unknown]
    Storage storage;
    std::atomic<bool> failed = false, out_of_memory = false;
    MPI_Comm ranks = MPI_COMM_SELF;
    Matrix whole;  ///< the whole distributed K, on every rank
    Scatter to_all;
    Vector all;  ///< the whole right-hand side, on every rank

    [[nodiscard]] bool is_shared() const { return to_all.get() != nullptr; }
    void analyze(const MatrixRows& rows);
    void factorize(const MatrixRows& K, int index);
    void assemble(const MatrixRows& K, Node& node);
    [[nodiscard]] bool eliminate_unsymmetric(const MatrixRows& K, Node& node);
    void forward(int index, std::vector<double>& x);
    void backward(int index, std::vector<double>& x);
    /// Calls work(child) for all children and waits; large subtrees are tasks. work must not throw.
    template <class Work>
    void for_children(const Node& node, const Work& work) const {
        for (const int child : node.children) {
            if (nodes[static_cast<std::size_t>(child)].flops_below > flops_of_a_task) {
#pragma omp task firstprivate(child) shared(work)
                work(child);
            } else {
                work(child);
            }
        }
#pragma omp taskwait
    }
    /// Calls work(root) for all roots, with the threads that take its tasks.
    template <class Work>
    void run(const Work& work) const {
#pragma omp parallel num_threads(threads) if (threads > 1)
#pragma omp single
        for (const int root : roots) work(root);
    }
};

void Multifrontal::Parts::analyze(const MatrixRows& rows) {
    const GroupGraph graph(rows, rows.count);
    std::vector<int> last_groups;
    for (const PetscInt i : last) last_groups.push_back(graph.group_of(i));
    const Supernodes structure(graph, last_groups);
    if (structure.factor() == nullptr) {
        flops = std::numeric_limits<double>::infinity();
        return;
    }
    const cholmod_factor& L = *structure.factor();
    const auto *group_at = static_cast<const int*>(L.Perm), *first_column = static_cast<const int*>(L.super),
               *first_row = static_cast<const int*>(L.pi), *row = static_cast<const int*>(L.s);
    std::vector<int> begin{0};  // [group in elimination order] position of its first unknown
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const auto& group = graph.unknowns(group_at[i]);
        unknown.insert(unknown.end(), group.begin(), group.end());
        begin.push_back(static_cast<int>(unknown.size()));
    }
    position.resize(unknown.size());
    for (std::size_t i = 0; i < unknown.size(); ++i)
        position[static_cast<std::size_t>(unknown[i])] = static_cast<PetscInt>(i);
    std::vector<std::size_t> node_of;  // [position]
    for (std::size_t s = 0; s < L.nsuper; ++s) {
        Node& node = nodes.emplace_back();
        node.columns = static_cast<std::size_t>(begin[static_cast<std::size_t>(first_column[s + 1])] -
                                                begin[static_cast<std::size_t>(first_column[s])]);
        for (int i = first_row[s]; i < first_row[s + 1]; ++i)
            for (int at = begin[static_cast<std::size_t>(row[i])]; at < begin[static_cast<std::size_t>(row[i]) + 1];
                 ++at)
                node.rows.push_back(at);
        node_of.insert(node_of.end(), node.columns, s);
    }
    for (std::size_t s = 0; s < nodes.size(); ++s) {
        Node& node = nodes[s];
        node.part.resize(node.rows.size());
        const double own = flops_of(static_cast<double>(node.rows.size()), static_cast<double>(node.columns));
        flops += own;
        node.flops_below += own;
        if (node.rows.size() == node.columns) {
            roots.push_back(static_cast<int>(s));
            continue;
        }
        Node& parent = nodes[node_of[static_cast<std::size_t>(node.rows[node.columns])]];
        parent.children.push_back(static_cast<int>(s));
        parent.flops_below += node.flops_below;
        std::size_t place = 0;
        for (std::size_t i = node.columns; i < node.rows.size(); ++i) {
            while (parent.rows[place] != node.rows[i]) ++place;
            node.places.push_back(static_cast<int>(place));
        }
    }
}

void Multifrontal::Parts::assemble(const MatrixRows& K, Node& node) {
    static thread_local std::vector<int> place;  // [position] row of the front
    place.resize(position.size());
    for (std::size_t i = 0; i < node.rows.size(); ++i)
        place[static_cast<std::size_t>(node.rows[i])] = static_cast<int>(i);
    const std::size_t others = node.places.size();
    node.front.reset(static_cast<int>(node.rows.size()), static_cast<int>(node.columns),
                     storage.take(others * (others + 1) / 2));
    for (std::size_t c = 0; c < node.columns; ++c) {
        const int own = node.rows[c];
        const PetscInt row = unknown[static_cast<std::size_t>(own)];
        double* column = node.front.column(static_cast<int>(c));
        for (PetscInt k = K.begin[row]; k < K.begin[row + 1]; ++k)
            if (const PetscInt other = position[static_cast<std::size_t>(K.columns[k])]; other > own)
                column[place[static_cast<std::size_t>(other)]] = K.values[k];
        column[c] = diagonal[static_cast<std::size_t>(row)];
    }
    for (const int child : node.children) {
        Node& below = nodes[static_cast<std::size_t>(child)];
        node.front.add(below.front, below.places);
        storage.give(below.front.release_update());
    }
}

/// Eliminates the mean of both entries of each pair in the front of a root, which gives the inertia, and factorises the front with both
/// for the solves, unless the difference is so large that the inertia says little about K, which the iterations of the solver then show.
bool Multifrontal::Parts::eliminate_unsymmetric(const MatrixRows& K, Node& node) {
    const std::size_t n = node.columns;
    std::vector<double> full(n * n), difference(n * n);              // of columns
    const auto begin = static_cast<std::size_t>(node.rows.front());  // its rows are consecutive
    for (std::size_t r = 0; r < n; ++r) {
        const PetscInt row = unknown[begin + r];
        for (PetscInt k = K.begin[row]; k < K.begin[row + 1]; ++k) {
            const auto other = static_cast<std::size_t>(position[static_cast<std::size_t>(K.columns[k])]);
            if (other < begin || other == begin + r) continue;
            const std::size_t c = other - begin;
            difference[c * n + r] += 0.5 * K.values[k];
            difference[r * n + c] -= 0.5 * K.values[k];
        }
    }
    for (std::size_t c = 0; c < n; ++c)
        for (std::size_t r = c; r < n; ++r) {  // both entries have the value of the row eliminated first
            double& mean = node.front.column(static_cast<int>(c))[r];
            mean += difference[c * n + r];
            full[r * n + c] = mean + difference[r * n + c];
            full[c * n + r] = mean + difference[c * n + r];
        }
    node.unsymmetric.reset();
    if (!node.front.eliminate()) return false;
    if (!(contraction_of(node.front, difference, n) < largest_contraction)) return true;
    return node.unsymmetric.emplace(Symmetry::general).factorize(std::move(full), static_cast<int>(n));
}

/// The subtree of a node. Called by one thread of a team; the other threads take its tasks.
void Multifrontal::Parts::factorize(const MatrixRows& K, int index) {
    Node& node = nodes[static_cast<std::size_t>(index)];
    for_children(node, [&](int child) { factorize(K, child); });
    if (failed || out_of_memory) return;
    try {
        assemble(K, node);
        const bool is_root = node.rows.size() == node.columns && node.columns <= most_unsymmetric;
        if (!(!last.empty() && is_root ? eliminate_unsymmetric(K, node) : node.front.eliminate())) failed = true;
    } catch (const std::bad_alloc&) {  // an exception must not leave a task
        out_of_memory = true;
    }
}

/// L D y = x in the subtree of a node.
void Multifrontal::Parts::forward(int index, std::vector<double>& x) {
    Node& node = nodes[static_cast<std::size_t>(index)];
    for_children(node, [&](int child) { forward(child, x); });
    const auto own = std::span(x).subspan(static_cast<std::size_t>(node.rows.front()), node.columns);
    std::ranges::fill(node.part, 0.0);
    std::ranges::copy(own, node.part.begin());
    for (const int child : node.children) {
        const Node& below = nodes[static_cast<std::size_t>(child)];
        for (std::size_t i = 0; i < below.places.size(); ++i)
            node.part[static_cast<std::size_t>(below.places[i])] += below.part[below.columns + i];
    }
    if (node.unsymmetric) return;
    node.front.forward(node.part);
    std::copy_n(node.part.begin(), node.columns, own.begin());
}

/// L^T x = y in the subtree of a node; the part of its parent is known.
void Multifrontal::Parts::backward(int index, std::vector<double>& x) {
    Node& node = nodes[static_cast<std::size_t>(index)];
    if (node.unsymmetric)
        node.unsymmetric->solve(node.part, transposed);
    else
        node.front.backward(node.part);
    std::copy_n(node.part.begin(), node.columns, x.begin() + node.rows.front());
    for_children(node, [&](int child) {
        Node& below = nodes[static_cast<std::size_t>(child)];
        for (std::size_t i = 0; i < below.places.size(); ++i)
            below.part[below.columns + i] = node.part[static_cast<std::size_t>(below.places[i])];
        backward(child, x);
    });
}

Multifrontal::Multifrontal(Mat K, int threads, std::vector<PetscInt> last) : parts_(std::make_unique<Parts>()) {
    parts_->last = std::move(last);
    int size = 1;
    SOFT_PETSC(PetscObjectGetComm(reinterpret_cast<PetscObject>(K), &parts_->ranks));
    MPI_Comm_size(parts_->ranks, &size);
    if (size > 1) {  // PETSc's communicator: to_all keeps it alive
        SOFT_PETSC(MatCreateRedundantMatrix(K, size, MPI_COMM_NULL, MAT_INITIAL_MATRIX, parts_->whole.out()));
        Vector like;
        SOFT_PETSC(MatCreateVecs(K, nullptr, like.out()));
        SOFT_PETSC(VecScatterCreateToAll(like, parts_->to_all.out(), parts_->all.out()));
    }
    parts_->analyze(rows_of(size > 1 ? parts_->whole.get() : K));
    parts_->threads = parts_->flops > flops_of_threads ? thread_count(threads) : 1;
}

Multifrontal::~Multifrontal() = default;

void Multifrontal::set_transposed(bool transposed) { parts_->transposed = transposed; }

double Multifrontal::flops() const { return parts_->flops; }

bool Multifrontal::factorize(Mat K) {
    if (parts_->is_shared()) {
        int size = 1;
        MPI_Comm_size(parts_->ranks, &size);
        SOFT_PETSC(MatCreateRedundantMatrix(K, size, MPI_COMM_NULL, MAT_REUSE_MATRIX, parts_->whole.out()));
        K = parts_->whole;
    }
    const MatrixRows rows = rows_of(K);
    parts_->diagonal = bounded_diagonal(rows);
    parts_->failed = parts_->out_of_memory = false;
    parts_->run([&](int root) { parts_->factorize(rows, root); });
    if (parts_->out_of_memory) throw std::bad_alloc();
    int good = parts_->failed ? 0 : 1;  // last digits may differ between processor types: rank 0 decides
    if (parts_->is_shared()) MPI_Bcast(&good, 1, MPI_INT, 0, parts_->ranks);
    return good != 0;
}

std::optional<PetscInt> Multifrontal::negative_pivots() const {
    PetscInt negative = 0;
    for (const Node& node : parts_->nodes) negative += node.front.negative_pivots();
    if (parts_->is_shared()) MPI_Bcast(&negative, 1, MPIU_INT, 0, parts_->ranks);
    return negative;
}

void Multifrontal::solve(Vec b, Vec x) {
    PetscInt begin = 0, end = 0;
    SOFT_PETSC(VecGetOwnershipRange(x, &begin, &end));
    if (parts_->is_shared()) {
        SOFT_PETSC(VecScatterBegin(parts_->to_all, b, parts_->all, INSERT_VALUES, SCATTER_FORWARD));
        SOFT_PETSC(VecScatterEnd(parts_->to_all, b, parts_->all, INSERT_VALUES, SCATTER_FORWARD));
        b = parts_->all;
    }
    std::vector<double> y;  // [position]
    y.reserve(parts_->unknown.size());
    const PetscScalar* from = nullptr;
    SOFT_PETSC(VecGetArrayRead(b, &from));
    for (const PetscInt i : parts_->unknown) y.push_back(from[i]);
    SOFT_PETSC(VecRestoreArrayRead(b, &from));
    parts_->run([&](int root) {
        parts_->forward(root, y);
        parts_->backward(root, y);
    });
    PetscScalar* to = nullptr;
    SOFT_PETSC(VecGetArray(x, &to));
    for (PetscInt i = begin; i < end; ++i)
        to[i - begin] = y[static_cast<std::size_t>(parts_->position[static_cast<std::size_t>(i)])];
    SOFT_PETSC(VecRestoreArray(x, &to));
}

}  // namespace soft::linalg
