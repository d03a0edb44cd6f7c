// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit_sum.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace roomatlas::bench {
namespace {

constexpr int kFolds = 10;
constexpr int kNewtonSteps = 30;
constexpr double kPenalties[] = {0.3, 1.0, 3.0, 10.0, 30.0, 100.0};
constexpr double kMostDeviations = 3.0;  // as the library cuts figures off
constexpr double kLeastDeviation = 1e-6;
constexpr double kPlattPenalty = 1.0;  // towards taking the log odds as they are

double value_of(const std::vector<JudgedFigure>& figures, const std::string& name) {
  for (const JudgedFigure& figure : figures) {
    if (figure.name == name) return figure.value;
  }
  throw std::runtime_error("a mission has no figure called " + name);
}

double odds_of(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

using Rows = std::vector<const FitRow*>;

/// Terms with means and deviations, without weights.
FitSum scales_of(const Rows& rows) {
  FitSum sum;
  for (const JudgedFigure& figure : rows.front()->figures) {
    FitTerm term{figure.name, 0.0, 0.0, 0.0};
    double square = 0.0;
    for (const FitRow* row : rows) {
      const double value = value_of(row->figures, figure.name);
      term.mean += value / static_cast<double>(rows.size());
      square += value * value / static_cast<double>(rows.size());
    }
    term.deviation =
        std::max(kLeastDeviation, std::sqrt(std::max(0.0, square - term.mean * term.mean)));
    sum.terms.push_back(term);
  }
  return sum;
}

/// A row's standardised figures, and 1.
Eigen::VectorXd standardised(const FitSum& sum, const FitRow& row) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(sum.terms.size()) + 1);
  Eigen::Index i = 0;
  for (const FitTerm& term : sum.terms) {
    const double off = (value_of(row.figures, term.name) - term.mean) / term.deviation;
    values[i++] = std::clamp(off, -kMostDeviations, kMostDeviations);
  }
  values[i] = 1.0;
  return values;
}

/// Its weights, and its bias.
Eigen::VectorXd weights_of(const FitSum& sum) {
  Eigen::VectorXd weights(static_cast<Eigen::Index>(sum.terms.size()) + 1);
  Eigen::Index i = 0;
  for (const FitTerm& term : sum.terms) weights[i++] = term.weight;
  weights[i] = sum.bias;
  return weights;
}

/// What is fitted, but for the penalty.
struct Task {
  FitKind kind;
  const std::optional<FitSum>& known;
};

FitSum fit(const Rows& rows, const Task& task, double penalty) {
  const FitKind kind = task.kind;
  FitSum sum = task.known ? *task.known : scales_of(rows);
  const Eigen::VectorXd known = weights_of(sum);
  const auto size = static_cast<Eigen::Index>(sum.terms.size()) + 1;
  Eigen::MatrixXd all(static_cast<Eigen::Index>(rows.size()), size);
  Eigen::VectorXd target(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    all.row(static_cast<Eigen::Index>(i)) = standardised(sum, *rows[i]).transpose();
    target[static_cast<Eigen::Index>(i)] = rows[i]->target;
  }
  Eigen::VectorXd ridge = Eigen::VectorXd::Constant(size, penalty);
  ridge[size - 1] = kLeastDeviation;
  Eigen::VectorXd model = known;
  for (int step = 0; step < (kind == FitKind::log_odds ? kNewtonSteps : 1); ++step) {
    Eigen::VectorXd error = all * model;
    Eigen::VectorXd weight = Eigen::VectorXd::Ones(error.size());
    if (kind == FitKind::log_odds) {
      error = error.unaryExpr(&odds_of);
      weight = error.array() * (1.0 - error.array()) + kLeastDeviation;
    }
    error -= target;
    Eigen::MatrixXd hessian = all.transpose() * weight.asDiagonal() * all;
    hessian.diagonal() += ridge;
    const Eigen::VectorXd gradient = all.transpose() * error + ridge.cwiseProduct(model - known);
    model -= hessian.ldlt().solve(gradient);
  }
  for (std::size_t i = 0; i < sum.terms.size(); ++i) {
    sum.terms[i].weight = model[static_cast<Eigen::Index>(i)];
  }
  sum.bias = model[size - 1];
  return sum;
}

