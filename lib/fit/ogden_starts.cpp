#include "fit/separable.hpp"

#include <cmath>
#include <limits>

namespace soft::fit {
namespace {

constexpr int max_terms = material::Ogden::max_terms;
/// Exponents per sign, by the number of terms: at most about 10 000 sets.
constexpr std::array<int, max_terms> list_lengths{60, 36, 20, 12};
constexpr double min_start_exponent = 0.1, max_start_exponent = 11.0;  // within the bounds of the search
/// Columns closer than this count as linearly dependent: the inner products keep half the digits.
constexpr double min_pivot = 1e-9;

using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_terms, max_terms>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_terms, 1>;

std::vector<double> exponents(int length) {
    std::vector<double> list;
    for (const double sign : {-1.0, 1.0})
        for (int i = 0; i < length; ++i)
            list.push_back(sign * min_start_exponent *
                           std::pow(max_start_exponent / min_start_exponent, i / (length - 1.0)));
    return list;
}

struct Search {
    std::vector<double> list;
    Eigen::MatrixXd products = {};  // inner products of columns scaled to length 1
    Eigen::VectorXd rhs = {};
    Signs signs = Signs::free;
    std::size_t terms = 1;
    std::vector<std::size_t> chosen = {};
    struct Best {
        double gain = -std::numeric_limits<double>::infinity();  // reduction of the sum of squares by the set
        std::vector<double> set = {};
    };
    std::vector<Best> best = {};  // [number of negative exponents]

    void consider() {
        const auto n = static_cast<Eigen::Index>(terms);
        Small G(n, n);
        SmallVector b(n);
        std::size_t negative = 0;
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto at = static_cast<Eigen::Index>(chosen[static_cast<std::size_t>(i)]);
            b[i] = rhs[at];
            negative += list[static_cast<std::size_t>(at)] < 0.0;
            for (Eigen::Index j = 0; j < n; ++j)
                G(i, j) = products(at, static_cast<Eigen::Index>(chosen[static_cast<std::size_t>(j)]));
        }
        const Eigen::LDLT<Small> factors(G);
        if (!(factors.vectorD().minCoeff() > min_pivot)) return;
        const SmallVector c = factors.solve(b);
        if (signs == Signs::stable && !(c.minCoeff() >= 0.0)) return;
        const double gain = b.dot(c);
        if (!(gain > best[negative].gain)) return;
        best[negative] = {gain, {}};
        for (const std::size_t at : chosen) best[negative].set.push_back(list[at]);
    }

    void choose(std::size_t from) {
        if (chosen.size() == terms) return consider();
        for (std::size_t i = from; i < list.size(); ++i) {
            chosen.push_back(i);
            choose(i + 1);
            chosen.pop_back();
        }
    }
};

}  // namespace

std::vector<std::vector<double>> ogden_starts(const Candidate& candidate, const Rows& rows, Signs signs) {
    const auto terms = static_cast<std::size_t>(candidate.linear);
    Search search{.list = exponents(list_lengths[terms - 1]), .signs = signs, .terms = terms};
    const auto count = static_cast<Eigen::Index>(search.list.size());
    Eigen::MatrixXd columns(rows.target.size(), count);
    for (Eigen::Index i = 0; i < count; ++i)
        columns.col(i) = part(candidate, rows, 0, search.list[static_cast<std::size_t>(i)]).normalized();
    search.products = columns.transpose() * columns;
    search.rhs = columns.transpose() * rows.target;
    search.best.resize(terms + 1);
    search.choose(0);
    std::vector<std::vector<double>> starts;
    for (const Search::Best& best : search.best)
        if (!best.set.empty()) starts.push_back(best.set);
    return starts;
}

}  // namespace soft::fit
