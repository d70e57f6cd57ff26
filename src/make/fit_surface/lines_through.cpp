#include <Eigen/LU>
#include <algorithm>
#include <string>

#include "batten/base/error.hpp"
#include "batten/base/text.hpp"
#include "batten/make/fit_front.hpp"
#include "batten/shape/basis.hpp"

namespace batten {

std::vector<SplineFunction> lines_through(const Points& rows) {
    const std::size_t n = rows.size();
    if (n == 0 || rows.dim() < 2) {
        throw Error("surface.lines", "lines", std::to_string(n) + " rows",
                    "rows y, X_1, X_2, … are needed");
    }
    std::vector<double> y;
    for (std::size_t i = 0; i < n; ++i) {
        y.push_back(rows(i, 0));
        if (i == 0 || y[i - 1] < y[i]) continue;
        throw Error("surface.lines", "row " + std::to_string(i), format_number(y[i]),
                    "the rows of knot lines rise in y");
    }
    if (n == 1) throw Error("surface.lines", "lines", "one row", "at least two rows are needed");
    // Not-a-knot: the second and the last but one place are no knots.
    const int degree = static_cast<int>(std::min<std::size_t>(3, n - 1));
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, y.front());
    for (std::size_t i = 2; degree == 3 && i + 2 < n; ++i) knots.push_back(y[i]);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, y.back());
    const BSplineBasis basis(knots, degree);
    const int size = static_cast<int>(n);
    Eigen::MatrixXd values = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < size; ++i) {
        double local[4];
        basis.nonzero(y[static_cast<std::size_t>(i)], 0, local);
        const int first = static_cast<int>(basis.span_of(y[static_cast<std::size_t>(i)])) - degree;
        for (int j = 0; j <= degree; ++j) values(i, first + j) = local[j];
    }
    const Eigen::PartialPivLU<Eigen::MatrixXd> solver(values);
    std::vector<SplineFunction> lines;
    for (int k = 1; k < rows.dim(); ++k) {
        Eigen::VectorXd places(size);
        for (int i = 0; i < size; ++i) places[i] = rows(static_cast<std::size_t>(i), k);
        const Eigen::VectorXd c = solver.solve(places);
        lines.emplace_back(knots, std::vector<double>(c.data(), c.data() + size), degree);
    }
    return lines;
}

}  // namespace batten