double loss_of(FitKind kind, double found, double target) {
  if (kind != FitKind::log_odds) return (found - target) * (found - target);
  return std::log1p(std::exp(target > 0.5 ? -found : found));
}

double mean_loss(FitKind kind, const std::vector<FitRow>& rows, const std::vector<double>& found) {
  double sum = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) sum += loss_of(kind, found[i], rows[i].target);
  return sum / static_cast<double>(rows.size());
}

/// Each row by a sum that its tenth of the groups had no part in.
std::vector<double> left_out(const std::vector<FitRow>& rows, const Task& task, double penalty) {
  std::vector<double> found(rows.size(), 0.0);
  for (std::size_t fold = 0; fold < kFolds; ++fold) {
    Rows others;
    for (const FitRow& row : rows) {
      if (row.group % kFolds != fold) others.push_back(&row);
    }
    if (others.empty()) continue;
    const FitSum sum = fit(others, task, penalty);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].group % kFolds == fold) found[i] = sum.at(rows[i].figures);
    }
  }
  return found;
}

/// What makes the log odds that were found the targets' own.
struct Calibration {
  double scale = 1.0;
  double shift = 0.0;
  double lapses = 0.0;
};

double probability_of(const Calibration& calibration, double found) {
  return (1.0 - calibration.lapses) * odds_of(calibration.scale * found + calibration.shift);
}

double loss_of(const Calibration& calibration, const std::vector<FitRow>& rows,
               const std::vector<double>& found) {
  double loss = kPlattPenalty / 2.0 * (calibration.scale - 1.0) * (calibration.scale - 1.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double right = probability_of(calibration, found[i]);
    loss -= std::log(rows[i].target > 0.5 ? right : 1.0 - right);
  }
  return loss;
}

/// Scale and shift under which the targets are likeliest, for a share of lapses: Fisher's scoring.
Calibration calibrated(const std::vector<FitRow>& rows, const std::vector<double>& found,
                       double lapses) {
  Calibration calibration{1.0, 0.0, lapses};
  for (int step = 0; step < kNewtonSteps; ++step) {
    Eigen::Matrix2d hessian = Eigen::Vector2d(kPlattPenalty, kLeastDeviation).asDiagonal();
    Eigen::Vector2d gradient(kPlattPenalty * (calibration.scale - 1.0), 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Eigen::Vector2d values(found[i], 1.0);
      const double right =
          std::clamp(probability_of(calibration, found[i]), kLeastDeviation, 1.0 - kLeastDeviation);
      const double slope = right * (1.0 - right / (1.0 - lapses));
      const double variance = right * (1.0 - right);
      gradient += (right - rows[i].target) * slope / variance * values;
      hessian += slope * slope / variance * values * values.transpose();
    }
    const Eigen::Vector2d move = hessian.ldlt().solve(gradient);
    calibration.scale -= move[0];
    calibration.shift -= move[1];
  }
  return calibration;
}

void calibrate(const std::vector<FitRow>& rows, FitKind kind, Fitted& fitted) {
  constexpr int kMostLapses = 20;  // hundredths
  Calibration best = calibrated(rows, fitted.left_out, 0.0);
  for (int share = 1; share <= (kind == FitKind::within_limit ? kMostLapses : 0); ++share) {
    const Calibration other = calibrated(rows, fitted.left_out, 0.01 * share);
    if (loss_of(other, rows, fitted.left_out) < loss_of(best, rows, fitted.left_out)) best = other;
  }
  for (double& value : fitted.left_out) value = best.scale * value + best.shift;
  for (FitTerm& term : fitted.sum.terms) term.weight *= best.scale;
  fitted.sum.bias = best.scale * fitted.sum.bias + best.shift;
  fitted.lapses = best.lapses;
}

/// A sum of logarithms, as log odds that 0 is not exceeded: errors are taken to be normal, and a
/// normal's tail to be a logistic one.
void as_log_odds(Fitted& fitted) {
  constexpr double kLogistic = 1.7;  // sigmas of a logistic curve that is nearest to a normal one
  const double scale = -kLogistic / std::sqrt(fitted.loss);
  for (double& value : fitted.left_out) value *= scale;
  for (FitTerm& term : fitted.sum.terms) term.weight *= scale;
  fitted.sum.bias *= scale;
}

/// Raises the sum so that `share` of the targets lie below.
void raise(const std::vector<FitRow>& rows, double share, std::vector<double>& found, FitSum& sum) {
  std::vector<double> above(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) above[i] = rows[i].target - found[i];
  std::sort(above.begin(), above.end());
  const double by =
      above[static_cast<std::size_t>(share * static_cast<double>(above.size() - 1) + 0.5)];
  for (double& value : found) value += by;
  sum.bias += by;
}

}  // namespace

double FitSum::at(const std::vector<JudgedFigure>& figures) const {
  FitRow row{figures, 0.0, 0};
  const Eigen::VectorXd values = standardised(*this, row);
  double result = bias;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    result += terms[i].weight * values[static_cast<Eigen::Index>(i)];
  }
  return result;
}

FitSum known_sum(const LearntSum& sum) {
  FitSum known{sum.bias, {}};
  known.terms.reserve(sum.terms.size());
  for (const LearntTerm& term : sum.terms) {
    known.terms.push_back({term.name, term.mean, term.deviation, term.weight});
  }
  return known;
}

Fitted fit_sum(const std::vector<FitRow>& rows, FitKind kind, const std::optional<FitSum>& known,
               double share) {
  if (rows.empty()) throw std::runtime_error("there is nothing to learn from");
  const Task task{kind, known};
  Fitted best;
  best.loss = std::numeric_limits<double>::infinity();
  for (const double penalty : kPenalties) {
    std::vector<double> found = left_out(rows, task, penalty);
    const double loss = mean_loss(kind, rows, found);
    if (loss >= best.loss) continue;
    best.loss = loss;
    best.penalty = penalty;
    best.left_out = std::move(found);
  }
  Rows all;
  for (const FitRow& row : rows) all.push_back(&row);
  best.sum = fit(all, task, best.penalty);
  if (kind == FitKind::logarithm) {
    raise(rows, share, best.left_out, best.sum);
  } else if (kind == FitKind::within_limit) {
    as_log_odds(best);
    const std::vector<FitRow> told = whether_within(rows);
    calibrate(told, kind, best);
    best.loss = mean_loss(FitKind::log_odds, told, best.left_out);
  } else {
    calibrate(rows, kind, best);
  }
  return best;
}

std::vector<FitRow> whether_within(std::vector<FitRow> rows) {
  for (FitRow& row : rows) row.target = row.target <= 0.0 ? 1.0 : 0.0;
  return rows;
}

std::string given_text(const std::vector<FitRow>& rows, const Fitted& fitted) {
  std::string text;
  for (const double least : {0.5, 0.8, 0.9, 0.92, 0.95, 0.99}) {
    int given = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if ((1.0 - fitted.lapses) * odds_of(fitted.left_out[i]) < least) continue;
      ++given;
      wrong += rows[i].target < 0.5 ? 1 : 0;
    }
    text += "  given " + number_text(least) + ": " + std::to_string(given) + " of " +
            std::to_string(rows.size()) + ", " + std::to_string(wrong) + " wrong\n";
  }
  return text;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  std::string number = text;
  if (number.find_first_of(".e") == std::string::npos) number += ".0";
  return number;
}

std::string terms_text(const std::string& name, const FitSum& sum) {
  std::string text = "  static constexpr LearntTerm " + name + "[] = {\n";
  for (const FitTerm& term : sum.terms) {
    text += "      {\"" + term.name + "\", " + number_text(term.mean) + ", " +
            number_text(term.deviation) + ", " + number_text(term.weight) + "},\n";
  }
  return text + "  };\n";
}

}  // namespace roomatlas::bench
